#pragma once
// The paper's balloon with the constants of (2.23) or (2.25) given, and its exact motion.

#include <cmath>

#include "../support/balloons.hpp"
#include "turgor/asymptotics/free_motion.hpp"
#include "turgor/integrate/quadrature.hpp"

namespace turgor::test {

inline constexpr double middle_pressure = 6.885600133745794;  ///< P0 of section 3.3, for S1 = 10, S2 = 1
inline constexpr double large_equilibrium_stretch = 4.804989785515669;
inline constexpr double small_equilibrium_stretch = 1.2582010333829832;

/// Scales on which S1 = 10, S2 = 1 and C1 has a given value.
template <class T>
[[nodiscard]] Scales<T> scales_with(Model model, const Parameters<T>& p, const T& C1) {
  const T pressure = 4 * p.thickness * T(150000) / p.radius;
  const Groups<T> g = groups(p, {p.radius, pressure, T(1)});
  using std::sqrt;
  return {p.radius, pressure, sqrt(C1 / (model == Model::orifice ? g.C1 : g.C1_long))};
}

/// (2.23) with given C1 and C2, by way of the orifice.
template <class T = double>
[[nodiscard]] Oscillator<T> orifice_balloon(const T& C1, const T& C2, const T& P = T(middle_pressure)) {
  using std::cbrt;
  auto p = paper_balloon<T>(T(3) / 10 * cbrt(T(600) / (223 * C2)), T(0));
  const Scales<T> scales = scales_with(Model::orifice, p, C1);
  return {Model::orifice, p, constant_pressure<T>(P * scales.pressure), scales};
}

/// (2.25) with given C1~ and C2~: r_ch = 3 cm, by way of the channel's length.
template <class T = double>
[[nodiscard]] Oscillator<T> channel_balloon(const T& C1, const T& C2, const T& P = T(middle_pressure)) {
  const T r0 = T(3) / 10;
  const T orifice = T(3) / 100;
  auto p = paper_balloon<T>(orifice, 75 * r0 * r0 * r0 / (8 * std::numbers::pi_v<T> * orifice * orifice * C2));
  const Scales<T> scales = scales_with(Model::long_channel, p, C1);
  return {Model::long_channel, p, constant_pressure<T>(P * scales.pressure), scales};
}

/// Exact motion from rest.
template <class T>
[[nodiscard]] Trajectory<T> exact(const Oscillator<T>& oscillator, const T& start, const T& end, long events = 0) {
  SimulationOptions<T> options;
  options.rtol = options.atol = T(1e-10);
  options.max_events = events;
  return simulate_by_quadrature(oscillator, T(0), start, T(0), end, options);
}

/// R(T) of it; the end of a trajectory is exact, without interpolation.
template <class T>
[[nodiscard]] double exact_stretch(const Oscillator<T>& oscillator, const T& start, const T& time) {
  return static_cast<double>(exact(oscillator, start, time).last.stretch);
}

/// Its first turning point.
template <class T>
[[nodiscard]] RegimeEvent<T> exact_turn(const Oscillator<T>& oscillator, const T& start) {
  return exact(oscillator, start, T(1e9), 1).events.at(0);
}

/// Observed order of an error that falls from `coarse` to `fine` when the small parameter is divided by `ratio`.
[[nodiscard]] inline double order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

}  // namespace turgor::test
