#include "turgor/run/info.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "turgor/base/text.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

std::vector<EquilibriaAt> equilibria_of(const Case& c) {
  std::vector<double> times{0};
  for (const double knot : c.pressure.knots()) {
    if (knot < c.solve.t_end) times.push_back(knot);
  }
  times.push_back(c.solve.t_end);
  std::set<double> seen;
  std::vector<EquilibriaAt> found;
  for (const double t : times) {
    const double pressure = c.pressure(t);
    if (seen.insert(pressure).second) found.push_back({t, pressure, equilibria(c.parameters, pressure)});
    constexpr std::size_t enough = 12;  // a long table has a pressure per row
    if (found.size() == enough) break;
  }
  return found;
}

std::vector<TimeConstants> time_constants_of(const Oscillator<double>& oscillator,
                                             const std::vector<EquilibriaAt>& all) {
  const Scales<double>& scales = oscillator.scales();
  std::vector<TimeConstants> constants;
  for (const EquilibriaAt& at : all) {
    for (const Equilibrium& state : at.states) {
      if (!state.stable) continue;
      const auto clock = [&](Regime regime) {
        const auto c = oscillator.coefficients(regime, state.stretch);
        return scales.time * std::sqrt(c.mass / (c.elastic_slope - c.area_slope * at.pressure / scales.pressure));
      };
      constants.push_back({state.stretch, clock(Regime::deflating), clock(Regime::inflating)});
    }
  }
  return constants;
}

/// States of rest that a table does not know are made of the straight lines beyond it.
void warn_of_table(const Case& c, CaseInfo& info) {
  const KnownStretches<double> known = known_stretches(c.parameters.material);
  std::string list;
  const auto include = [&](const char* what, double stretch) {
    constexpr double rounding = 1e-9;
    if (stretch >= known.least - rounding && stretch <= known.greatest + rounding) return;
    list += (list.empty() ? "" : ", ") + std::string(what) + " R = " + rounded(stretch, 6);
  };
  for (const LimitPoint& point : info.limit_points) include("the limit point at", point.stretch);
  for (const EquilibriaAt& at : info.equilibria) {
    for (const Equilibrium& state : at.states) include("the equilibrium at", state.stretch);
  }
  if (list.empty()) return;
  info.run.warnings.push_back({"table-range", "beyond material.table, which goes from " + rounded(known.least, 6) +
                                                  " to " + rounded(known.greatest, 6) + ", lie " + list});
}

Json groups_json(const Groups<double>& g) {
  const auto finite = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  return {{"C1", g.C1},
          {"C2", g.C2},
          {"C3", g.C3},
          {"C1_long", finite(g.C1_long)},
          {"C2_long", finite(g.C2_long)},
          {"solid_inertia", g.a0},
          {"channel_inertia", g.b},
          {"liquid_inertia", g.m},
          {"liquid_centripetal", g.n},
          {"stiffness", g.K}};
}

}  // namespace

CaseInfo case_info(const Case& c) {
  CaseInfo info{};
  info.groups_si = groups(c.parameters, {c.parameters.radius, 1.0, 1.0});
  info.groups_natural = groups(c.parameters, c.scales);
  info.limit_points = limit_points(c.parameters);
  info.equilibria = equilibria_of(c);
  info.run = run_case(c);
  warn_of_table(c, info);
  info.time_constants = time_constants_of(*info.run.oscillator, info.equilibria);
  return info;
}

std::string info_json(const Case& c, const CaseInfo& info) {
  Json limits = Json::array();
  for (const LimitPoint& p : info.limit_points) {
    limits.push_back({{"R", p.stretch}, {"pressure_Pa", p.pressure}, {"kind", p.maximum ? "maximum" : "minimum"}});
  }
  Json equilibria = Json::array();
  for (const EquilibriaAt& at : info.equilibria) {
    Json states = Json::array();
    for (const Equilibrium& e : at.states) states.push_back({{"R", e.stretch}, {"stable", e.stable}});
    equilibria.push_back({{"t_s", at.time}, {"pressure_Pa", at.pressure}, {"states", states}});
  }
  Json constants = Json::array();
  for (const TimeConstants& t : info.time_constants) {
    constants.push_back({{"R", t.stretch}, {"deflation_s", t.deflation}, {"inflation_s", t.inflation}});
  }
  Json dropped = Json::object();
  for (const auto& [model, terms] : info.run.choice.dropped) {
    for (const DroppedTerm& term : terms) {
      dropped[std::string(name_of(model))][term.name] = std::isfinite(term.ratio) ? Json(term.ratio) : Json(nullptr);
    }
  }
  Json warnings = Json::array();
  for (const Warning& w : info.run.warnings) warnings.push_back({{"name", w.name}, {"text", w.text}});
  Json groups = groups_json(info.groups_si);
  groups["p_typ_Pa"] = 1.0;
  groups["t_typ_s"] = 1.0;
  Json natural = groups_json(info.groups_natural);
  natural["p_typ_Pa"] = c.scales.pressure;
  natural["t_typ_s"] = c.scales.time;
  const Json document{{"title", c.title},
                      {"model", name_of(info.run.choice.model)},
                      {"model_chosen_automatically", info.run.choice.automatic},
                      {"stretch_range", {info.run.choice.least_stretch, info.run.choice.greatest_stretch}},
                      {"dropped_term_ratios", dropped},
                      {"groups", groups},
                      {"groups_natural", natural},
                      {"time_constants", constants},
                      {"limit_points", limits},
                      {"equilibria", equilibria},
                      {"warnings", warnings}};
  return document.dump(2) + "\n";
}

std::string info_text(const Case& c, const CaseInfo& info) {
  std::string out = c.title + "\n";
  const auto group_line = [&](const std::string& scales, const Groups<double>& g) {
    out += "  dimensionless groups, " + scales + "\n    C1 = " + rounded(g.C1, 8) + ", C2 = " + rounded(g.C2, 8) +
           ", C3 = " + rounded(g.C3, 8) + "  (2.24)\n";
    if (g.b > 0) out += "    C1~ = " + rounded(g.C1_long, 8) + ", C2~ = " + rounded(g.C2_long, 8) + "  (2.26)\n";
  };
  group_line("p_typ = 1 Pa, t_typ = 1 s", info.groups_si);
  group_line("p_typ = " + rounded(c.scales.pressure, 6) + " Pa, t_typ = " + rounded(c.scales.time, 6) + " s",
             info.groups_natural);
  out += "    solid inertia " + rounded(info.groups_si.a0, 6) + ", channel inertia " + rounded(info.groups_si.b, 6) +
         ", liquid inertia " + rounded(info.groups_si.m, 6) + " (deflating, R = 1), liquid centripetal " +
         rounded(info.groups_si.n, 6) + "  (2.22)\n";
  out += "  limit points\n";
  if (info.limit_points.empty()) out += "    none: the pressure rises with R throughout\n";
  for (const LimitPoint& p : info.limit_points) {
    out += "    " + std::string(p.maximum ? "maximum" : "minimum") + " of " + rounded(p.pressure, 8) +
           " Pa at R = " + rounded(p.stretch, 10) + "\n";
  }
  out += "  equilibria\n";
  for (const EquilibriaAt& at : info.equilibria) {
    out += "    at " + rounded(at.pressure, 8) + " Pa (t = " + rounded(at.time, 6) + " s):";
    if (at.states.empty()) out += " none";
    for (const Equilibrium& e : at.states)
      out += "  R = " + rounded(e.stretch, 10) + (e.stable ? " stable" : " unstable");
    out += "\n";
  }
  out += "  time constants of small motions about stable equilibria, each regime on its own clock\n";
  for (const TimeConstants& t : info.time_constants) {
    out += "    R = " + rounded(t.stretch, 6) + ": deflating " + rounded(t.deflation, 6) + " s, inflating " +
           rounded(t.inflation, 6) + " s\n";
  }
  out += "  model " + std::string(name_of(info.run.choice.model)) +
         (info.run.choice.automatic ? " (chosen automatically)" : "") + ", R from " +
         rounded(info.run.choice.least_stretch, 6) + " to " + rounded(info.run.choice.greatest_stretch, 6) + "\n";
  for (const auto& [model, terms] : info.run.choice.dropped) {
    for (const DroppedTerm& term : terms) {
      out +=
          "    " + std::string(name_of(model)) + " drops " + term.name + ": " + rounded(100 * term.ratio, 3) + " %\n";
    }
  }
  if (info.run.warnings.empty()) out += "  no assumption of the model is strained\n";
  for (const Warning& w : info.run.warnings) out += "  warning: " + w.text + "\n";
  return out;
}

}  // namespace turgor
