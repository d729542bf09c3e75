#pragma once
// The stress-free membrane: a surface of revolution by its meridian, a chain of quadratic elements.

#include <array>
#include <cstddef>
#include <vector>

namespace turgor {

/// Nodes (distance r from the axis, height z) [m] in order along the meridian. Element e has the nodes 2e, 2e+1, 2e+2,
/// at -1, 0, 1 of its parameter. One end lies on the axis; the other one is the rim, or on the axis too (a closed
/// surface). Either end may come first.
struct Meridian {
  std::vector<std::array<double, 2>> nodes;

  [[nodiscard]] std::size_t elements() const { return nodes.size() / 2; }
};

/// The part above z = 0 of the sphere through the rim (rim_radius, 0), from the rim to the axis; elements are uniform
/// in angle, or grow by a constant factor. Without a rim the closed sphere about (0, radius), from pole to pole.
/// @param radius      of the sphere [m], > 0
/// @param rim_radius  of the hole [m], 0 for none, less than the sphere's
/// @param elements    at least 1
/// @param growth      length of the last element over that of the first, > 0
/// @throws InvalidInput naming balloon.radius, inlet.orifice_radius, membrane.elements or membrane.growth
[[nodiscard]] Meridian spherical_meridian(double radius, double rim_radius, std::size_t elements, double growth = 1);

}  // namespace turgor
