#pragma once
// The speed of a computed flow as an image.

#include <array>
#include <string>
#include <vector>

#include "turgor/run/vtu.hpp"

namespace turgor {

/// Pixels of a picture on the meridional plane, right of the axis.
struct Pixels {
  std::string name;  ///< of gnuplot's data block
  double size;       ///< of a pixel [m]
  double bottom;     ///< height of the lowest edge [m]
  int columns;
  int rows;
};

/// sqrt(u_r^2 + u_z^2) at the points [m/s].
/// @param velocity  three components for each
[[nodiscard]] std::vector<double> speeds(const std::vector<double>& velocity);

/// A data block of speeds [m/s] at the middles of the pixels, in rows from the bottom, NaN outside of the liquid.
/// @param triangles  node_triangles() of the grid
/// @param speed      at its points
[[nodiscard]] std::string speed_block(const VtuGrid& grid, const std::vector<std::array<std::size_t, 3>>& triangles,
                                      const std::vector<double>& speed, const Pixels& pixels);

/// What `plot` shows it by, and its mirror image at the axis; after the word "plot".
/// @param length  of a metre, in the unit of the picture's axes
[[nodiscard]] std::string speed_plots(const Pixels& pixels, double length);

/// Commands for the colours of speeds, over three decades.
[[nodiscard]] std::string speed_colours(double fastest);

}  // namespace turgor
