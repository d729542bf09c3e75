#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <ranges>

#include "parts.hpp"
#include "turgor/case/quantities.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

namespace {

/// First time in [from, to] at which the stretch crosses a level, going the way it is asked to; dimensionless.
std::optional<double> first_crossing(const Trajectory<double>& trajectory, double level, bool upwards, double from,
                                     double to) {
  const double s = upwards ? 1 : -1;
  for (const auto& step : trajectory.steps) {
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
std::optional<double> ten_to_ninety(const Trajectory<double>& trajectory, double first, double last, double from,
                                    double to) {
  const double way = last - first;
  if (!(std::abs(way) > 1e-12)) return std::nullopt;
  const auto begin = first_crossing(trajectory, first + 0.1 * way, way > 0, from, to);
  const auto end = first_crossing(trajectory, first + 0.9 * way, way > 0, from, to);
  if (!begin || !end) return std::nullopt;
  return *end - *begin;
}

/// Evaluates one quantity at a time, and what several of them need only once.
class Evaluator {
 public:
  explicit Evaluator(const RunResult& result)
      : result_(result), trajectory_(*result.trajectory), clock_(result.oscillator->scales().time) {
    start_ = trajectory_.steps.empty() ? 0 : trajectory_.steps.front().start;
    end_ = trajectory_.last.time;
    initial_ = trajectory_.at(start_).stretch;
    peak_ = trajectory_.last.stretch;
    peak_time_ = end_;
    for (const auto& step : trajectory_.steps | std::views::reverse) {
      if (step.stretch_at(0) >= peak_) {  // the earliest of equals
        peak_ = step.stretch_at(0);
        peak_time_ = step.start;
      }
    }
  }

  /// @param index  in quantity_names()
  std::optional<double> operator()(std::size_t index) { return (this->*evaluators.at(index))(); }

 private:
  using Value = std::optional<double>;

  // NOLINTBEGIN(readability-make-member-function-const): one type for all; some keep what others need again
  Value peak_stretch() { return peak_; }
  Value peak_time() { return peak_time_ * clock_; }
  Value rise_time() { return seconds(ten_to_ninety(trajectory_, initial_, peak_, start_, peak_time_)); }
  Value fall_time() { return seconds(ten_to_ninety(trajectory_, peak_, trajectory_.last.stretch, peak_time_, end_)); }
  Value final_stretch() { return trajectory_.last.stretch; }
  Value final_rate() { return trajectory_.last.rate / clock_; }
  Value end_time() { return end_ * clock_; }
  Value events() { return static_cast<double>(trajectory_.events.size()); }
  Value first_event_time() {
    return trajectory_.events.empty() ? std::nullopt : Value(trajectory_.events.front().time * clock_);
  }
  Value inlet_work() { return energies().at(end_).inlet_work; }
  Value dissipated() { return energies().at(end_).dissipated; }
  Value energy_error() { return energies().closure_error(); }
  Value peak_reynolds() {
    const Parameters<double>& p = result_.oscillator->parameters();
    const auto flow = [&](double time) {
      return std::abs(physical_state(*result_.oscillator, trajectory_, time).flow_rate);
    };
    double greatest_flow = flow(end_);
    for (const auto& step : trajectory_.steps) {
      for (const double theta : {0.0, 0.25, 0.5, 0.75}) {
        greatest_flow = std::max(greatest_flow, flow(step.start + theta * step.duration));
      }
    }
    const double speed = greatest_flow / (std::numbers::pi * p.orifice_radius * p.orifice_radius);
    return p.fluid_density * speed * 2 * p.orifice_radius / p.fluid_viscosity;
  }
  Value final_well() { return well_of(trajectory_.last.stretch); }
  Value switched() { return well_of(initial_) == well_of(trajectory_.last.stretch) ? 0 : 1; }
  // NOLINTEND(readability-make-member-function-const)

  [[nodiscard]] Value seconds(const Value& time) const { return time ? Value(*time * clock_) : std::nullopt; }

  const EnergyLedger& energies() {
    if (result_.energies) return *result_.energies;
    if (!own_energies_) own_energies_.emplace(*result_.oscillator, trajectory_);
    return *own_energies_;
  }

  /// The well of a stretch at the final pressure, counted from 1: unstable equilibria are the walls between wells.
  double well_of(double stretch) {
    if (!states_) {
      const Oscillator<double>& oscillator = *result_.oscillator;
      states_ = equilibria(oscillator.parameters(), oscillator.pressure()(end_) * oscillator.scales().pressure);
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

  const RunResult& result_;
  const Trajectory<double>& trajectory_;
  double clock_, start_, end_, initial_, peak_, peak_time_;
  std::optional<EnergyLedger> own_energies_;
  std::optional<std::vector<Equilibrium>> states_;
};

}  // namespace

std::vector<std::optional<double>> evaluate_quantities(const RunResult& result, std::span<const std::size_t> asked) {
  Evaluator evaluate(result);
  std::vector<std::optional<double>> values;
  values.reserve(asked.size());
  for (const std::size_t index : asked) values.push_back(evaluate(index));
  return values;
}

std::vector<Quantity> quantities_of_interest(const RunResult& result) {
  Evaluator evaluate(result);
  std::vector<Quantity> quantities;
  for (std::size_t i = 0; i < quantity_names().size(); ++i) {
    const QuantityName& name = quantity_names()[i];
    quantities.push_back({std::string(name.name), std::string(name.unit), evaluate(i)});
  }
  return quantities;
}

}  // namespace turgor
