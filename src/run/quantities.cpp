#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <ranges>

#include "parts.hpp"
#include "turgor/case/quantities.hpp"

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

double peak_reynolds(const RunResult& result) {
  const Parameters<double>& p = result.oscillator->parameters();
  const Trajectory<double>& trajectory = *result.trajectory;
  const auto flow = [&](double time) {
    return std::abs(physical_state(*result.oscillator, trajectory, time).flow_rate);
  };
  double greatest_flow = flow(trajectory.last.time);
  for (const auto& step : trajectory.steps) {
    for (const double theta : {0.0, 0.25, 0.5, 0.75}) {
      greatest_flow = std::max(greatest_flow, flow(step.start + theta * step.duration));
    }
  }
  const double speed = greatest_flow / (std::numbers::pi * p.orifice_radius * p.orifice_radius);
  return p.fluid_density * speed * 2 * p.orifice_radius / p.fluid_viscosity;
}

}  // namespace

std::vector<Quantity> quantities_of_interest(const RunResult& result) {
  const Trajectory<double>& trajectory = *result.trajectory;
  const double clock = result.oscillator->scales().time;
  const double start = trajectory.steps.empty() ? 0 : trajectory.steps.front().start;
  const double end = trajectory.last.time;
  const double initial = trajectory.at(start).stretch;
  double peak = trajectory.last.stretch;
  double peak_time = end;
  for (const auto& step : trajectory.steps | std::views::reverse) {
    if (step.stretch_at(0) >= peak) {  // the earliest of equals
      peak = step.stretch_at(0);
      peak_time = step.start;
    }
  }
  const auto seconds = [&](std::optional<double> time) {
    return time ? std::optional<double>(*time * clock) : std::nullopt;
  };
  const Energies last = result.energies->at(end);
  const std::vector<std::optional<double>> values{
      peak,
      peak_time * clock,
      seconds(ten_to_ninety(trajectory, initial, peak, start, peak_time)),
      seconds(ten_to_ninety(trajectory, peak, trajectory.last.stretch, peak_time, end)),
      trajectory.last.stretch,
      trajectory.last.rate / clock,
      end * clock,
      static_cast<double>(trajectory.events.size()),
      trajectory.events.empty() ? std::nullopt : std::optional<double>(trajectory.events.front().time * clock),
      last.inlet_work,
      last.dissipated,
      result.energies->closure_error(),
      peak_reynolds(result),
  };
  std::vector<Quantity> quantities;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const QuantityName& name = quantity_names()[i];
    quantities.push_back({std::string(name.name), std::string(name.unit), values[i]});
  }
  return quantities;
}

}  // namespace turgor
