#pragma once
// What time integration returns.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "turgor/base/regime.hpp"
#include "turgor/integrate/dense_polynomial.hpp"

namespace turgor {

/// Why a trajectory ends where it does.
enum class Outcome {
  reached_end,  ///< at the requested end time
  at_rest,      ///< within the requested distance of an equilibrium, under a pressure that stays constant
  max_events,   ///< after the requested number of events
  burst,        ///< reached the stretch at which the wall is said to burst
  runaway,      ///< nothing holds the balloon any more: the stretch exceeds every physical value
  step_failed,  ///< the step size fell below what the clock resolves
  max_steps,    ///< more steps than allowed
  interrupted,  ///< asked to stop from outside
  closure_end,  ///< reached a stretch beyond which an exact closure is not known
};

/// "reached-end", "at-rest", ...
[[nodiscard]] std::string_view name_of(Outcome outcome);
/// Whether the trajectory is what was asked for.
[[nodiscard]] bool is_complete(Outcome outcome);

/// State of the oscillator at one time; everything dimensionless.
template <class T>
struct Point {
  T time;     ///< T
  T stretch;  ///< R
  T rate;     ///< dR/dT
  Regime regime;
};

/// A change of regime: the rate is exactly zero there.
template <class T>
struct RegimeEvent {
  T time;
  T stretch;
  Regime before;
  Regime after;
};

/// The solution over one step, as polynomials in theta = (time - start)/duration.
template <class T>
struct TrajectoryStep {
  T start;
  T duration;
  Regime regime;
  DensePolynomial<T> stretch;
  DensePolynomial<T> rate;

  [[nodiscard]] T stretch_at(const T& theta) const { return evaluate(stretch, theta); }
  [[nodiscard]] T rate_at(const T& theta) const { return evaluate(rate, theta); }
};

/// A solution of the oscillator from its start to where it ended, with dense output.
template <class T>
struct Trajectory {
  std::vector<TrajectoryStep<T>> steps;  ///< in order of time, without gaps
  std::vector<RegimeEvent<T>> events;    ///< the start is none
  Point<T> last{};                       ///< final state
  Outcome outcome = Outcome::reached_end;
  std::string message;  ///< for people, when the outcome is not what was asked for
  IntegratorStatistics statistics;

  /// State at a time between the start and last.time; at an event, the state after it.
  [[nodiscard]] Point<T> at(const T& time) const {
    if (steps.empty() || time >= last.time) return last;
    const TrajectoryStep<T>& step = step_at(time);
    const T theta = std::max(T(0), (time - step.start) / step.duration);
    return {time, step.stretch_at(theta), step.rate_at(theta), step.regime};
  }

  [[nodiscard]] const TrajectoryStep<T>& step_at(const T& time) const {
    const auto next = std::upper_bound(steps.begin() + 1, steps.end(), time,
                                       [](const T& t, const TrajectoryStep<T>& step) { return t < step.start; });
    return *(next - 1);
  }
};

}  // namespace turgor
