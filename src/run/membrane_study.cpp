#include "turgor/run/membrane_study.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/run/static_study.hpp"

namespace turgor {

namespace {

constexpr std::size_t chain_elements = 48;

std::string in_pascal(double pressure) { return rounded(pressure, 6) + " Pa"; }

/// Places and energies of a state; its modes are to be filled in.
MembraneRow row_of(const Case& c, const Membrane& membrane, const MembraneState& state) {
  const double stretch = state.radius / c.parameters.radius;
  double greatest = 0;
  for (Eigen::Index i = 0; i < state.places.size(); i += 2) greatest = std::max(greatest, state.places(i));
  return {.state = state,
          .stretch = stretch,
          .sphere_pressure = static_pressure(c.parameters, stretch).value,
          .top = state.places(state.places.size() - 1),
          .greatest_radius = greatest,
          .energy = 2 * std::numbers::pi * membrane.elastic(state.places).value,
          .unstable = {}};
}

MembraneRow row_with_modes(const Case& c, const Membrane& membrane, const MembraneState& state) {
  MembraneRow row = row_of(c, membrane, state);
  row.unstable = unstable_modes(membrane, state);
  return row;
}

/// Rows of a curve. At a limit point an eigenvalue is zero but for rounding, so the neighbours decide there; slack has
/// the least energy of all.
std::vector<MembraneRow> rows_of(const Case& c, const Membrane& membrane, const InflationCurve& curve) {
  std::vector<MembraneRow> rows;
  for (const MembraneState& state : curve.states) rows.push_back(row_of(c, membrane, state));
  for (const std::size_t i : curve.limit_points) rows[i].limit_point = true;
  for (MembraneRow& row : rows) {
    if (!row.limit_point && row.state.pressure != 0) row.unstable = unstable_modes(membrane, row.state);
  }
  for (const std::size_t i : curve.limit_points) {
    const UnstableModes& before = rows[i - 1].unstable;
    const UnstableModes& after = rows[i + 1].unstable;
    rows[i].unstable = {std::min(before.at_pressure, after.at_pressure), std::min(before.at_volume, after.at_volume)};
  }
  return rows;
}

std::vector<MembraneLimit> limits_of(const Case& c, const std::vector<MembraneRow>& curve) {
  const std::vector<LimitPoint> spheres = limit_points(c.parameters);
  std::vector<MembraneLimit> limits;
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    if (!curve[i].limit_point) continue;
    MembraneLimit limit{curve[i], curve[i - 1].state.pressure < curve[i].state.pressure, std::nullopt};
    const std::size_t number = limits.size();
    if (number < spheres.size() && spheres[number].maximum == limit.maximum) limit.sphere = spheres[number];
    limits.push_back(std::move(limit));
  }
  return limits;
}

/// The state of a pressure between two of the curve, stable or not.
MembraneState state_between(const Membrane& membrane, const MembraneState& below, const MembraneState& above,
                            double pressure) {
  MembraneState last = below;
  const auto excess = [&](double volume) {
    last = hold_volume(membrane, last, volume);
    return last.pressure - pressure;
  };
  std::uintmax_t iterations = 60;
  const auto [lo, hi] = boost::math::tools::toms748_solve(excess, below.volume, above.volume, below.pressure - pressure,
                                                          above.pressure - pressure,
                                                          boost::math::tools::eps_tolerance<double>(40), iterations);
  return hold_volume(membrane, last, (lo + hi) / 2);
}

std::vector<MembraneRow> on_the_curve(const Case& c, const Membrane& membrane, const std::vector<MembraneRow>& curve,
                                      double pressure) {
  std::vector<MembraneRow> found;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double here = curve[i].state.pressure - pressure;
    if (here == 0) found.push_back(curve[i]);
    if (i + 1 == curve.size()) break;
    if (here * (curve[i + 1].state.pressure - pressure) < 0) {
      found.push_back(
          row_with_modes(c, membrane, state_between(membrane, curve[i].state, curve[i + 1].state, pressure)));
    }
  }
  return found;
}

/// Equilibria under suction, which the curve does not have: at most the one that slack leads to.
void add_under_suction(const Case& c, const Membrane& membrane, MembraneStudy& study) {
  try {
    study.equilibria.push_back(
        row_with_modes(c, membrane, hold_pressure(membrane, slack_state(membrane), study.pressure)));
  } catch (const ComputationFailed& failure) {
    study.why_none = failure.what();
    study.advice = "ask for a pressure closer to 0";
  }
}

void explain_none(MembraneStudy& study) {
  const MembraneRow& end = study.curve.back();
  const std::string range = "no state of rest up to R = " + rounded(end.stretch, 6);
  for (const Equilibrium& state : study.sphere) {
    if (state.stretch < end.stretch) continue;
    study.why_none = range + "; the sphere of (3.1) has one at R = " + rounded(state.stretch, 6);
    study.advice = "try --up-to " + rounded(1.1 * state.stretch, 3);
    return;
  }
  study.why_none = range;
  study.advice = "there the pressure is " + in_pascal(end.state.pressure) + "; ask for less, or try a larger --up-to";
  if (study.limits.empty()) return;
  const MembraneRow& limit = study.limits.front().row;
  study.why_none += ": the balloon bursts, nothing holds it beyond its limit point, " +
                    in_pascal(limit.state.pressure) + " at r_eff = " + rounded(limit.state.radius, 6) +
                    " m (R = " + rounded(limit.stretch, 6) + ")";
  study.advice = "ask for less pressure, or for states beyond by --volume";
}

void add_equilibria(const Case& c, const Membrane& membrane, MembraneStudy& study) {
  study.sphere = equilibria(c.parameters, study.pressure);
  if (study.pressure < 0) {
    add_under_suction(c, membrane, study);
    return;
  }
  study.equilibria = on_the_curve(c, membrane, study.curve, study.pressure);
  if (study.equilibria.empty()) explain_none(study);
}

MembraneRow row_at_volume(const Case& c, const Membrane& membrane, const MembraneStudy& study, double volume) {
  const auto apart = [&](const MembraneRow& row) { return std::abs(row.state.volume - volume); };
  const MembraneRow& nearest = *std::ranges::min_element(study.curve, {}, apart);
  try {
    return row_with_modes(c, membrane, hold_volume(membrane, nearest.state, volume));
  } catch (const ComputationFailed& failure) {
    throw InvalidInput("--volume", rounded(volume, 8) + " m^3", failure.what(),
                       "slack it has " + rounded(study.curve.front().state.volume, 6) +
                           " m^3, with less it buckles; at the end of the curve " +
                           rounded(study.curve.back().state.volume, 6) + " m^3");
  }
}

/// Beyond everything that (3.1) has to show, but not into the rise in which a material locks.
double default_end(const Case& c, StaticStudy sphere, double pressure) {
  sphere.pressure = pressure;
  sphere.equilibria = equilibria(c.parameters, pressure);
  double highest = c.parameters.thickness * shear_modulus(c.parameters.material) / c.parameters.radius;
  for (const LimitPoint& point : sphere.limit_points) highest = std::max(highest, point.pressure);
  highest = 2 * std::max(highest, pressure);
  double end = 1.001;
  for (const StaticRow& row : static_curve(c, sphere)) {
    if (row.stretch > end && row.pressure < highest) end = row.stretch;
  }
  constexpr double least = 2.2;
  return end < least && static_pressure(c.parameters, least).value < highest ? least : end;
}

double checked_end(const Case& c, double up_to) {
  const double limit = std::min(stretch_limit(c.parameters.material), largest_stretch);
  if (up_to > 1 && up_to < limit) return up_to;
  throw InvalidInput("--up-to", shortest(up_to), "out of range",
                     "allowed is > 1, without pressure, and < " + rounded(limit, 6) +
                         (limit < largest_stretch ? ", where the material locks" : ""));
}

InflationCurve curve_up_to(const Case& c, const Membrane& membrane, double stretch) {
  try {
    return inflation_curve(membrane, slack_state(membrane), balloon_volume(c.parameters, stretch));
  } catch (const ComputationFailed& failure) {
    throw ComputationFailed("on the way to R = " + rounded(stretch, 6) + ": " + failure.what() +
                            "; try a smaller --up-to");
  }
}

}  // namespace

MembraneWall wall_of(const Case& c) {
  const auto& p = c.parameters;
  if (std::holds_alternative<Tabulated<double>>(p.material)) refuse_two_stretches();
  return {.material = p.material,
          .thickness = p.thickness,
          .density = p.solid_density,
          .bending_stiffness = c.wall.bending_stiffness,
          .damping_time = c.wall.damping_time,
          .rim = c.wall.clamped ? Rim::clamped : Rim::hinged};
}

Membrane membrane_of(const Case& c) {
  const auto& p = c.parameters;
  return {spherical_meridian(p.radius, p.orifice_radius, chain_elements, p.radius / p.orifice_radius), wall_of(c)};
}

double balloon_volume(const Parameters<double>& p, double stretch) {
  const double depth = cap_depth(kappa_at(p, stretch));
  return std::numbers::pi / 3 * std::pow(p.radius * stretch, 3) * (4 - depth * depth * (3 - depth));
}

MembraneStudy study_membrane(const Case& c, const MembraneQuestions& questions) {
  const StaticStudy sphere = study_statics(c, {});
  const Membrane membrane = membrane_of(c);
  MembraneStudy study{};
  study.wall = membrane.wall();
  study.elements = chain_elements;
  study.pressure = questions.pressure.value_or(sphere.pressure);
  const double end = questions.up_to ? checked_end(c, *questions.up_to) : default_end(c, sphere, study.pressure);
  study.curve = rows_of(c, membrane, curve_up_to(c, membrane, end));
  study.limits = limits_of(c, study.curve);
  if (questions.limit_point && study.limits.empty()) {
    throw InvalidInput("--limit-point", "", "there is none up to R = " + rounded(study.curve.back().stretch, 6),
                       "the pressure rises all the way to " + in_pascal(study.curve.back().state.pressure) +
                           "; try a larger --up-to, or leave out --limit-point");
  }
  add_equilibria(c, membrane, study);
  if (questions.pressure && study.equilibria.empty()) {
    throw InvalidInput("--pressure", rounded(*questions.pressure, 8) + " Pa", study.why_none, study.advice);
  }
  if (questions.volume) study.at_volume = row_at_volume(c, membrane, study, *questions.volume);
  return study;
}

std::vector<MembraneRow> shapes_of(const MembraneStudy& study) {
  constexpr int evenly = 5;
  const double first = study.curve.front().stretch;
  const double last = study.curve.back().stretch;
  std::vector<MembraneRow> shapes;
  for (int k = 0; k <= evenly; ++k) {
    const double wanted = first + (last - first) * k / evenly;
    const auto apart = [&](const MembraneRow& row) { return std::abs(row.stretch - wanted); };
    shapes.push_back(*std::ranges::min_element(study.curve, {}, apart));
  }
  for (const MembraneLimit& limit : study.limits) shapes.push_back(limit.row);
  std::ranges::sort(shapes, {}, [](const MembraneRow& row) { return row.state.volume; });
  const auto [same, end] = std::ranges::unique(shapes, {}, [](const MembraneRow& row) { return row.state.volume; });
  shapes.erase(same, end);
  return shapes;
}

}  // namespace turgor
