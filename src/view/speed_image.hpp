#pragma once
// The speed of a computed flow as an image.

#include <array>
#include <string>
#include <vector>

#include "mirrored_image.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor {

/// sqrt(u_r^2 + u_z^2) at the points [m/s].
/// @param velocity  three components for each
[[nodiscard]] std::vector<double> speeds(const std::vector<double>& velocity);

/// Speeds [m/s] at the middles of the pixels, as image_block() takes them, NaN outside of the liquid.
/// @param triangles  node_triangles() of the grid
/// @param speed      at its points
/// @param pixels     places [m]
[[nodiscard]] std::vector<double> speed_image(const VtuGrid& grid,
                                              const std::vector<std::array<std::size_t, 3>>& triangles,
                                              const std::vector<double>& speed, const Pixels& pixels);

/// Commands for the colours of speeds, over three decades.
[[nodiscard]] std::string speed_colours(double fastest);

}  // namespace turgor
