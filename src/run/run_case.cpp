#include "turgor/run/run_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/integrate/quadrature.hpp"

namespace turgor {

Oscillator<double> make_oscillator(const Case& c, Model model) {
  return Oscillator<double>(model, c.parameters, c.pressure, natural_scales(c.parameters, c.pressure, c.solve.t_end));
}

PhysicalState physical_state(const Oscillator<double>& oscillator, const Trajectory<double>& trajectory, double time) {
  const Point<double> point = trajectory.at(time);
  const Parameters<double>& p = oscillator.parameters();
  const Scales<double>& scales = oscillator.scales();
  const double r = scales.length * point.stretch;
  const double rate = point.rate / scales.time;
  const double eps = cap_depth(p.orifice_radius / r);
  const double cap = std::numbers::pi * power<3>(r) * eps * eps * (3 - eps) / 3;
  const double speed = channel_speed(eps) * scales.length * rate;  // v_z of (2.1)
  return {time * scales.time,
          point.stretch,
          rate,
          r,
          oscillator.pressure()(time) * scales.pressure,
          point.regime,
          4 * std::numbers::pi / 3 * power<3>(r) - cap,
          std::numbers::pi * p.orifice_radius * p.orifice_radius * speed};
}

StretchRange stretch_range(const Trajectory<double>& trajectory) {
  StretchRange range{trajectory.last.stretch, trajectory.last.stretch};
  for (const auto& step : trajectory.steps) {  // extrema lie at ends of steps, where the rate vanishes
    range.least = std::min(range.least, step.stretch_at(0));
    range.greatest = std::max(range.greatest, step.stretch_at(0));
  }
  return range;
}

namespace {

Trajectory<double> integrate(const Case& c, const Member& member, const Progress& progress) {
  SimulationOptions<double> options = member.options;
  const double clock = member.oscillator.scales().time;
  if (progress) options.keep_going = [&](const double& time) { return progress(time * clock); };
  const auto& method = c.solve.method == Method::quadrature ? simulate_by_quadrature<double> : simulate<double>;
  return method(member.oscillator, 0.0, member.stretch, member.rate, member.end_time, options);
}

/// Every simpler model's dropped terms over the range; for an explicitly chosen model only its own.
ModelChoice compare_models(const Case& c, const StretchRange& range) {
  const Parameters<double>& p = c.parameters;
  ModelChoice choice{c.model.value_or(simplest_model(p, range.least, range.greatest, c.auto_tolerance)),
                     !c.model,
                     range.least,
                     range.greatest,
                     {}};
  for (const Model model : {Model::orifice, Model::long_channel}) {
    if (c.model ? *c.model == model : (model == Model::orifice) == (p.channel_length == 0)) {
      choice.dropped.emplace_back(model, dropped_terms(model, p, range.least, range.greatest));
    }
  }
  return choice;
}

std::vector<ExpectationResult> check(const Case& c, const RunResult& result) {
  std::vector<ExpectationResult> checked;
  for (const Expectation& expected : c.expectations) {
    const auto found = result.quantity(expected.quantity);
    checked.push_back({expected, found, found && std::abs(*found - expected.value) <= expected.tolerance});
  }
  return checked;
}

}  // namespace

Member make_member(const Case& c, Model model) {
  Member member{make_oscillator(c, model), c.stretch, 0, 0, {}};
  const double clock = member.oscillator.scales().time;
  member.rate = c.stretch_rate * clock;
  member.end_time = c.solve.t_end / clock;
  member.options.rtol = c.solve.rtol;
  member.options.atol = c.solve.atol;
  member.options.max_events = c.solve.max_events;
  member.options.rest_tol = c.solve.rest_tol;
  member.options.max_stretch = c.max_stretch;
  member.options.max_steps = c.solve.max_steps;
  return member;
}

RunResult run_motion(const Case& c, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  RunResult result;
  Member member = make_member(c, c.model.value_or(Model::full));
  result.trajectory = std::make_unique<Trajectory<double>>(integrate(c, member, progress));
  result.choice = compare_models(c, stretch_range(*result.trajectory));
  if (result.choice.model != member.oscillator.model() && is_complete(result.trajectory->outcome)) {
    // The full model has shown which stretches the run visits; the simpler one is good enough there.
    member = make_member(c, result.choice.model);
    *result.trajectory = integrate(c, member, progress);
  }
  result.oscillator = std::make_unique<Oscillator<double>>(std::move(member.oscillator));
  result.choice.model = result.oscillator->model();
  result.integration_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

namespace {

/// Everything of a result that follows from its motion.
void conclude(const Case& c, RunResult& result) {
  result.energies = std::make_unique<EnergyLedger>(*result.oscillator, *result.trajectory);
  result.quantities = quantities_of_interest(result);
  result.warnings = strained_assumptions(c, result);
  result.expectations = check(c, result);
}

}  // namespace

RunResult run_case(const Case& c, const Progress& progress) {
  RunResult result = run_motion(c, progress);
  conclude(c, result);
  return result;
}

RunResult restored_run(const Case& c, const ModelChoice& choice, Trajectory<double> trajectory,
                       double integration_seconds) {
  RunResult result;
  result.oscillator = std::make_unique<Oscillator<double>>(make_oscillator(c, choice.model));
  result.trajectory = std::make_unique<Trajectory<double>>(std::move(trajectory));
  result.choice = compare_models(c, {choice.least_stretch, choice.greatest_stretch});
  result.choice.model = choice.model;
  result.integration_seconds = integration_seconds;
  conclude(c, result);
  return result;
}

std::string RunResult::status() const {
  if (trajectory->outcome == Outcome::interrupted) return "interrupted";
  return is_complete(trajectory->outcome) ? "complete" : "failed";
}

bool RunResult::expectations_met() const {
  return std::ranges::all_of(expectations, [](const ExpectationResult& e) { return e.met; });
}

std::optional<double> RunResult::quantity(std::string_view name) const {
  for (const Quantity& quantity : quantities) {
    if (quantity.name == name) return quantity.value;
  }
  return std::nullopt;
}

}  // namespace turgor
