#include <algorithm>
#include <optional>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/membrane_study.hpp"

namespace turgor {

namespace {

std::string place(const Case& c, const MembraneState& state) {
  return "r_eff = " + rounded(state.radius, 5) + " m (R = " + rounded(state.radius / c.parameters.radius, 5) + ")";
}

/// The first limit point; nothing when the membrane has none near that of (3.1).
std::optional<MembraneState> first_limit(const Case& c, const Membrane& membrane, const LimitPoint& sphere) {
  constexpr double beyond = 1.2;
  try {
    return limit_point(membrane, balloon_volume(c.parameters, beyond * sphere.stretch));
  } catch (const ComputationFailed&) {
    return std::nullopt;
  }
}

/// The stable state of a pressure beyond a limit point: near that of (3.1), if there is one.
std::optional<MembraneState> state_beyond(const Case& c, const Membrane& membrane, const MembraneState& limit,
                                          double pressure) {
  for (const Equilibrium& sphere : equilibria(c.parameters, pressure)) {
    if (!sphere.stable || sphere.stretch * c.parameters.radius < limit.radius) continue;
    try {
      const MembraneState near = hold_volume(membrane, limit, balloon_volume(c.parameters, sphere.stretch));
      return hold_pressure(membrane, near, pressure);
    } catch (const ComputationFailed&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

void warn_of_limit(const Case& c, const Membrane& membrane, double greatest, std::vector<Warning>& warnings) {
  constexpr double near = 0.9;  // the hole makes the membrane stiffer, not softer
  const std::vector<LimitPoint> spheres = limit_points(c.parameters);
  if (spheres.empty() || greatest < near * spheres.front().pressure) return;
  const std::optional<MembraneState> limit = first_limit(c, membrane, spheres.front());
  if (!limit || greatest <= limit->pressure) return;
  if (c.stretch * c.parameters.radius > limit->radius) return;  // it starts beyond, and may well be on the next branch
  const std::optional<MembraneState> beyond = state_beyond(c, membrane, *limit, greatest);
  warnings.push_back(
      {"membrane-limit", "the gauge pressure of [pressure] reaches " + rounded(greatest, 5) +
                             " Pa, above the membrane's limit point of " + rounded(limit->pressure, 6) + " Pa at " +
                             place(c, *limit) + ": unless it falls in time the balloon " +
                             (beyond ? "snaps; the next stable state at that pressure is at " + place(c, *beyond)
                                     : "bursts, no stable state at that pressure is known") +
                             "; `turgor fem statics` shows the whole curve"});
}

void warn_of_suction(const Membrane& membrane, double least, std::vector<Warning>& warnings) {
  if (least >= 0) return;
  try {
    (void)hold_pressure(membrane, slack_state(membrane), least);
  } catch (const ComputationFailed& failure) {
    warnings.push_back({"membrane-buckling", "the gauge pressure of [pressure] falls to " + rounded(least, 5) +
                                                 " Pa, at which the slack membrane buckles: " + failure.what()});
  }
}

/// @throws InvalidInput when the volume of [initial] has no state of rest
void warn_of_start(const Case& c, const Membrane& membrane, std::vector<Warning>& warnings) {
  if (c.stretch >= 1) return;
  try {
    const MembraneState state = hold_volume(membrane, slack_state(membrane), balloon_volume(c.parameters, c.stretch));
    const int modes = unstable_modes(membrane, state).at_volume;
    if (modes == 0) return;
    warnings.push_back({"membrane-buckling", "at initial.stretch = " + rounded(c.stretch, 5) +
                                                 " the membrane is compressed, with " + std::to_string(modes) +
                                                 " ways to buckle at that volume: the start is not stable"});
  } catch (const ComputationFailed& failure) {
    throw InvalidInput(
        {{"initial.stretch", shortest(c.stretch), failure.what(), "start from 1, or from above", c.file.string(), 0}});
  }
}

}  // namespace

std::vector<Warning> membrane_warnings(const Case& c) {
  const PressureRange<double> range = range_of(c.pressure, c.solve.t_end);
  const Membrane membrane = membrane_of(c);
  std::vector<Warning> warnings;
  warn_of_start(c, membrane, warnings);
  warn_of_suction(membrane, range.least, warnings);
  warn_of_limit(c, membrane, range.greatest, warnings);
  return warnings;
}

}  // namespace turgor
