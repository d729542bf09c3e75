#pragma once
// Time integration of the hybrid oscillator with located regime changes.

#include <functional>

#include "turgor/integrate/trajectory.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

/// How to integrate, and when to stop.
template <class T>
struct SimulationOptions {
  T rtol = T(1e-9);                        ///< local error per step relative to R and to dR/dT
  T atol = T(1e-9);                        ///< local error per step, absolute, in the dimensionless variables
  long max_events = 0;                     ///< stop after that many regime changes; 0: no limit
  T rest_tol = T(0);                       ///< stop at an event this close (in R) to a stable equilibrium; 0: never
  T max_stretch = T(0);                    ///< stretch at which the wall bursts; 0: never
  T runaway_stretch = T(largest_stretch);  ///< stretch beyond which the balloon counts as running away
  long max_steps = 5'000'000;              ///< bounds memory: a step takes about 160 bytes
  /// Called after every step with the time reached; returning false ends the run as `interrupted`.
  std::function<bool(const T&)> keep_going;
};

/// Integrates the oscillator from (start_time, R, dR/dT) to end_time; all times dimensionless.
///
/// Regimes: the sign of dR/dT, and at dR/dT = 0 the sign of the force at rest; where that vanishes too, the sign of the
/// first non-vanishing right-hand derivative of P; `rest` only while P is constant, decided again at every knot. Every
/// zero of dR/dT on the computed solution is located (also a pair within one step) and the rate set to exactly zero
/// there. Steps end at knots. Both accelerations at dR/dT = 0 have the sign of a P - E, so the solution always crosses
/// and never slides; nor does it come to rest in finite time (docs/theory.md, section 2.4).
///
/// Never throws for trouble on the way: the outcome says what happened and everything up to there is kept.
/// @throws InvalidInput when the start is not finite, R is not positive, the wall has no finite tension or the closure
/// does not hold there, or end_time <= start_time
template <class T>
[[nodiscard]] Trajectory<T> simulate(const Oscillator<T>& oscillator, const T& start_time, const T& stretch,
                                     const T& rate, const T& end_time, const SimulationOptions<T>& options);

/// Refuses a start that cannot be: see simulate().
template <class T>
void check_start(const Oscillator<T>& oscillator, const T& start_time, const T& stretch, const T& rate,
                 const T& end_time, const SimulationOptions<T>& options);

/// Regime in which the balloon leaves a state of rest (dR/dT = 0) at stretch R and time T; see simulate().
template <class T>
[[nodiscard]] Regime regime_from_rest(const Oscillator<T>& oscillator, const SmoothPressure<T>& pressure, const T& time,
                                      const T& stretch);

/// Whether a state of rest at time T lies within rest_tol (in R) of a stable equilibrium of a pressure that never
/// changes again; never for rest_tol = 0.
template <class T>
[[nodiscard]] bool is_settled(const Oscillator<T>& oscillator, const SmoothPressure<T>& pressure, const T& time,
                              const T& stretch, const T& rest_tol);

/// Why the solution cannot be followed beyond stretch R: the closure's table ends there, or nobody knows.
struct Standstill {
  Outcome outcome;
  std::string text;
};
template <class T>
[[nodiscard]] Standstill standstill(const Oscillator<T>& oscillator, const T& stretch);

/// " (at t = ... s, R = ..., dR/dt = ... 1/s)", for messages.
template <class T>
[[nodiscard]] std::string whereabouts(const Oscillator<T>& oscillator, const Point<T>& at);

extern template Trajectory<double> simulate(const Oscillator<double>&, const double&, const double&, const double&,
                                            const double&, const SimulationOptions<double>&);
extern template Trajectory<long double> simulate(const Oscillator<long double>&, const long double&, const long double&,
                                                 const long double&, const long double&,
                                                 const SimulationOptions<long double>&);
extern template Regime regime_from_rest(const Oscillator<double>&, const SmoothPressure<double>&, const double&,
                                        const double&);
extern template Regime regime_from_rest(const Oscillator<long double>&, const SmoothPressure<long double>&,
                                        const long double&, const long double&);

extern template bool is_settled(const Oscillator<double>&, const SmoothPressure<double>&, const double&, const double&,
                                const double&);
extern template bool is_settled(const Oscillator<long double>&, const SmoothPressure<long double>&, const long double&,
                                const long double&, const long double&);
extern template Standstill standstill(const Oscillator<double>&, const double&);
extern template Standstill standstill(const Oscillator<long double>&, const long double&);
extern template std::string whereabouts(const Oscillator<double>&, const Point<double>&);
extern template std::string whereabouts(const Oscillator<long double>&, const Point<long double>&);
extern template void check_start(const Oscillator<double>&, const double&, const double&, const double&, const double&,
                                 const SimulationOptions<double>&);
extern template void check_start(const Oscillator<long double>&, const long double&, const long double&,
                                 const long double&, const long double&, const SimulationOptions<long double>&);

}  // namespace turgor
