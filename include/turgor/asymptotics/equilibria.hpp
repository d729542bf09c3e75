#pragma once
// The paper's closed approximations of the equilibria of a Mooney-Rivlin balloon: (3.3), (3.5).

#include "turgor/asymptotics/free_motion.hpp"

namespace turgor {

/// The small stable equilibrium by (3.3), R = 1 + delta + delta^2, with the minus sign and without its 0/0:
/// delta = 2 P0/(6(S1+S2) - 7 P0 + sqrt(36(S1+S2)^2 + 48 P0 S2 - 63 P0^2)).
///
/// Error O(delta^3): 3e-4 at R = 1.035 and 0.03 next to the limit point, for S1/S2 = 10. Negative pressures are
/// allowed.
/// @param pressure  gauge pressure [Pa]
/// @return          R; the error is measured by the static pressure (3.1) there and its first two derivatives
/// @throws InvalidInput for material.model unless it is mooney-rivlin; for `pressure` when it is not below the maximum
/// of
///         (3.1), where the formula stays real but the equilibrium is gone, or the root is complex
struct SmallEquilibrium {
  double delta;
  Estimate stretch;
};
[[nodiscard]] SmallEquilibrium small_equilibrium(const Parameters<double>& p, double pressure);

/// The large stable equilibrium by (3.5), R = [P0 + sqrt(P0^2 - 4 S1 S2)]/(2 S2); error O(R^-5).
///
/// Complex, hence refused, for pressures below 2 sqrt(S1 S2), although the equilibrium exists down to the minimum of
/// (3.1); for S1/S2 < 5.179 that is all of the range with two stable equilibria.
/// @throws InvalidInput for material.model unless it is mooney-rivlin with s2 > 0; for `pressure` below 2 sqrt(S1 S2)
[[nodiscard]] Estimate large_equilibrium(const Parameters<double>& p, double pressure);

}  // namespace turgor
