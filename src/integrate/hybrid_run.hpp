#pragma once
// What every way of following the oscillator shares: knots, rest, changes of regime, and where a run stops.

#include <string>
#include <utility>

#include "turgor/integrate/simulate.hpp"

namespace turgor {

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
    stop(outcome, what + whereabouts(oscillator_, Point<T>{time_, stretch_, rate_, regime_}));
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
    const bool rests = is_settled(oscillator_, *pressure_, time_, stretch_, options_.rest_tol);
    if (rests) regime_ = Regime::rest;
    result_.events.push_back({time_, stretch_, before, regime_});
    if (rests) stop(Outcome::at_rest, "");
    if (options_.max_events > 0 && static_cast<long>(result_.events.size()) >= options_.max_events) {
      stop(Outcome::max_events, "");
    }
  }
};

}  // namespace turgor
