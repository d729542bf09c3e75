#include "block_builder.hpp"

namespace turgor {

std::size_t BlockBuilder::add(const Place& place) {
  points_.push_back({place.real(), place.imag()});
  return points_.size() - 1;
}

void BlockBuilder::strip(const Line& south, const Line& north) {
  for (std::size_t i = 0; i + 1 < south.size(); ++i) {
    cells_.push_back({south[i], south[i + 1], north[i + 1], north[i]});
  }
}

void BlockBuilder::fill(const Line& south, const Line& east, const Line& north, const Line& west) {
  const std::size_t columns = south.size() - 1;
  const std::size_t rows = west.size() - 1;
  Line below = south;
  for (std::size_t j = 1; j <= rows; ++j) {
    Line row = north;
    for (std::size_t i = 1; j < rows && i < columns; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(columns);
      const double y = static_cast<double>(j) / static_cast<double>(rows);
      const Place sides =
          (1 - y) * place_on(south, i) + y * place_on(north, i) + (1 - x) * place_on(west, j) + x * place_on(east, j);
      const Place corners = (1 - y) * ((1 - x) * place(south.front()) + x * place(south.back())) +
                            y * ((1 - x) * place(north.front()) + x * place(north.back()));
      row[i] = add(sides - corners);
    }
    row.front() = west[j];
    row.back() = east[j];
    strip(below, row);
    below = row;
  }
}

}  // namespace turgor
