#include "spacing.hpp"

#include <algorithm>
#include <cmath>

namespace turgor {

namespace {

constexpr std::size_t samples = 2000;

/// Integral of dx/size from `from` to each of the equidistant samples, by the midpoint rule.
std::vector<double> step_integral(double from, double to, const SizeAlong& size) {
  const double width = (to - from) / static_cast<double>(samples);
  std::vector<double> sum{0};
  for (std::size_t i = 0; i < samples; ++i) {
    sum.push_back(sum.back() + width / size(from + (static_cast<double>(i) + 0.5) * width));
  }
  return sum;
}

}  // namespace

std::size_t steps(double from, double to, const SizeAlong& size) {
  return static_cast<std::size_t>(std::max(1.0, std::round(step_integral(from, to, size).back())));
}

std::vector<double> spaced(double from, double to, std::size_t steps, const SizeAlong& size) {
  const std::vector<double> sum = step_integral(from, to, size);
  std::vector<double> places{from};
  std::size_t i = 0;
  for (std::size_t k = 1; k < steps; ++k) {
    const double wanted = sum.back() * static_cast<double>(k) / static_cast<double>(steps);
    while (sum[i + 1] < wanted) ++i;
    const double share = (wanted - sum[i]) / (sum[i + 1] - sum[i]);
    places.push_back(from + (to - from) * (static_cast<double>(i) + share) / static_cast<double>(samples));
  }
  places.push_back(to);
  return places;
}

}  // namespace turgor
