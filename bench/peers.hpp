#pragma once
// The same hybrid trajectories by other people's integrators, for work-precision comparisons.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "turgor/integrate/oscillator_flow.hpp"
#include "turgor/integrate/simulate.hpp"

namespace turgor::bench {

/// One trajectory with known values of R at some times, all dimensionless.
struct Problem {
  std::string name;
  Oscillator<double> oscillator;
  double stretch;
  double rate;
  std::vector<double> times;      ///< increasing; the last is the end
  std::vector<double> reference;  ///< R at these times
  /// A method that makes more of it is stuck: no reference trajectory has a tenth of these changes of regime.
  int most_stretches = 20000;
};

/// The very right-hand side that this project's own integrator calls, so that methods are compared and not functions.
class PeerFlow {
 public:
  using Solid = MooneyRivlin<double>;
  using State = OscillatorFlow<double, Solid>::State;

  PeerFlow(const Oscillator<double>& oscillator, const SmoothPressure<double>& pressure, Regime regime)
      : numbers_(flow_numbers(oscillator, pressure, regime)),
        solid_(std::get<Solid>(oscillator.parameters().material)),
        harmonic_(numbers_.forcing.amplitude != 0) {}

  [[nodiscard]] State rate(double t, const State& y) const { return flow().rate(t, y); }
  [[nodiscard]] Linearization<double, 2> linearize(double t, const State& y) const { return flow().linearize(t, y); }

 private:
  [[nodiscard]] OscillatorFlow<double, Solid> flow() const { return {numbers_, solid_, harmonic_}; }

  FlowNumbers<double> numbers_;
  Solid solid_;
  bool harmonic_;
};

/// R at a problem's times, by some method at some tolerance (relative and absolute).
using Method = std::function<std::vector<double>(const Problem&, double tolerance)>;

[[nodiscard]] std::vector<double> by_turgor(const Problem& problem, double tolerance);

/// SUNDIALS CVODE with its own root finding, dense direct solver and analytic Jacobian.
[[nodiscard]] std::vector<double> by_cvode_bdf(const Problem& problem, double tolerance);
[[nodiscard]] std::vector<double> by_cvode_adams(const Problem& problem, double tolerance);

/// Boost.Odeint with events bracketed on dense output: explicit Dormand-Prince 5, Fehlberg 7(8) (shorter steps instead
/// of dense output), and Rosenbrock 4 with analytic Jacobian.
[[nodiscard]] std::vector<double> by_odeint_dopri5(const Problem& problem, double tolerance);
[[nodiscard]] std::vector<double> by_odeint_fehlberg78(const Problem& problem, double tolerance);
[[nodiscard]] std::vector<double> by_odeint_rosenbrock4(const Problem& problem, double tolerance);

/// Walks a problem from knot to knot and regime to regime; `advance` integrates one stretch of one regime under one
/// smooth pressure up to `target` or to dR/dT = 0, whichever comes first, and changes time and state (rate exactly 0 at
/// an event). It is handed the times to report on the way through `report`.
struct Stretch {
  const Problem& problem;
  const SmoothPressure<double>& pressure;
  Regime regime;
  double target;
};
struct State {
  double time, stretch, rate;
};
template <class Advance>
void walk(const Problem& problem, const Advance& advance) {
  State state{0, problem.stretch, problem.rate};
  const double end = problem.times.back();
  for (int stretches = 0; state.time < end; ++stretches) {
    if (stretches > problem.most_stretches) throw std::runtime_error("stuck at t = " + std::to_string(state.time));
    const auto& pressure = problem.oscillator.pressure().after(state.time);
    const double target = std::min(end, problem.oscillator.pressure().next_knot(state.time));
    Regime regime = state.rate > 0 ? Regime::inflating : Regime::deflating;
    if (state.rate == 0) regime = regime_from_rest(problem.oscillator, pressure, state.time, state.stretch);
    advance(Stretch{problem, pressure, regime, target}, state);
  }
}

}  // namespace turgor::bench
