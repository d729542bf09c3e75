#include "speed_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gnuplot.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr double decades = 3;

/// Paints a triangle, the speed linear on it.
void paint(const VtuGrid& grid, const std::array<std::size_t, 3>& t, const std::vector<double>& speed,
           const Pixels& pixels, std::vector<double>& values) {
  std::array<double, 3> x{};
  std::array<double, 3> y{};
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = grid.points[3 * t[k]] / pixels.size - 0.5;
    y[k] = (grid.points[3 * t[k] + 1] - pixels.bottom) / pixels.size - 0.5;
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  const auto clipped = [](double value, int most) { return static_cast<int>(std::clamp(value, 0.0, most - 1.0)); };
  const auto [left, right] = std::ranges::minmax(x);
  const auto [low, high] = std::ranges::minmax(y);
  if (right < 0 || high < 0 || left > pixels.columns || low > pixels.rows) return;
  for (int j = clipped(std::ceil(low), pixels.rows); j <= clipped(std::floor(high), pixels.rows); ++j) {
    for (int i = clipped(std::ceil(left), pixels.columns); i <= clipped(std::floor(right), pixels.columns); ++i) {
      const double b = ((i - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (j - y[0])) / area;
      const double c = ((x[1] - x[0]) * (j - y[0]) - (i - x[0]) * (y[1] - y[0])) / area;
      constexpr double edge = -1e-9;  // a pixel on a side belongs to either triangle
      if (b < edge || c < edge || b + c > 1 - edge) continue;
      values[static_cast<std::size_t>(j) * static_cast<std::size_t>(pixels.columns) + static_cast<std::size_t>(i)] =
          (1 - b - c) * speed[t[0]] + b * speed[t[1]] + c * speed[t[2]];
    }
  }
}

}  // namespace

std::vector<double> speeds(const std::vector<double>& velocity) {
  std::vector<double> all;
  all.reserve(velocity.size() / 3);
  for (std::size_t i = 0; i < velocity.size(); i += 3) all.push_back(std::hypot(velocity[i], velocity[i + 1]));
  return all;
}

std::vector<double> speed_image(const VtuGrid& grid, const std::vector<std::array<std::size_t, 3>>& triangles,
                                const std::vector<double>& speed, const Pixels& pixels) {
  std::vector<double> values(static_cast<std::size_t>(pixels.columns) * static_cast<std::size_t>(pixels.rows),
                             std::numeric_limits<double>::quiet_NaN());
  for (const auto& t : triangles) paint(grid, t, speed, pixels, values);
  return values;
}

std::string speed_colours(double fastest) {
  return viridis_palette() + "set logscale cb\nset format cb '%g'\nset cbrange [" +
         rounded(fastest / std::pow(10, decades), 4) + ":" + rounded(fastest, 4) + "]\n";
}

}  // namespace turgor
