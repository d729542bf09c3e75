#include "turgor/integrate/simulate.hpp"

#include <cmath>
#include <limits>

#include "oscillator_flow.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/integrate/rosenbrock.hpp"
#include "zero_in_step.hpp"

namespace turgor {

namespace {

template <class T>
constexpr T epsilon = std::numeric_limits<T>::epsilon();

template <class T>
constexpr T sign(Regime regime) {
  return static_cast<T>(static_cast<int>(regime));
}

/// One run of simulate(): the current state and the trajectory so far.
template <class T>
class Simulation {
 public:
  using State = Eigen::Matrix<T, 2, 1>;  // (R, dR/dT)
  using Step = RosenbrockStep<T, 2>;

  Simulation(const Oscillator<T>& oscillator, const T& start, const State& state, const T& end,
             const SimulationOptions<T>& options)
      : oscillator_(oscillator), options_(options), time_(start), end_(end), state_(state) {}

  Trajectory<T> run() {
    while (time_ < end_ && !stopped_) run_to_knot();
    result_.last = {time_, state_[0], state_[1], regime_};
    return std::move(result_);
  }

 private:
  /// From the current time to the next knot or the end, under one smooth pressure.
  void run_to_knot() {
    pressure_ = &oscillator_.pressure().after(time_);
    const T target = std::min(end_, oscillator_.pressure().next_knot(time_));
    T h(0);  // 0: to be chosen
    while (time_ < target && !stopped_) {
      if (state_[1] == T(0)) {
        decide_at_rest(h);
      } else if (regime_ == Regime::rest) {
        regime_ = state_[1] > T(0) ? Regime::inflating : Regime::deflating;
      }
      if (stopped_) return;
      if (regime_ == Regime::rest) {
        hold(target - time_);
        time_ = target;
        return;
      }
      h = advance(h, target);
    }
  }

  /// At dR/dT = 0: the regime is decided anew; a change is an event, except at the start.
  void decide_at_rest(T& h) {
    const Regime before = regime_;
    regime_ = regime_from_rest(oscillator_, *pressure_, time_, state_[0]);
    if (regime_ == before || !started()) return;
    h = T(0);
    const bool rests = settled();
    if (rests) regime_ = Regime::rest;
    result_.events.push_back({time_, state_[0], before, regime_});
    if (rests) stop(Outcome::at_rest, "");
    if (options_.max_events > 0 && static_cast<long>(result_.events.size()) >= options_.max_events) {
      stop(Outcome::max_events, "");
    }
  }

  /// Whether a state of rest lies within rest_tol of a stable equilibrium of a pressure that never changes again.
  [[nodiscard]] bool settled() const {
    if (!(options_.rest_tol > T(0))) return false;
    const T p = (*pressure_)(time_);
    for (const auto& piece : oscillator_.pressure().pieces()) {
      if (&piece.pressure >= pressure_ && !(piece.pressure.is_constant() && piece.pressure(time_) == p)) return false;
    }
    const Coefficients<T> c = oscillator_.coefficients(Regime::inflating, state_[0]);
    const T stiffness = c.elastic_slope - c.area_slope * p;
    return stiffness > T(0) && std::abs(c.area * p - c.elastic) <= options_.rest_tol * stiffness;
  }

  /// Takes one accepted step towards `target` and returns the size proposed for the next.
  T advance(T h, const T& target) {
    const OscillatorFlow<T> flow(oscillator_, *pressure_, regime_);
    const Linearization<T, 2> at = flow.linearize(time_, state_);
    ++result_.statistics.linearizations;
    if (!(h > T(0))) h = first_step(at, target - time_);
    bool rejected = false;
    while (true) {
      const T left = target - time_;
      const bool reaches = h >= left * (1 - 8 * epsilon<T>);
      if (reaches) {
        h = left;
      } else if (2 * h > left) {
        h = left / 2;  // two even steps rather than one and a splinter
      }
      if (!reaches && !(time_ + h > time_)) {
        fail(Outcome::step_failed, "the step size fell below what the clock resolves");
        return h;
      }
      const Step step = attempt(flow, at, h);
      const T error = error_norm(step);
      if (!(error <= T(1))) {  // also when it is not a number
        ++result_.statistics.rejected;
        rejected = true;
        h *= std::isfinite(error) ? std::max(T(0.2), T(0.9) * std::pow(error, T(-0.2))) : T(0.1);
        continue;
      }
      const T growth = std::min(rejected ? T(1) : T(5), T(0.9) * std::pow(std::max(error, T(1e-10)), T(-0.2)));
      accept(flow, at, h, step, reaches ? target : time_ + h);
      return h * growth;
    }
  }

  /// Keeps a step whose error is within tolerance, shortened to the first event inside it.
  void accept(const OscillatorFlow<T>& flow, const Linearization<T, 2>& at, T h, Step step, T end_time) {
    const T s = sign<T>(regime_);
    const T noise = 64 * epsilon<T> * h * flow.largest_acceleration(time_, state_[0]);
    const T start_rate = state_[1];
    if (const std::optional<T> event = find_zero_rate(flow, at, h, step, s, noise)) {
      h = *event;
      end_time = time_ + h;
      step = attempt(flow, at, h);
      step.end[1] = T(0);
    } else if (s * step.end[1] <= noise && start_rate == T(0)) {
      step.end[1] = T(0);  // nothing but rounding: still at rest
    }
    if (options_.max_stretch > T(0) && step.end[0] >= options_.max_stretch && regime_ == Regime::inflating) {
      h = locate(flow, at, T(0), h, h, [&](const State& y) { return Slope{options_.max_stretch - y[0], -y[1]}; });
      end_time = time_ + h;
      step = attempt(flow, at, h);
      append(step, h);
      time_ = end_time;
      state_ = {options_.max_stretch, step.end[1]};
      fail(Outcome::burst, "the wall reached material.max_stretch and bursts");
      return;
    }
    append(step, h);
    time_ = end_time;
    state_ = step.end;
    check_limits();
  }

  void check_limits() {
    if (state_[0] > options_.runaway_stretch) {
      fail(Outcome::runaway, "the balloon runs away: nothing holds it at this pressure");
    } else if (result_.statistics.steps >= options_.max_steps && time_ < end_) {
      fail(Outcome::max_steps, "more than " + std::to_string(options_.max_steps) + " steps");
    } else if (options_.keep_going && !options_.keep_going(time_)) {
      stop(Outcome::interrupted, "interrupted");
    }
  }

  /// A function of the step size together with its derivative.
  struct Slope {
    T value;
    T slope;
  };

  /// Size of the shortened step that ends where dR/dT first vanishes, if it does.
  std::optional<T> find_zero_rate(const OscillatorFlow<T>& flow, const Linearization<T, 2>& at, const T& h,
                                  const Step& step, const T& s, const T& noise) {
    std::array<T, 5> rate{};
    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] = s * step.polynomial[i][1];
    constexpr int depth = 8;
    const std::optional<T> dip = first_negative(bernstein<T>(rate), T(0), T(1), noise, depth);
    T bracket = h;
    bool crossed = s * step.end[1] < -noise;
    if (dip && *dip < T(1) && s * attempt(flow, at, *dip * h).end[1] < -noise) {
      bracket = *dip * h;
      crossed = true;
    }
    if (!crossed) return std::nullopt;
    const T guess = dip ? std::min(bracket, (*dip - T(0.5) / (1 << depth)) * h) : bracket / 2;
    ++result_.statistics.event_refinements;
    return locate(flow, at, T(0), bracket, guess,
                  [&](const State& y) { return Slope{s * y[1], s * flow.rate(time_ + bracket, y)[1]}; });
  }

  /// Root in (lo, hi] of a function of the state at the end of a step of size x: positive at lo, negative at hi.
  /// Newton's method on the steps themselves, so that the event lies on the computed solution to rounding; bisection as
  /// its net.
  template <class Function>
  T locate(const OscillatorFlow<T>& flow, const Linearization<T, 2>& at, T lo, T hi, T x, const Function& function) {
    T last_x(0);
    T last_value(0);
    for (int i = 0; i < 200; ++i) {
      auto [value, slope] = function(attempt(flow, at, x).end);
      if (i > 0 && x != last_x) slope = (value - last_value) / (x - last_x);
      (value > T(0) ? lo : hi) = x;
      T next = x - value / slope;
      if (!(next > lo && next < hi)) next = (lo + hi) / 2;
      const T correction = std::abs(next - x);
      // Once corrections are small and no longer shrink, they are rounding.
      const bool rounding = i > 0 && correction < T(1e-9) * x && 2 * correction > std::abs(x - last_x);
      if (rounding || correction <= 32 * epsilon<T> * x || value == T(0)) return x;
      last_x = x;
      last_value = value;
      x = next;
    }
    return x;
  }

  Step attempt(const OscillatorFlow<T>& flow, const Linearization<T, 2>& at, const T& h) {
    result_.statistics.rate_evaluations += Rodas5P<T>::stages - 1;
    ++result_.statistics.factorizations;
    return rosenbrock_step(flow, time_, state_, at, h);
  }

  [[nodiscard]] T error_norm(const Step& step) const {
    T norm(0);
    for (int i = 0; i < 2; ++i) {
      const T scale = options_.atol + options_.rtol * std::max(std::abs(state_[i]), std::abs(step.end[i]));
      const T ratio = std::abs(step.error[i]) / scale;
      if (!(ratio <= norm)) norm = ratio;  // lets a NaN through
    }
    return std::isfinite(step.end.sum()) ? norm : std::numeric_limits<T>::quiet_NaN();
  }

  /// Hairer, Norsett & Wanner I, section II.4: a first step from the size of y, y' and y''.
  [[nodiscard]] T first_step(const Linearization<T, 2>& at, const T& longest) const {
    const State second = at.jacobian * at.rate + at.time_derivative;
    T d0(0);
    T d1(0);
    T d2(0);
    for (int i = 0; i < 2; ++i) {
      const T scale = options_.atol + options_.rtol * std::abs(state_[i]);
      d0 = std::max(d0, std::abs(state_[i]) / scale);
      d1 = std::max(d1, std::abs(at.rate[i]) / scale);
      d2 = std::max(d2, std::abs(second[i]) / scale);
    }
    const T steepest = std::max(d1, d2);
    const T by_order = steepest > T(0) ? std::pow(T(0.01) / steepest, T(1) / (Rodas5P<T>::order + 1)) : longest;
    const T by_rate = d1 > T(0) ? d0 / d1 : longest;
    return std::min({by_order, by_rate, longest / 10});
  }

  void append(const Step& step, const T& h) {
    TrajectoryStep<T> kept{time_, h, regime_, {}, {}};
    for (std::size_t i = 0; i < step.polynomial.size(); ++i) {
      kept.stretch[i] = step.polynomial[i][0];
      kept.rate[i] = step.polynomial[i][1];
    }
    result_.steps.push_back(kept);
    ++result_.statistics.steps;
  }

  void hold(const T& duration) {
    result_.steps.push_back({time_, duration, Regime::rest, {state_[0]}, {}});
    ++result_.statistics.steps;
  }

  [[nodiscard]] bool started() const { return !result_.steps.empty(); }

  void stop(Outcome outcome, std::string message) {
    result_.outcome = outcome;
    result_.message = std::move(message);
    stopped_ = true;
  }

  void fail(Outcome outcome, const std::string& what) {
    const auto number = [](const T& x) { return rounded(static_cast<double>(x), 8); };
    const T scale = oscillator_.scales().time;
    stop(outcome, what + " (at t = " + number(time_ * scale) + " s, R = " + number(state_[0]) +
                      ", dR/dt = " + number(state_[1] / scale) + " 1/s)");
  }

  const Oscillator<T>& oscillator_;
  const SimulationOptions<T>& options_;
  const SmoothPressure<T>* pressure_ = nullptr;
  T time_;
  T end_;
  State state_;
  Regime regime_ = Regime::rest;
  bool stopped_ = false;
  Trajectory<T> result_;
};

}  // namespace

template <class T>
Regime regime_from_rest(const Oscillator<T>& oscillator, const SmoothPressure<T>& pressure, const T& time,
                        const T& stretch) {
  const T p = pressure(time);
  const Coefficients<T> c = oscillator.coefficients(Regime::inflating, stretch);
  const T force = c.area * p - c.elastic;
  // An equilibrium is known to a few units in the last place of R, and the force there to as many of its terms.
  const T rounding =
      32 * epsilon<T> * (stretch * std::abs(c.elastic_slope) + std::abs(c.area * p) + std::abs(c.elastic));
  const auto regime_of = [](const T& x) { return x > T(0) ? Regime::inflating : Regime::deflating; };
  if (std::abs(force) > rounding) return regime_of(force);
  if (pressure.is_constant()) return Regime::rest;
  for (int k = 1; k <= 8; ++k) {
    const T derivative = pressure.derivative(k, time);
    if (std::abs(derivative) > 32 * epsilon<T> * pressure.derivative_size(k)) return regime_of(derivative);
  }
  return Regime::rest;
}

template <class T>
Trajectory<T> simulate(const Oscillator<T>& oscillator, const T& start_time, const T& stretch, const T& rate,
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
  return Simulation<T>(oscillator, start_time, {stretch, rate}, end_time, options).run();
}

template Trajectory<double> simulate(const Oscillator<double>&, const double&, const double&, const double&,
                                     const double&, const SimulationOptions<double>&);
template Trajectory<long double> simulate(const Oscillator<long double>&, const long double&, const long double&,
                                          const long double&, const long double&,
                                          const SimulationOptions<long double>&);
template Regime regime_from_rest(const Oscillator<double>&, const SmoothPressure<double>&, const double&,
                                 const double&);
template Regime regime_from_rest(const Oscillator<long double>&, const SmoothPressure<long double>&, const long double&,
                                 const long double&);

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::reached_end: return "reached-end";
    case Outcome::at_rest: return "at-rest";
    case Outcome::max_events: return "max-events";
    case Outcome::burst: return "burst";
    case Outcome::runaway: return "runaway";
    case Outcome::step_failed: return "step-failed";
    case Outcome::max_steps: return "max-steps";
    case Outcome::interrupted: return "interrupted";
  }
  return "";
}

bool is_complete(Outcome outcome) {
  return outcome == Outcome::reached_end || outcome == Outcome::at_rest || outcome == Outcome::max_events;
}

}  // namespace turgor
