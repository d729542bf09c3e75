#include "spacing.hpp"

#include <algorithm>
#include <cmath>

namespace turgor {

namespace {

/// Places in a row, and the integral of dx/size from the first of them.
struct StepIntegral {
  std::vector<double> places;
  std::vector<double> sums;
};

/// By the midpoint rule, in a fixed share of the local size.
StepIntegral step_integral(double from, double to, const SizeAlong& size) {
  constexpr double share = 1.0 / 32;
  StepIntegral integral{{from}, {0}};
  while (integral.places.back() < to) {
    const double x = integral.places.back();
    const double next = std::min(to, x + share * size(x));
    integral.sums.push_back(integral.sums.back() + (next - x) / size((x + next) / 2));
    integral.places.push_back(next);
  }
  return integral;
}

}  // namespace

std::size_t steps(double from, double to, const SizeAlong& size) {
  return static_cast<std::size_t>(std::max(1.0, std::round(step_integral(from, to, size).sums.back())));
}

std::vector<double> spaced(double from, double to, std::size_t steps, const SizeAlong& size) {
  const auto [samples, sums] = step_integral(from, to, size);
  std::vector<double> places{from};
  std::size_t i = 0;
  for (std::size_t k = 1; k < steps; ++k) {
    const double wanted = sums.back() * static_cast<double>(k) / static_cast<double>(steps);
    while (sums[i + 1] < wanted) ++i;
    places.push_back(std::lerp(samples[i], samples[i + 1], (wanted - sums[i]) / (sums[i + 1] - sums[i])));
  }
  places.push_back(to);
  return places;
}

}  // namespace turgor
