#pragma once
// Flow closures: how hard the liquid in the balloon resists being pressed out through the orifice.

#include <array>
#include <numbers>
#include <string_view>

#include "turgor/base/power.hpp"
#include "turgor/base/regime.hpp"
#include "turgor/flow/flow_state.hpp"

namespace turgor {

/// Which set of constants stands for the potential flow in the balloon during deflation.
enum class Closure {
  theoretical,  ///< uniform outflow, eq. (2.12)
  corrected,    ///< the paper's numerically observed outflow profile, eq. (2.15)
};

/// All of them, in the order in which results list them.
inline constexpr std::array all_closures{Closure::theoretical, Closure::corrected};

/// The two numbers that a closure contributes to eq. (2.22) during deflation (during inflation the jet leaves the
/// pressure in the balloon uniform, section 2.2, and both are zero).
template <class T>
struct ClosureConstants {
  T inertial;     ///< coefficient of R^4 d2R/dT2 in the first bracket of (2.22) [1]
  T centripetal;  ///< coefficient of R^6 (dR/dT)^2 on its right-hand side, times (r_ch/r0)^3 [1]
};

/// Constants of a closure as they enter (2.22): 223/(32 pi) and 75/(4 pi) for (2.15), 9 sqrt2/(2 pi) and 12/pi for
/// (2.12).
template <class T>
[[nodiscard]] ClosureConstants<T> constants(Closure closure) {
  constexpr T pi = std::numbers::pi_v<T>;
  if (closure == Closure::theoretical) return {9 * std::numbers::sqrt2_v<T> / (2 * pi), 12 / pi};
  return {T(223) / (32 * pi), T(75) / (4 * pi)};
}

/// The terms of the generalized force [N].
template <class T>
struct ForceParts {
  T statics;              ///< 4 pi r^2 p_ext
  T channel_inertial;     ///< with L_ch and d2r/dt2
  T channel_centripetal;  ///< with L_ch and (dr/dt)^2
  T balloon_inertial;     ///< with d2r/dt2; 0 unless deflating
  T balloon_centripetal;  ///< with (dr/dt)^2; 0 unless deflating

  [[nodiscard]] T sum() const {
    return statics + channel_inertial + channel_centripetal + balloon_inertial + balloon_centripetal;
  }
};

/// Generalized force of the liquid on the extensional mode, term by term: eq. (2.12) or (2.15); (2.11) is (2.12) in
/// deflation.
/// @param regime  taken from the caller, since the sign of dr/dt says nothing at the instant it is zero
template <class T>
[[nodiscard]] ForceParts<T> force_parts(Closure closure, Regime regime, const FlowState<T>& s) {
  constexpr T pi = std::numbers::pi_v<T>;
  const bool deflating = regime == Regime::deflating;
  const ClosureConstants<T> c = constants<T>(closure);
  const T inertial = deflating ? 2 * pi * c.inertial : T(0);  // 9 sqrt2 or 223/16 of the bracket in (2.12), (2.15)
  const T centripetal = deflating ? pi * c.centripetal / 4 : T(0);  // 3 or 75/16
  const T r3 = power<3>(s.radius);
  const T acceleration = 4 * s.fluid_density / s.orifice_radius * r3 * s.radius * s.radial_accel;
  const T velocity = 32 * s.fluid_density / power<2>(s.orifice_radius) * r3 * power<2>(s.radial_rate);
  return {4 * pi * s.radius * s.radius * s.inlet_pressure,
          -acceleration * (4 * pi * s.channel_length / s.orifice_radius), -velocity * (pi * s.channel_length),
          -acceleration * inertial, velocity * (centripetal * r3 / power<2>(s.orifice_radius))};
}

/// Generalized force of the liquid on the extensional mode [N]: the sum of its parts.
template <class T>
[[nodiscard]] T generalized_force(Closure closure, Regime regime, const FlowState<T>& s) {
  return force_parts(closure, regime, s).sum();
}

}  // namespace turgor
