#include <nlohmann/json.hpp>

#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/membrane_study.hpp"
#include "turgor/run/report.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

std::string rim_name(const MembraneWall& wall) { return wall.rim == Rim::clamped ? "clamped" : "hinged"; }

double percent_above(double value, double reference) { return 100 * (value / reference - 1); }

std::string signed_percent(double value, double reference) {
  const double above = percent_above(value, reference);
  return (above >= 0 ? "+" : "") + rounded(above, 3) + " %";
}

/// The equilibrium of (3.1) that goes with the one of that number; nothing when there is not the same number of them.
const Equilibrium* partner(const MembraneStudy& study, std::size_t number) {
  return study.sphere.size() == study.equilibria.size() ? &study.sphere[number] : nullptr;
}

Json row_json(const MembraneRow& row) {
  return {{"R", row.stretch},
          {"r_eff_m", row.state.radius},
          {"pressure_Pa", row.state.pressure},
          {"volume_m3", row.state.volume},
          {"z_top_m", row.top},
          {"r_max_m", row.greatest_radius},
          {"elastic_energy_J", row.energy},
          {"stable", row.stable()},
          {"unstable_modes_at_pressure", row.unstable.at_pressure},
          {"unstable_modes_at_volume", row.unstable.at_volume}};
}

Json limits_json(const MembraneStudy& study) {
  Json all = Json::array();
  for (const MembraneLimit& limit : study.limits) {
    Json entry = row_json(limit.row);
    entry["kind"] = limit.maximum ? "maximum" : "minimum";
    entry["sphere"] = nullptr;
    if (limit.sphere) {
      entry["sphere"] = {
          {"R", limit.sphere->stretch},
          {"pressure_Pa", limit.sphere->pressure},
          {"R_difference_percent", percent_above(limit.row.stretch, limit.sphere->stretch)},
          {"pressure_difference_percent", percent_above(limit.row.state.pressure, limit.sphere->pressure)}};
    }
    all.push_back(std::move(entry));
  }
  return all;
}

}  // namespace

std::string membrane_json(const Case& c, const MembraneStudy& study) {
  Json equilibria = Json::array();
  for (const MembraneRow& row : study.equilibria) equilibria.push_back(row_json(row));
  Json spheres = Json::array();
  for (const Equilibrium& state : study.sphere) spheres.push_back({{"R", state.stretch}, {"stable", state.stable}});
  const Json document{{"title", c.title},
                      {"material", c.material_name},
                      {"membrane",
                       {{"elements", study.elements},
                        {"rim", rim_name(study.wall)},
                        {"bending_stiffness_N_m", study.wall.bending_stiffness}}},
                      {"end", row_json(study.curve.back())},
                      {"limit_points", limits_json(study)},
                      {"pressure_Pa", study.pressure},
                      {"equilibria", equilibria},
                      {"sphere_equilibria", spheres},
                      {"why_no_equilibrium", study.why_none.empty() ? Json(nullptr) : Json(study.why_none)},
                      {"at_volume", study.at_volume ? row_json(*study.at_volume) : Json(nullptr)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

std::string stability(const MembraneRow& row) {
  if (row.stable()) return "stable";
  std::string text = "unstable, " + std::to_string(row.unstable.at_pressure) +
                     (row.unstable.at_pressure == 1 ? " mode" : " modes") + " at held pressure";
  if (row.unstable.at_volume > 0) text += ", " + std::to_string(row.unstable.at_volume) + " at held volume: it buckles";
  return text;
}

std::string limits_text(const MembraneStudy& study) {
  if (study.limits.empty()) {
    return "    none up to R = " + rounded(study.curve.back().stretch, 6) + ": the pressure rises all the way to " +
           rounded(study.curve.back().state.pressure, 8) + " Pa\n";
  }
  std::string out;
  for (const MembraneLimit& limit : study.limits) {
    const MembraneState& state = limit.row.state;
    out += "    " + std::string(limit.maximum ? "maximum" : "minimum") + " of " + rounded(state.pressure, 8) +
           " Pa at R = " + rounded(limit.row.stretch, 7) + ", r_eff = " + rounded(state.radius, 7) + " m\n";
    if (!limit.sphere) continue;
    out += "      (3.1): " + rounded(limit.sphere->pressure, 8) + " Pa at R = " + rounded(limit.sphere->stretch, 7) +
           "; the membrane is " + signed_percent(state.pressure, limit.sphere->pressure) + " in pressure, " +
           signed_percent(limit.row.stretch, limit.sphere->stretch) + " in R\n";
  }
  return out;
}

std::string state_text(const MembraneRow& row) {
  return "R = " + rounded(row.stretch, 7) + ", r_eff = " + rounded(row.state.radius, 7) + " m, volume " +
         rounded(row.state.volume, 6) + " m^3, " + stability(row);
}

std::string equilibria_text(const MembraneStudy& study) {
  std::string out = "  at " + rounded(study.pressure, 8) + " Pa\n";
  if (study.equilibria.empty()) out += "    " + study.why_none + "; " + study.advice + "\n";
  for (std::size_t i = 0; i < study.equilibria.size(); ++i) {
    out += "    " + state_text(study.equilibria[i]) + "\n";
    if (const Equilibrium* sphere = partner(study, i)) {
      out += "      (3.1): R = " + rounded(sphere->stretch, 7) + "; the membrane is " +
             signed_percent(study.equilibria[i].stretch, sphere->stretch) + " in R\n";
    }
  }
  return out;
}

}  // namespace

std::string membrane_text(const Case& c, const MembraneStudy& study) {
  std::string out = c.title + "\n";
  out += summary_line("membrane", std::to_string(study.elements) + " elements, " + rim_name(study.wall) +
                                      " rim, bending stiffness " + rounded(study.wall.bending_stiffness) + " N m");
  out += summary_line("curve", std::to_string(study.curve.size()) +
                                   " states from slack to R = " + rounded(study.curve.back().stretch, 6));
  out += "  limit points\n" + limits_text(study) + equilibria_text(study);
  if (study.at_volume) {
    out += "  at " + rounded(study.at_volume->state.volume, 8) + " m^3\n    " +
           rounded(study.at_volume->state.pressure, 8) + " Pa, " + state_text(*study.at_volume) + "\n";
  }
  return out;
}

std::string membrane_csv(const Case& c, const MembraneStudy& study) {
  const OutputSettings& o = c.output;
  const double m = unit_factor(o.length_unit, "m");
  const double m3 = unit_factor(o.volume_unit, "m^3");
  const double pa = unit_factor(o.pressure_unit, "Pa");
  const double joule = unit_factor(o.energy_unit, "J");
  std::string out = "R [1],r_eff [" + o.length_unit + "],volume [" + o.volume_unit + "],p_gauge [" + o.pressure_unit +
                    "],p_sphere [" + o.pressure_unit + "],z_top [" + o.length_unit + "],r_max [" + o.length_unit +
                    "],elastic_energy [" + o.energy_unit + "],unstable_at_pressure,unstable_at_volume,limit_point\n";
  for (const MembraneRow& row : study.curve) {
    append_number(out, row.stretch);
    const auto add = [&](double value, double factor) {
      out += ',';
      append_number(out, value, factor);
    };
    add(row.state.radius, m);
    add(row.state.volume, m3);
    add(row.state.pressure, pa);
    add(row.sphere_pressure, pa);
    add(row.top, m);
    add(row.greatest_radius, m);
    add(row.energy, joule);
    out += ',' + std::to_string(row.unstable.at_pressure) + ',' + std::to_string(row.unstable.at_volume) +
           (row.limit_point ? ",1\n" : ",0\n");
  }
  return out;
}

std::string shapes_csv(const Case& c, const MembraneStudy& study) {
  const OutputSettings& o = c.output;
  const double m = unit_factor(o.length_unit, "m");
  const double pa = unit_factor(o.pressure_unit, "Pa");
  std::string out =
      "shape,R [1],p_gauge [" + o.pressure_unit + "],r [" + o.length_unit + "],z [" + o.length_unit + "]\n";
  int number = 0;
  for (const MembraneRow& row : shapes_of(study)) {
    ++number;
    const Eigen::VectorXd& places = row.state.places;
    for (Eigen::Index i = 0; i < places.size(); i += 2) {
      out += std::to_string(number) + ',';
      append_number(out, row.stretch);
      out += ',';
      append_number(out, row.state.pressure, pa);
      out += ',';
      append_number(out, places(i), m);
      out += ',';
      append_number(out, places(i + 1), m);
      out += '\n';
    }
  }
  return out;
}

}  // namespace turgor
