#include "mirrored_image.hpp"

#include <cmath>

#include "turgor/base/text.hpp"

namespace turgor {

std::string image_block(const Pixels& pixels, const std::vector<double>& values, double length) {
  const double step = length * pixels.size;
  const auto columns = static_cast<std::size_t>(pixels.columns);
  std::string out = "$" + pixels.name + " << EOD\n" + std::to_string(2 * pixels.columns);
  for (int i = -pixels.columns; i < pixels.columns; ++i) out += " " + rounded((i + 0.5) * step, 7);
  std::vector<std::string> row(columns);
  for (int j = 0; j < pixels.rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double value = values[static_cast<std::size_t>(j) * columns + i];
      row[i] = std::isnan(value) ? " NaN" : " " + rounded(value, 5);
    }
    out += "\n" + rounded(length * pixels.bottom + (j + 0.5) * step, 7);
    for (std::size_t i = columns; i-- > 0;) out += row[i];
    for (const std::string& text : row) out += text;
  }
  return out + "\nEOD\n";
}

std::string image_plot(const Pixels& pixels) { return "$" + pixels.name + " nonuniform matrix with image"; }

}  // namespace turgor
