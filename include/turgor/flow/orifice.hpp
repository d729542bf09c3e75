#pragma once
// The sphere and the circular orifice in it, in units of the balloon's radius r.

#include <cmath>

namespace turgor {

/// eps = 1 - sqrt(1 - kappa^2) of (2.1): depth of the cap that the sphere would have beyond the orifice, over r.
/// Without cancellation for small kappa.
/// @param kappa  r_ch/r, 0 < kappa < 1
template <class T>
[[nodiscard]] T cap_depth(const T& kappa) {
  using std::sqrt;
  return kappa * kappa / (T(1) + sqrt(T(1) - kappa * kappa));
}

/// Speed in the channel over dr/dt, (2.1).
template <class T>
[[nodiscard]] T channel_speed(const T& eps) {
  return (T(2) - eps) / (eps * (T(1) - eps));
}

}  // namespace turgor
