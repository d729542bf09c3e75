#include "turgor/integrate/simulate.hpp"

#include <cmath>
#include <limits>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/integrate/oscillator_lanes.hpp"

namespace turgor {

namespace {

template <class T>
constexpr T epsilon = std::numeric_limits<T>::epsilon();

/// Keeps everything.
template <class T>
class Recorder {
 public:
  using Lanes = OscillatorLanes<T, Recorder>;

  void steps(const Lanes& lanes, bool /*always*/, const T& start, const T& h,
             const DenseState<typename Lanes::State>& dense) {
    TrajectoryStep<T>& step = trajectory_.steps.emplace_back(start, h, lanes.balloon(0).regime);
    for (std::size_t i = 0; i < dense.size(); ++i) {
      step.stretch[i] = dense[i][0];
      step.rate[i] = dense[i][1];
    }
  }
  void hold(const Lanes& lanes, int /*lane*/, const T& duration) {
    const Point<T> at = lanes.point(0);
    trajectory_.steps.push_back({at.time, duration, Regime::rest, {at.stretch}, {}});
    ++held_;
  }
  void event(const Lanes& lanes, int /*lane*/, Regime before, Regime after) {
    const Point<T> at = lanes.point(0);
    trajectory_.events.push_back({at.time, at.stretch, before, after});
  }
  void finished(Lanes& lanes, int /*lane*/) {
    trajectory_.last = lanes.point(0);
    trajectory_.outcome = lanes.balloon(0).outcome;
    trajectory_.message = lanes.balloon(0).message;
    trajectory_.statistics = lanes.integrator().statistics();
    trajectory_.statistics.steps += held_;
  }
  [[nodiscard]] Trajectory<T>& trajectory() { return trajectory_; }

 private:
  Trajectory<T> trajectory_;
  long held_ = 0;
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
void check_start(const Oscillator<T>& oscillator, const T& start_time, const T& stretch, const T& rate,
                 const T& end_time, const SimulationOptions<T>& options) {
  const auto text = [](const T& x) { return shortest(static_cast<double>(x)); };
  if (!(stretch > T(0)) || !std::isfinite(strain_energy(oscillator.parameters().material, stretch).first)) {
    throw InvalidInput("initial.stretch", text(stretch), "not a stretch this material can have",
                       "must be positive and where the tension of the wall is finite");
  }
  require_closure(oscillator.parameters(), stretch);
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

template <class T>
Trajectory<T> simulate(const Oscillator<T>& oscillator, const T& start_time, const T& stretch, const T& rate,
                       const T& end_time, const SimulationOptions<T>& options) {
  check_start(oscillator, start_time, stretch, rate, end_time, options);
  Recorder<T> recorder;
  OscillatorLanes<T, Recorder<T>> lanes(oscillator.parameters().material, oscillator.force_table(),
                                        StepMethod::explicit_pair, recorder);
  lanes.load(0, oscillator, start_time, stretch, rate, end_time, options);
  lanes.run();
  return std::move(recorder.trajectory());
}

template <class T>
bool is_settled(const Oscillator<T>& oscillator, const SmoothPressure<T>& pressure, const T& time, const T& stretch,
                const T& rest_tol) {
  if (!(rest_tol > T(0))) return false;
  const T p = pressure(time);
  for (const auto& piece : oscillator.pressure().pieces()) {
    if (&piece.pressure >= &pressure && !(piece.pressure.is_constant() && piece.pressure(time) == p)) return false;
  }
  const Coefficients<T> c = oscillator.coefficients(Regime::inflating, stretch);
  const T stiffness = c.elastic_slope - c.area_slope * p;
  return stiffness > T(0) && std::abs(c.area * p - c.elastic) <= rest_tol * stiffness;
}

template <class T>
Standstill standstill(const Oscillator<T>& oscillator, const T& stretch) {
  // The last steps stay closer to the end than this.
  constexpr T near = T(1e-6);
  const StretchLimits<T> limits = closure_limits(oscillator.parameters());
  const auto number = [](const T& x) { return rounded(static_cast<double>(x), 6); };
  if (stretch < limits.least * (1 + near)) {
    return {Outcome::closure_end, "R fell to r_ch/(0.75 r0) = " + number(limits.least) + ", where model.closure = \"" +
                                      std::string(name_of(oscillator.parameters().closure)) +
                                      "\" ends: the balloon is hardly larger than its orifice"};
  }
  if (stretch > limits.greatest * (1 - near)) {
    return {Outcome::closure_end, "R reached 2^17 r_ch/r0 = " + number(limits.greatest) + ", where model.closure = \"" +
                                      std::string(name_of(oscillator.parameters().closure)) + "\" ends"};
  }
  return {Outcome::step_failed, "the step size fell below what the clock resolves"};
}

template <class T>
std::string whereabouts(const Oscillator<T>& oscillator, const Point<T>& at) {
  const auto number = [](const T& x) { return rounded(static_cast<double>(x), 8); };
  const T scale = oscillator.scales().time;
  return " (at t = " + number(at.time * scale) + " s, R = " + number(at.stretch) +
         ", dR/dt = " + number(at.rate / scale) + " 1/s)";
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

template bool is_settled(const Oscillator<double>&, const SmoothPressure<double>&, const double&, const double&,
                         const double&);
template bool is_settled(const Oscillator<long double>&, const SmoothPressure<long double>&, const long double&,
                         const long double&, const long double&);
template Standstill standstill(const Oscillator<double>&, const double&);
template Standstill standstill(const Oscillator<long double>&, const long double&);
template std::string whereabouts(const Oscillator<double>&, const Point<double>&);
template std::string whereabouts(const Oscillator<long double>&, const Point<long double>&);
template void check_start(const Oscillator<double>&, const double&, const double&, const double&, const double&,
                          const SimulationOptions<double>&);
template void check_start(const Oscillator<long double>&, const long double&, const long double&, const long double&,
                          const long double&, const SimulationOptions<long double>&);

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
    case Outcome::closure_end: return "closure-end";
  }
  return "";
}

bool is_complete(Outcome outcome) {
  return outcome == Outcome::reached_end || outcome == Outcome::at_rest || outcome == Outcome::max_events;
}

}  // namespace turgor
