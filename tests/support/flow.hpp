#pragma once
// The Legendre series of the flow, summed as it stands, and fractions as the reference file writes them.

#include <cmath>
#include <string>

#include "turgor/flow/harmonics.hpp"
#include "turgor/flow/potential_flow.hpp"

namespace turgor::test {

/// "1/200" or "0.1".
[[nodiscard]] inline double fraction(const std::string& text) {
  const std::size_t slash = text.find('/');
  const double top = std::stod(text.substr(0, slash));
  return slash == std::string::npos ? top : top / std::stod(text.substr(slash + 1));
}

/// (2.6) and its derivatives, at r = 1 too, the sum being finite.
[[nodiscard]] inline FlowField series(const Harmonics& a, double r, double theta) {
  FlowField sum{};
  const double x = std::cos(theta);
  double p = 1;      // P_{m-1}
  double next = x;   // P_m
  double slope = 1;  // P_m'
  double power = 1;  // r^(m-1)
  const double sine = std::sin(theta);
  for (int m = 1; m <= a.count(); ++m) {
    const auto i = static_cast<std::size_t>(m - 1);
    sum.potential += a.amplitude[i] / (2 * m) * power * r * next;
    sum.potential_change += a.change[i] / (2 * m) * power * r * next;
    sum.radial += a.amplitude[i] / 2 * power * next;
    sum.tangential -= a.amplitude[i] / (2 * m) * power * slope * sine;
    const double after = ((2 * m + 1) * x * next - m * p) / (m + 1);
    slope = x * slope + (m + 1) * next;
    p = next;
    next = after;
    power *= r;
  }
  return sum;
}

}  // namespace turgor::test
