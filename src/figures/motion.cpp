#include "motion.hpp"

#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/integrate/quadrature.hpp"
#include "turgor/run/asymptotics.hpp"

namespace turgor {

Trajectory<double> LargeMotion::exact(double start, double end, long events) const {
  SimulationOptions<double> options;
  options.max_events = events;
  Trajectory<double> trajectory = simulate_by_quadrature(oscillator, 0.0, start, 0.0, end, options);
  if (!is_complete(trajectory.outcome)) throw ComputationFailed(of.title + ": " + trajectory.message);
  return trajectory;
}

LargeMotion large_motion(const Studio& studio, const std::string& case_name) {
  const double pressure = mean_limit_pressure(studio.read(case_name).parameters);
  Case c = studio.read(case_name, {held_at(pressure)});
  const FreeMotion motion = asymptotics_report(c).motions.back().motion;
  Oscillator<double> oscillator(motion.model(), c.parameters, c.pressure, motion.scales());
  return {std::move(c), std::move(oscillator), motion};
}

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) values.push_back(std::lerp(from, to, static_cast<double>(k) / (count - 1)));
  return values;
}

std::vector<double> in_equal_ratios(double from, double to, int count) {
  std::vector<double> values = evenly(std::log(from), std::log(to), count);
  for (double& value : values) value = std::exp(value);
  values.front() = from;
  values.back() = to;
  return values;
}

}  // namespace turgor
