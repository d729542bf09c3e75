#pragma once
// Backward differentiation formulas with variable steps.

#include <array>

#include "turgor/case/case.hpp"

namespace turgor {

/// du/dt at the end of a step = rate[0] u(t) + rate[1] u(t - dt) + rate[2] u(t - dt - previous), all [1/s].
struct DifferenceFormula {
  std::array<double, 3> rate;
};
/// @param dt        step [s]
/// @param previous  the step before [s]; of no meaning to bdf1
[[nodiscard]] constexpr DifferenceFormula difference_formula(FemScheme scheme, double dt, double previous) {
  if (scheme == FemScheme::bdf1) return {{1 / dt, -1 / dt, 0}};
  const double w = dt / previous;
  return {{(1 + 2 * w) / (1 + w) / dt, -(1 + w) / dt, w * w / (1 + w) / dt}};
}

}  // namespace turgor
