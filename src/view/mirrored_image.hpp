#pragma once
// Values over the meridional plane as an image, with its mirror image at the axis.

#include <string>
#include <vector>

namespace turgor {

/// Pixels of a picture on the meridional plane, right of the axis.
struct Pixels {
  std::string name;  ///< of gnuplot's data block
  double size;       ///< of a pixel
  double bottom;     ///< height of the lowest edge
  int columns;
  int rows;
};

/// A data block of values at the middles of the pixels and of their mirror images. The places of columns and rows are
/// in it, because formulas for them in the plot take gnuplot three times as long.
/// @param values  in rows from the bottom, from the axis outwards; NaN: nothing is shown
/// @param length  of a unit of the pixels' places, in that of the picture's axes
[[nodiscard]] std::string image_block(const Pixels& pixels, const std::vector<double>& values, double length);

/// What shows it; after the word "plot".
[[nodiscard]] std::string image_plot(const Pixels& pixels);

}  // namespace turgor
