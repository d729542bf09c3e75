#include "turgor/run/force_history.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/report.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;
using Motion = PrescribedMotion<double>;

/// The force by one closure at time t in a phase of the motion.
double force_within(const Case& c, Closure closure, const Motion::Phase& phase, double t) {
  return forces_at(c, {closure}, t, dictated_motion(c).within(phase, t)).all.front();
}

/// The greatest force in size: the best of a grid, then Brent's method between its neighbours.
ForcePeak peak_in(const Case& c, Closure closure, const Motion::Interval& in) {
  constexpr int grid = 64;  // a force has a few extrema in a phase
  const auto time = [&](int i) { return i == grid ? in.end : in.begin + (in.end - in.begin) * i / grid; };
  const auto force = [&](double t) { return force_within(c, closure, in.phase, t); };
  int best = 0;
  for (int i = 1; i <= grid; ++i) {
    if (std::abs(force(time(i))) > std::abs(force(time(best)))) best = i;
  }
  const ForcePeak on_grid{force(time(best)), time(best)};
  constexpr int bits = std::numeric_limits<double>::digits / 2;  // a minimum is no better defined
  const auto [t, size] =
      boost::math::tools::brent_find_minima([&](double at) { return -std::abs(force(at)); },
                                            time(std::max(best - 1, 0)), time(std::min(best + 1, grid)), bits);
  return -size > std::abs(on_grid.force) ? ForcePeak{force(t), t} : on_grid;
}

void keep_greater(std::optional<ForcePeak>& peak, const ForcePeak& other) {
  if (!peak || std::abs(other.force) > std::abs(peak->force)) peak = other;
}

ForceSummary summary_of(const Case& c, Closure closure) {
  std::optional<ForcePeak> peak;
  ForceSummary summary{closure, {}, {}, {}, 0, 0};
  // The integrands are polynomials of degree up to 51, r^6 (dr/dt)^3 of a smooth ramp, or such times smooth factors.
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  for (const Motion::Interval& in : dictated_motion(c).intervals(c.solve.t_end)) {
    const ForcePeak here = peak_in(c, closure, in);
    keep_greater(peak, here);
    if (in.phase.regime == Regime::inflating) keep_greater(summary.inflating, here);
    if (in.phase.regime == Regime::deflating) keep_greater(summary.deflating, here);
    const auto force = [&](double t) { return force_within(c, closure, in.phase, t); };
    summary.impulse += Gauss::integrate(force, in.begin, in.end);
    summary.work += Gauss::integrate([&](double t) { return force(t) * in.phase.velocity(t); }, in.begin, in.end);
  }
  summary.peak = peak.value_or(ForcePeak{0, 0});  // there is at least one phase
  return summary;
}

std::string column_name(Closure closure) { return "force_" + std::string(name_of(closure)); }

Json to_json(const std::optional<ForcePeak>& peak) {
  return peak ? Json{{"force_N", peak->force}, {"t_s", peak->time}} : Json(nullptr);
}

}  // namespace

std::vector<Closure> compared_closures(const Case& c) {
  const Parameters<double>& p = c.parameters;
  const RadiusRange<double> radius = range_of(dictated_motion(c), c.solve.t_end);
  std::vector<Closure> compared;
  for (const Closure closure : all_closures) {
    const bool own = closure == p.closure;
    const bool known = closure != Closure::profile &&
                       (!has_table(closure) || (p.orifice_radius / radius.least <= ForceTable::greatest_kappa &&
                                                p.orifice_radius / radius.greatest >= ForceTable::least_kappa));
    if (own || known) compared.push_back(closure);
  }
  return compared;
}

ClosureForces forces_at(const Case& c, const std::vector<Closure>& closures, double time, const Motion::State& state) {
  const Parameters<double>& p = c.parameters;
  const FlowState<double> flow{state.radius,     state.rate,       state.acceleration, c.pressure(time),
                               p.orifice_radius, p.channel_length, p.fluid_density};
  const ForceTable* outflow = p.outflow.get();
  ClosureForces forces{{}, force_parts(p.closure, state.regime, flow, outflow)};
  bool finite = std::isfinite(forces.parts.sum());
  for (const Closure closure : closures) {
    forces.all.push_back(generalized_force(closure, state.regime, flow, outflow));
    finite = finite && std::isfinite(forces.all.back());
  }
  if (finite) return forces;
  throw InvalidInput("motion.velocity", "",
                     "the force at t = " + shortest(time) + " s is not a finite number (r = " + rounded(state.radius) +
                         " m, dr/dt = " + rounded(state.rate) + " m/s, d2r/dt2 = " + rounded(state.acceleration) +
                         " m/s^2)",
                     "move more slowly");
}

ForceHistory force_history(const Case& c) {
  ForceHistory history{{}, range_of(dictated_motion(c), c.solve.t_end), {}};
  const double r0 = c.parameters.radius;
  history.warnings = strained_orifice(c.parameters, {history.radius.least / r0, history.radius.greatest / r0});
  for (const Closure closure : compared_closures(c)) history.closures.push_back(summary_of(c, closure));
  return history;
}

std::string force_csv(const Case& c) {
  const OutputSettings& o = c.output;
  const double s = unit_factor(o.time_unit, "s");
  const double m = unit_factor(o.length_unit, "m");
  const std::string speed = o.length_unit + "/" + o.time_unit;
  std::string out = "t [" + o.time_unit + "],r [" + o.length_unit + "],drdt [" + speed + "],d2rdt2 [" + speed +
                    "^2],kappa [1],regime";
  const std::vector<Closure> closures = compared_closures(c);
  for (const Closure closure : closures) out += "," + column_name(closure) + " [N]";
  out += ",static [N],channel_inertial [N],channel_centripetal [N],balloon_inertial [N],balloon_centripetal [N]\n";
  const Motion& motion = dictated_motion(c);
  for (const double t : requested_times(c.solve)) {
    const Motion::State state = motion.at(t);
    const ClosureForces forces = forces_at(c, closures, t, state);
    append_number(out, t, s);
    const auto column = [&](double value, double factor = 1) {
      out += ',';
      append_number(out, value, factor);
    };
    column(state.radius, m);
    column(state.rate, m / s);
    column(state.acceleration, m / s / s);
    column(c.parameters.orifice_radius / state.radius);
    out += ',' + std::to_string(static_cast<int>(state.regime));
    for (const double force : forces.all) column(force);
    const ForceParts<double>& parts = forces.parts;
    for (const double part : {parts.statics, parts.channel_inertial, parts.channel_centripetal, parts.balloon_inertial,
                              parts.balloon_centripetal}) {
      column(part);
    }
    out += '\n';
  }
  return out;
}

std::string force_json(const Case& c, const ForceHistory& history) {
  Json closures = Json::object();
  for (const ForceSummary& of : history.closures) {
    closures[std::string(name_of(of.closure))] = {{"peak", to_json(of.peak)},
                                                  {"peak_inflating", to_json(of.inflating)},
                                                  {"peak_deflating", to_json(of.deflating)},
                                                  {"impulse_N_s", of.impulse},
                                                  {"work_J", of.work}};
  }
  Json warnings = Json::array();
  for (const Warning& warning : history.warnings) warnings.push_back({{"name", warning.name}, {"text", warning.text}});
  const RadiusRange<double>& r = history.radius;
  const Motion& motion = dictated_motion(c);
  const Json document{{"title", c.title},
                      {"status", "complete"},
                      {"versions", {{"turgor", version}, {"compiler", compiler}}},
                      {"closure", name_of(c.parameters.closure)},
                      {"motion",
                       {{"t_end_s", c.solve.t_end},
                        {"r_start_m", motion.at(0).radius},
                        {"r_end_m", motion.at(c.solve.t_end).radius},
                        {"r_least", {{"r_m", r.least}, {"t_s", r.least_time}}},
                        {"r_greatest", {{"r_m", r.greatest}, {"t_s", r.greatest_time}}}}},
                      {"forces", closures},
                      {"warnings", warnings}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string force_summary(const Case& c, const ForceHistory& history) {
  const auto peak = [](const std::optional<ForcePeak>& p) {
    return p ? rounded(p->force, 6) + " N at " + rounded(p->time, 6) + " s" : std::string("none");
  };
  std::string out =
      c.title + "\n" +
      summary_line("radius", rounded(history.radius.least, 6) + " to " + rounded(history.radius.greatest, 6) + " m");
  for (const ForceSummary& of : history.closures) {
    out += summary_line(std::string(name_of(of.closure)),
                        "peak inflating " + peak(of.inflating) + ", deflating " + peak(of.deflating) + "; impulse " +
                            rounded(of.impulse, 6) + " N s, work " + rounded(of.work, 6) + " J");
  }
  for (const Warning& warning : history.warnings) out += "  warning: " + warning.text + "\n";
  return out;
}

}  // namespace turgor
