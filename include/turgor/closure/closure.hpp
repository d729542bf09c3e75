#pragma once
// Flow closures: how hard the liquid in the balloon resists being pressed out through the orifice.

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "turgor/base/power.hpp"
#include "turgor/base/regime.hpp"
#include "turgor/flow/flow_state.hpp"
#include "turgor/flow/force_table.hpp"

namespace turgor {

/// What stands for the potential flow in the balloon during deflation.
enum class Closure {
  theoretical,  ///< uniform outflow, small orifice: eq. (2.12)
  corrected,    ///< the paper's numerically observed outflow profile, small orifice: eq. (2.15)
  potential,    ///< uniform outflow, any orifice: eq. (2.8) itself
  profile,      ///< another outflow profile, any orifice: (2.8) with the coefficients of (2.14)
  calibrated,   ///< (2.8) with coefficients fitted to finite elements: closure/calibration.hpp
};

/// All of them, in the order in which results list them.
inline constexpr std::array all_closures{Closure::theoretical, Closure::corrected, Closure::potential, Closure::profile,
                                         Closure::calibrated};

/// Whether a closure has the form of (2.8), coefficients that depend on r_ch/r, in place of the small-orifice form.
[[nodiscard]] constexpr bool has_table(Closure closure) {
  return closure == Closure::potential || closure == Closure::profile || closure == Closure::calibrated;
}

/// The two numbers that a closure contributes to eq. (2.22) during deflation (during inflation the jet leaves the
/// pressure in the balloon uniform, section 2.2, and both are zero).
template <class T>
struct ClosureConstants {
  T inertial;     ///< coefficient of R^4 d2R/dT2 in the first bracket of (2.22) [1]
  T centripetal;  ///< coefficient of R^6 (dR/dT)^2 on its right-hand side, times (r_ch/r0)^3 [1]
};

/// Constants of a closure as they enter (2.22): 223/(32 pi) and 75/(4 pi) for (2.15), 9 sqrt2/(2 pi) and 12/pi for
/// (2.12); 2 and 4 for (2.8), where ExactFactors multiply them.
template <class T>
[[nodiscard]] ClosureConstants<T> constants(Closure closure) {
  constexpr T pi = std::numbers::pi_v<T>;
  if (has_table(closure)) return {T(2), T(4)};
  if (closure == Closure::theoretical) return {9 * std::numbers::sqrt2_v<T> / (2 * pi), 12 / pi};
  return {T(223) / (32 * pi), T(75) / (4 * pi)};
}

/// The elementary ones among the coefficients of (2.8), over their leading terms, eqs. (2.9a,b,c) with eps = kappa^2/2:
/// h1 = g1/(4 pi), h2 = kappa^2 g2/(16 pi), h4 = -kappa^2 g4/(32 pi). All are 1 at kappa = 0. With
/// rho = 1 - eps = sqrt(1 - kappa^2) they are (1+rho)/2, (1+rho)^3/(8 rho) and (1+rho)^3 (rho^2+2 rho-1)/(16 rho^3).
template <class V>
struct ChannelFactors {
  V area, area_slope;                ///< h1, dh1/dkappa
  V inertial, inertial_slope;        ///< h2, dh2/dkappa
  V centripetal, centripetal_slope;  ///< h4, dh4/dkappa
};

/// @param kappa  r_ch/r; not a number for kappa > 1
template <class V>
[[nodiscard]] ChannelFactors<V> channel_factors(const V& kappa) {
  using std::sqrt;
  const V one(1);
  const V rho = sqrt((one - kappa) * (one + kappa));
  const V per_rho = one / rho;
  const V rho_slope = -kappa * per_rho;
  const V sum = one + rho;
  const V square = V(0.125) * sum * sum * per_rho;  // h2 = square sum
  const V share = V(0.5) * per_rho * per_rho;       // h4 = h2 share bend
  const V bend = rho * (rho + V(2)) - one;
  return {V(0.5) * sum,
          V(0.5) * rho_slope,
          square * sum,
          square * per_rho * (V(2) * rho - one) * rho_slope,
          square * sum * share * bend,
          square * share * per_rho * (rho * (rho * (V(2) * rho + one) - V(4)) + V(3)) * rho_slope};
}

/// All of them.
template <class V>
struct ExactFactors {
  ChannelFactors<V> channel;
  ForceFactors<V> liquid;  ///< h3 and h5
};

/// The table of a closure: a null pointer for (2.12) and (2.15).
/// @param channel  whether there is one, which Closure::calibrated depends on
/// @param outflow  the table of Closure::profile
/// @throws InvalidInput for Closure::profile without one
[[nodiscard]] const ForceTable* force_table(Closure closure, bool channel, const ForceTable* outflow = nullptr);

/// The terms of the generalized force [N].
template <class T>
struct ForceParts {
  T statics;              ///< 4 pi r^2 p_ext, or g1 r^2 p_ext
  T channel_inertial;     ///< with L_ch and d2r/dt2
  T channel_centripetal;  ///< with L_ch and (dr/dt)^2
  T balloon_inertial;     ///< with d2r/dt2; 0 unless deflating
  T balloon_centripetal;  ///< with (dr/dt)^2; 0 unless deflating

  [[nodiscard]] T sum() const {
    return statics + channel_inertial + channel_centripetal + balloon_inertial + balloon_centripetal;
  }
};

/// Generalized force of the liquid on the extensional mode, term by term: (2.8) in deflation, and its part without g3
/// and g5 in inflation, where the pressure (2.3) at the channel's end is that in the balloon.
/// @param table   of g3 and g5; not a number where its range of r_ch/r ends
/// @param regime  taken from the caller, since the sign of dr/dt says nothing at the instant it is zero
template <class T>
[[nodiscard]] ForceParts<T> force_parts(const ForceTable& table, Regime regime, const FlowState<T>& s) {
  constexpr T pi = std::numbers::pi_v<T>;
  const T kappa = s.orifice_radius / s.radius;
  const T kappa2 = kappa * kappa;
  const ChannelFactors<T> h = channel_factors(kappa);
  const T acceleration = s.fluid_density * s.radius * s.radius * s.radial_accel;
  const T velocity = s.fluid_density * s.radius * power<2>(s.radial_rate);
  ForceParts<T> parts{4 * pi * h.area * s.radius * s.radius * s.inlet_pressure,
                      -acceleration * s.channel_length * 16 * pi * h.inertial / kappa2,
                      -velocity * s.channel_length * 32 * pi * h.centripetal / kappa2, T(0), T(0)};
  if (regime == Regime::deflating) {
    const ForceFactors<T> liquid = table.at(kappa);
    parts.balloon_inertial = -acceleration * s.radius * 16 * pi * liquid.inertial / kappa;
    parts.balloon_centripetal = velocity * s.radius * 32 * pi * liquid.centripetal / (kappa2 * kappa2);
  }
  return parts;
}

/// The same for any closure: eqs. (2.12), (2.15) or (2.8); (2.11) is (2.12) in deflation.
/// @param outflow  the table of Closure::profile
/// @throws InvalidInput for Closure::profile without one
template <class T>
[[nodiscard]] ForceParts<T> force_parts(Closure closure, Regime regime, const FlowState<T>& s,
                                        const ForceTable* outflow = nullptr) {
  if (has_table(closure)) return force_parts(*force_table(closure, s.channel_length > 0, outflow), regime, s);
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
[[nodiscard]] T generalized_force(Closure closure, Regime regime, const FlowState<T>& s,
                                  const ForceTable* outflow = nullptr) {
  return force_parts(closure, regime, s, outflow).sum();
}

}  // namespace turgor
