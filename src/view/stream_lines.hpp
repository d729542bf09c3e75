#pragma once
// Streamlines of a computed axisymmetric flow.

#include <array>
#include <cstddef>
#include <vector>

#include "turgor/run/vtu.hpp"

namespace turgor {

/// Triangles between the nodes of biquadratic cells, eight for each.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> node_triangles(const VtuGrid& grid);

/// Stokes' stream function at the points [m^3/s over 2 pi]: zero on the axis, the flux through a circle about it. By
/// least squares over all sides of the triangles, since a computed flow is solenoidal only on the average.
/// @param velocity  three components per point [m/s]
[[nodiscard]] std::vector<double> stream_function(const VtuGrid& grid, const std::vector<double>& velocity);

using PlanePoint = std::array<double, 2>;
/// Lines of a level of a function that is linear on the triangles between the points.
[[nodiscard]] std::vector<std::vector<PlanePoint>> contour(const VtuGrid& grid,
                                                           const std::vector<std::array<std::size_t, 3>>& triangles,
                                                           const std::vector<double>& function, double level);

}  // namespace turgor
