#pragma once
// What every way of following the oscillator shares: knots, rest, changes of regime, and where a run stops.

#include <cmath>
#include <string>
#include <utility>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/integrate/simulate.hpp"

namespace turgor {

/// @throws InvalidInput as simulate() documents
template <class T>
void require_valid_start(const Oscillator<T>& oscillator, const T& start_time, const T& stretch, const T& rate,
                         const T& end_time, const SimulationOptions<T>& options) {
  const auto text = [](const T& x) { return shortest(static_cast<double>(x)); };
  if (!(stretch > T(0)) || !std::isfinite(strain_energy(oscillator.parameters().material, stretch).first)) {
    throw InvalidInput("initial.stretch", text(stretch), "not a stretch this material can have",
                       "must be positive and where the tension of the wall is finite");
  }
  if (options.max_stretch > T(0) && stretch >= options.max_stretch) {
    throw InvalidInput("initial.stretch", text(stretch), "the wall has burst already",
                       "material.max_stretch is " + text(options.max_stretch));
  }
  if (!std::isfinite(rate)) throw InvalidInput("initial.stretch_rate", text(rate), "not a finite number");
  if (!(end_time > start_time) || !std::isfinite(end_time)) {
    throw InvalidInput("solve.t_end", text(end_time), "must be finite and later than the start",
                       "the start is " + text(start_time));
  }
}

/// One run: the current state and the trajectory so far. A method derives from it and says how to advance.
template <class T>
class HybridRun {
 public:
  HybridRun(const Oscillator<T>& oscillator, const T& start, const T& stretch, const T& rate, const T& end,
            const SimulationOptions<T>& options)
      : oscillator_(oscillator), options_(options), time_(start), end_(end), stretch_(stretch), rate_(rate) {}
  HybridRun(const HybridRun&) = delete;
  HybridRun& operator=(const HybridRun&) = delete;

  Trajectory<T> run() {
    while (time_ < end_ && !stopped_) run_to_knot();
    result_.last = {time_, stretch_, rate_, regime_};
    return std::move(result_);
  }

 protected:
  ~HybridRun() = default;

  /// Forgets what was learnt on the way: the pressure or the regime has changed.
  virtual void start_anew() = 0;
  /// Appends a step towards `target` in the current regime, at most to the next zero of the rate, and moves the state.
  virtual void advance(const T& target) = 0;

  [[nodiscard]] T direction() const { return static_cast<T>(static_cast<int>(regime_)); }
  [[nodiscard]] T current_pressure() const { return (*pressure_)(time_); }

  /// Keeps a step that ends in the given state.
  void append(const TrajectoryStep<T>& step, const T& end_time, const T& stretch, const T& rate) {
    result_.steps.push_back(step);
    ++result_.statistics.steps;
    time_ = end_time;
    stretch_ = stretch;
    rate_ = rate;
  }

  void check_limits() {
    if (stretch_ > options_.runaway_stretch) {
      fail(Outcome::runaway, "the balloon runs away: nothing holds it at this pressure");
    } else if (result_.statistics.steps >= options_.max_steps && time_ < end_) {
      fail(Outcome::max_steps, "more than " + std::to_string(options_.max_steps) + " steps");
    } else if (options_.keep_going && !options_.keep_going(time_)) {
      stop(Outcome::interrupted, "interrupted");
    }
  }

  void stop(Outcome outcome, std::string message) {
    result_.outcome = outcome;
    result_.message = std::move(message);
    stopped_ = true;
  }

  void fail(Outcome outcome, const std::string& what) {
    const auto number = [](const T& x) { return rounded(static_cast<double>(x), 8); };
    const T scale = oscillator_.scales().time;
    stop(outcome, what + " (at t = " + number(time_ * scale) + " s, R = " + number(stretch_) +
                      ", dR/dt = " + number(rate_ / scale) + " 1/s)");
  }

  const Oscillator<T>& oscillator_;
  const SimulationOptions<T>& options_;
  const SmoothPressure<T>* pressure_ = nullptr;
  T time_;
  T end_;
  T stretch_;
  T rate_;
  Regime regime_ = Regime::rest;
  bool stopped_ = false;
  Trajectory<T> result_;

 private:
  /// From the current time to the next knot or the end, under one smooth pressure.
  void run_to_knot() {
    pressure_ = &oscillator_.pressure().after(time_);
    const T target = std::min(end_, oscillator_.pressure().next_knot(time_));
    start_anew();
    while (time_ < target && !stopped_) {
      if (rate_ == T(0)) {
        decide_at_rest();
      } else if (regime_ == Regime::rest) {
        regime_ = rate_ > T(0) ? Regime::inflating : Regime::deflating;
      }
      if (stopped_) return;
      if (regime_ == Regime::rest) {
        append({time_, target - time_, Regime::rest, {stretch_}, {}}, target, stretch_, rate_);
        return;
      }
      advance(target);
    }
  }

  /// At dR/dT = 0: the regime is decided anew; a change is an event, except at the start.
  void decide_at_rest() {
    const Regime before = regime_;
    regime_ = regime_from_rest(oscillator_, *pressure_, time_, stretch_);
    if (regime_ == before || result_.steps.empty()) return;
    start_anew();
    const bool rests = settled();
    if (rests) regime_ = Regime::rest;
    result_.events.push_back({time_, stretch_, before, regime_});
    if (rests) stop(Outcome::at_rest, "");
    if (options_.max_events > 0 && static_cast<long>(result_.events.size()) >= options_.max_events) {
      stop(Outcome::max_events, "");
    }
  }

  /// Whether a state of rest lies within rest_tol of a stable equilibrium of a pressure that never changes again.
  [[nodiscard]] bool settled() const {
    if (!(options_.rest_tol > T(0))) return false;
    const T p = current_pressure();
    for (const auto& piece : oscillator_.pressure().pieces()) {
      if (&piece.pressure >= pressure_ && !(piece.pressure.is_constant() && piece.pressure(time_) == p)) return false;
    }
    const Coefficients<T> c = oscillator_.coefficients(Regime::inflating, stretch_);
    const T stiffness = c.elastic_slope - c.area_slope * p;
    return stiffness > T(0) && std::abs(c.area * p - c.elastic) <= options_.rest_tol * stiffness;
  }
};

}  // namespace turgor
