#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <ranges>

#include "parts.hpp"
#include "turgor/case/quantities.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

namespace {

/// First time in [from, to] at which the stretch crosses a level, going the way it is asked to; dimensionless.
std::optional<double> first_crossing(std::span<const TrajectoryStep<double>> steps, double level, bool upwards,
                                     double from, double to) {
  const double s = upwards ? 1 : -1;
  for (const auto& step : steps) {
    if (step.start + step.duration <= from) continue;
    if (step.start >= to) break;
    const double before = s * (step.stretch_at(0) - level);
    const double after = s * (step.stretch_at(1) - level);
    if (before > 0 || after < 0) continue;
    if (before == 0) return step.start;
    if (after == 0) return step.start + step.duration;
    std::uintmax_t iterations = 100;
    const auto bracket =
        boost::math::tools::toms748_solve([&](double x) { return s * (step.stretch_at(x) - level); }, 0.0, 1.0, before,
                                          after, boost::math::tools::eps_tolerance<double>(50), iterations);
    return step.start + step.duration * (bracket.first + bracket.second) / 2;
  }
  return std::nullopt;
}

/// Time between 10 % and 90 % of the way from one stretch to another.
std::optional<double> ten_to_ninety(std::span<const TrajectoryStep<double>> steps, double first, double last,
                                    double from, double to) {
  const double way = last - first;
  if (!(std::abs(way) > 1e-12)) return std::nullopt;
  const auto begin = first_crossing(steps, first + 0.1 * way, way > 0, from, to);
  const auto end = first_crossing(steps, first + 0.9 * way, way > 0, from, to);
  if (!begin || !end) return std::nullopt;
  return *end - *begin;
}

/// Evaluates one quantity at a time, and what several of them need only once.
class Evaluator {
 public:
  Evaluator(const Oscillator<double>& oscillator, const MemberSummary& summary,
            std::span<const TrajectoryStep<double>> steps)
      : oscillator_(oscillator), summary_(summary), steps_(steps), clock_(oscillator.scales().time) {}

  /// @param index  in quantity_names()
  std::optional<double> operator()(std::size_t index) { return (this->*evaluators.at(index))(); }

 private:
  using Value = std::optional<double>;

  // NOLINTBEGIN(readability-make-member-function-const): one type for all; some keep what others need again
  Value peak_stretch() { return summary_.greatest_stretch; }
  Value peak_time() { return summary_.peak_time * clock_; }
  Value rise_time() {
    return seconds(ten_to_ninety(steps_, summary_.initial_stretch, summary_.greatest_stretch, 0, summary_.peak_time));
  }
  Value fall_time() {
    const Point<double>& last = summary_.last;
    return seconds(ten_to_ninety(steps_, summary_.greatest_stretch, last.stretch, summary_.peak_time, last.time));
  }
  Value final_stretch() { return summary_.last.stretch; }
  Value final_rate() { return summary_.last.rate / clock_; }
  Value end_time() { return summary_.last.time * clock_; }
  Value events() { return static_cast<double>(summary_.events); }
  Value first_event_time() { return summary_.events == 0 ? std::nullopt : Value(summary_.first_event_time * clock_); }
  Value inlet_work() { return summary_.inlet_work * oscillator_.scales().energy(); }
  Value dissipated() { return summary_.dissipated * oscillator_.scales().energy(); }
  Value energy_error() { return summary_.energy_error; }
  Value peak_reynolds() {
    const Parameters<double>& p = oscillator_.parameters();
    const double speed = summary_.greatest_flow * oscillator_.scales().length / clock_;
    return p.fluid_density * speed * 2 * p.orifice_radius / p.fluid_viscosity;
  }
  Value final_well() { return well_of(summary_.last.stretch); }
  Value switched() { return well_of(summary_.initial_stretch) == well_of(summary_.last.stretch) ? 0 : 1; }
  // NOLINTEND(readability-make-member-function-const)

  [[nodiscard]] Value seconds(const Value& time) const { return time ? Value(*time * clock_) : std::nullopt; }

  /// The well of a stretch at the final pressure, counted from 1: unstable equilibria are the walls between wells.
  double well_of(double stretch) {
    if (!states_) {
      const double pressure = oscillator_.pressure()(summary_.last.time) * oscillator_.scales().pressure;
      states_ = equilibria(oscillator_.parameters(), pressure);
    }
    return 1.0 + static_cast<double>(std::ranges::count_if(
                     *states_, [&](const Equilibrium& e) { return !e.stable && e.stretch < stretch; }));
  }

  /// In the order of quantity_names().
  static constexpr std::array<Value (Evaluator::*)(), 15> evaluators{
      &Evaluator::peak_stretch,     &Evaluator::peak_time,  &Evaluator::rise_time,  &Evaluator::fall_time,
      &Evaluator::final_stretch,    &Evaluator::final_rate, &Evaluator::end_time,   &Evaluator::events,
      &Evaluator::first_event_time, &Evaluator::inlet_work, &Evaluator::dissipated, &Evaluator::energy_error,
      &Evaluator::peak_reynolds,    &Evaluator::final_well, &Evaluator::switched};

  const Oscillator<double>& oscillator_;
  const MemberSummary& summary_;
  std::span<const TrajectoryStep<double>> steps_;
  double clock_;
  std::optional<std::vector<Equilibrium>> states_;
};

bool asks_for(std::span<const std::size_t> asked, std::initializer_list<std::string_view> names) {
  return std::ranges::any_of(
      asked, [&](std::size_t index) { return std::ranges::find(names, quantity_names()[index].name) != names.end(); });
}

double greatest_flow(const RunResult& result) {
  const OrificeSpeeds speeds = orifice_speeds(result);
  const Scales<double>& scales = result.oscillator->scales();
  return std::max(speeds.in, speeds.out) / (scales.length / scales.time);
}

}  // namespace

OrificeSpeeds orifice_speeds(const RunResult& result) {
  const double a = result.oscillator->parameters().orifice_radius;
  OrificeSpeeds greatest{0, 0};
  const auto include = [&](double time) {
    const double flow = physical_state(*result.oscillator, *result.trajectory, time).flow_rate;
    const double speed = flow / (std::numbers::pi * a * a);
    greatest = {std::max(greatest.in, speed), std::max(greatest.out, -speed)};
  };
  for (const auto& step : result.trajectory->steps) {
    for (const double theta : {0.0, 0.25, 0.5, 0.75}) include(step.start + theta * step.duration);
  }
  include(result.trajectory->last.time);
  return greatest;
}

SummaryOptions needed_for(std::span<const std::size_t> asked) {
  SummaryOptions options;
  options.energies = asks_for(asked, {"inlet_work", "dissipated", "energy_error"});
  options.flow = asks_for(asked, {"peak_reynolds"});
  options.steps = asks_for(asked, {"rise_time", "fall_time"});
  return options;
}

MemberSummary summary_of(const RunResult& result, const SummaryOptions& options) {
  const Trajectory<double>& trajectory = *result.trajectory;
  MemberSummary summary;
  summary.outcome = trajectory.outcome;
  summary.message = trajectory.message;
  summary.last = trajectory.last;
  summary.initial_stretch = trajectory.steps.empty() ? trajectory.last.stretch : trajectory.steps.front().stretch_at(0);
  summary.greatest_stretch = summary.least_stretch = summary.last.stretch;
  summary.peak_time = summary.last.time;
  for (const auto& step : trajectory.steps | std::views::reverse) {  // extrema lie at ends of steps
    summary.least_stretch = std::min(summary.least_stretch, step.stretch_at(0));
    if (step.stretch_at(0) < summary.greatest_stretch) continue;
    summary.greatest_stretch = step.stretch_at(0);
    summary.peak_time = step.start;  // the earliest of equals
  }
  summary.events = static_cast<long>(trajectory.events.size());
  if (summary.events > 0) summary.first_event_time = trajectory.events.front().time;
  const auto kept = std::min(options.events, trajectory.events.size());
  summary.first_events.assign(trajectory.events.begin(), trajectory.events.begin() + static_cast<std::ptrdiff_t>(kept));
  if (options.energies) {
    const std::unique_ptr<EnergyLedger> own =
        result.energies ? nullptr : std::make_unique<EnergyLedger>(*result.oscillator, trajectory);
    const EnergyLedger& ledger = own ? *own : *result.energies;
    const Energies last = ledger.at(trajectory.last.time);
    const double unit = result.oscillator->scales().energy();
    summary.inlet_work = last.inlet_work / unit;
    summary.dissipated = last.dissipated / unit;
    summary.energy_error = ledger.closure_error();
  }
  if (options.flow) summary.greatest_flow = greatest_flow(result);
  return summary;
}

std::vector<std::optional<double>> evaluate_quantities(const Oscillator<double>& oscillator,
                                                       const MemberSummary& summary,
                                                       std::span<const TrajectoryStep<double>> steps,
                                                       std::span<const std::size_t> asked) {
  Evaluator evaluate(oscillator, summary, steps);
  std::vector<std::optional<double>> values;
  values.reserve(asked.size());
  for (const std::size_t index : asked) values.push_back(evaluate(index));
  return values;
}

std::vector<Quantity> quantities_of_interest(const RunResult& result) {
  std::vector<std::size_t> all(quantity_names().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const MemberSummary summary = summary_of(result, needed_for(all));
  const auto values = evaluate_quantities(*result.oscillator, summary, result.trajectory->steps, all);
  std::vector<Quantity> quantities;
  for (const std::size_t i : all) {
    const QuantityName& name = quantity_names()[i];
    quantities.push_back({std::string(name.name), std::string(name.unit), values[i]});
  }
  return quantities;
}

}  // namespace turgor
