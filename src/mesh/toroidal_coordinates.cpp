#include "turgor/mesh/toroidal_coordinates.hpp"

#include <cmath>
#include <numbers>

namespace turgor {

// exp(-tau) = |a - x| / |a + x| for x = distance + i height, and 1 - exp(-2 tau) = 4 a distance / |a + x|^2: no
// difference of nearly equal numbers on the axis, at the rim or far away.
ToroidalCoordinates toroidal_coordinates(std::array<double, 2> place, double a) {
  const auto [r, z] = place;
  const double far = std::hypot(r + a, z);
  const double ratio = std::hypot(r - a, z) / far;
  const double gap = 4 * a * r / (far * far) / (1 + ratio);
  const double along = (r - a) * (r + a) + z * z;
  const bool under = z < 0 && along < 0;  // below the orifice
  const double sigma = std::atan2(2 * a * z, along);
  constexpr double pi = std::numbers::pi;
  return {.tau = gap < 0.5 ? -std::log1p(-gap) : -std::log(ratio),
          .sigma = under ? sigma + 2 * pi : sigma,
          .rest = z < 0 && !under ? pi - sigma : std::atan2(2 * a * z, -along)};
}

std::array<double, 2> toroidal_place(const ToroidalCoordinates& at, double a) {
  constexpr double pi = std::numbers::pi;
  const double ratio = std::exp(-at.tau);
  const double gap = -std::expm1(-at.tau);
  const double half = std::sin(at.sigma / 2);
  const double denominator = gap * gap + 4 * ratio * half * half;
  const double sine = std::abs(at.rest) < pi / 2 ? std::sin(at.rest) : std::sin(at.sigma);
  return {a * gap * (1 + ratio) / denominator, 2 * a * ratio * sine / denominator};
}

}  // namespace turgor
