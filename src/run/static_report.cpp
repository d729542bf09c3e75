#include <cmath>
#include <nlohmann/json.hpp>

#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/static_study.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::string_view name_of(BranchEnd end) {
  switch (end) {
    case BranchEnd::left_box: return "range";
    case BranchEnd::closed: return "closed";
    case BranchEnd::lost: return "lost";
    case BranchEnd::too_long: return "too-long";
  }
  return "";
}

Json jumps_json(const std::vector<Jump>& jumps) {
  Json all = Json::array();
  for (const Jump& jump : jumps) {
    all.push_back({{"from_R", jump.stretch},
                   {"from_pressure_Pa", jump.pressure},
                   {"direction", jump.inflating ? "inflating" : "deflating"},
                   {"to_R", number_or_null(jump.to)},
                   {"to_pressure_Pa", jump.to ? Json(jump.to_pressure) : Json(nullptr)},
                   {"released_J", jump.to ? Json(jump.released) : Json(nullptr)}});
  }
  return all;
}

Json windows_json(const std::vector<BistableWindow>& windows) {
  Json all = Json::array();
  for (const BistableWindow& window : windows) {
    all.push_back({{"least_Pa", window.least},
                   {"greatest_Pa", window.greatest},
                   {"maxwell_pressure_Pa", number_or_null(window.maxwell)}});
  }
  return all;
}

/// Turning points of curves, and how the curves end.
Json curves_json(const std::vector<RestCurve>& curves, const char* first_key) {
  Json all = Json::array();
  for (const RestCurve& curve : curves) {
    Json turning = Json::array();
    for (const RestPoint& point : curve.points) {
      if (!point.turning) continue;
      Json entry{{"value", point.parameter}, {"R", point.stretch}, {"pressure_Pa", point.pressure}};
      if (first_key != nullptr) entry["first"] = point.first;
      turning.push_back(std::move(entry));
    }
    all.push_back({{"points", curve.points.size()},
                   {"from", curve.points.front().parameter},
                   {"to", curve.points.back().parameter},
                   {"ends", name_of(curve.end)},
                   {"turning_points", turning}});
  }
  return all;
}

Json range_json(const KeyRange& range) {
  return {{"key", range.key}, {"unit", range.unit}, {"from", range.from}, {"to", range.to}};
}

Json over_json(const KeyStudy& over) {
  Json critical = Json::array();
  for (const Cusp& cusp : over.map.cusps) {
    critical.push_back({{"value", cusp.parameter}, {"R", cusp.stretch}, {"pressure_Pa", cusp.pressure}});
  }
  Json document = range_json(over.range);
  document["critical"] = critical;
  document["equilibria"] = curves_json(over.equilibria, nullptr);
  document["limit_points"] = curves_json(over.limit_points, nullptr);
  return document;
}

Json wells_json(const std::vector<Well>& wells) {
  Json all = Json::array();
  for (const Well& well : wells) {
    all.push_back({{"R", well.stretch},
                   {"energy_J", well.energy},
                   {"barrier_below_J", number_or_null(well.barrier_below)},
                   {"barrier_above_J", number_or_null(well.barrier_above)}});
  }
  return all;
}

}  // namespace

std::string statics_json(const Case& c, const StaticStudy& study) {
  Json limits = Json::array();
  for (const LimitPoint& p : study.limit_points) {
    limits.push_back({{"R", p.stretch}, {"pressure_Pa", p.pressure}, {"kind", p.maximum ? "maximum" : "minimum"}});
  }
  Json equilibria = Json::array();
  for (const Equilibrium& e : study.equilibria) {
    Json entry{{"R", e.stretch}, {"stable", e.stable}};
    if (study.supply) entry["stable_with_supply"] = is_stable(c.parameters, e.stretch, *study.supply);
    equilibria.push_back(std::move(entry));
  }
  Json document{{"title", c.title}, {"material", c.material_name}, {"pressure_Pa", study.pressure}};
  document["limit_points"] = limits;
  document["equilibria"] = equilibria;
  const bool bistable = !study.windows.empty();
  document["bistable_window_Pa"] =
      bistable ? Json{study.windows.front().least, study.windows.front().greatest} : Json(nullptr);
  document["maxwell_pressure_Pa"] = bistable ? number_or_null(study.windows.front().maxwell) : Json(nullptr);
  document["bistable_windows"] = windows_json(study.windows);
  document["wells"] = wells_json(study.wells);
  document["jumps"] = jumps_json(study.jumps);
  document["critical_compliance_m3_per_Pa"] = finite(study.critical_compliance);
  if (study.supply) {
    document["supply"] = {{"compliance_m3_per_Pa", study.supply->compliance},
                          {"jumps", jumps_json(study.filling_jumps)}};
  }
  if (study.over) document["over"] = over_json(*study.over);
  if (study.plane) {
    document["plane"] = {{"first", range_json(study.plane->first)},
                         {"second", range_json(study.plane->second)},
                         {"limit_points", curves_json(study.plane->limit_points, "first")}};
  }
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

std::string jumps_text(const std::vector<Jump>& jumps) {
  if (jumps.empty()) return "    none\n";
  std::string out;
  for (const Jump& jump : jumps) {
    out += "    " + std::string(jump.inflating ? "inflating" : "deflating") + " from R = " + rounded(jump.stretch, 8) +
           " at " + rounded(jump.pressure, 8) + " Pa";
    if (jump.to) {
      out += " to R = " + rounded(*jump.to, 8) + " at " + rounded(jump.to_pressure, 8) + " Pa, releasing " +
             rounded(jump.released, 6) + " J\n";
    } else {
      out += ": nothing holds the balloon beyond\n";
    }
  }
  return out;
}

std::string wells_text(const StaticStudy& study) {
  std::string out = "  at the final pressure, " + rounded(study.pressure, 8) + " Pa\n";
  if (study.equilibria.empty()) out += "    no equilibrium: the wall cannot hold it\n";
  std::size_t well = 0;
  for (const Equilibrium& e : study.equilibria) {
    out += "    R = " + rounded(e.stretch, 10);
    if (!e.stable) {
      out += " unstable\n";
      continue;
    }
    const Well& w = study.wells[well++];
    out += " stable, energy " + rounded(w.energy, 6) + " J";
    if (w.barrier_below) out += ", barrier below " + rounded(*w.barrier_below, 6) + " J";
    if (w.barrier_above) out += ", barrier above " + rounded(*w.barrier_above, 6) + " J";
    out += "\n";
  }
  return out;
}

std::string with_unit(double value, const std::string& unit, int digits) {
  return rounded(value, digits) + (unit == "1" ? "" : " " + unit);
}

std::string over_text(const KeyStudy& over) {
  std::string out = "  over " + over.range.key + " from " + with_unit(over.range.from, over.range.unit, 8) + " to " +
                    with_unit(over.range.to, over.range.unit, 8) + "\n";
  for (const Cusp& cusp : over.map.cusps) {
    out += "    limit points begin or end at " + with_unit(cusp.parameter, over.range.unit, 12) +
           ", R = " + rounded(cusp.stretch, 7) + ", " + rounded(cusp.pressure, 8) + " Pa\n";
  }
  std::size_t turns = 0;
  for (const RestCurve& curve : over.equilibria) {
    for (const RestPoint& point : curve.points) {
      if (!point.turning) continue;
      ++turns;
      out += "    equilibria turn back at " + with_unit(point.parameter, over.range.unit, 12) +
             ", R = " + rounded(point.stretch, 10) + ", " + rounded(point.pressure, 8) + " Pa\n";
    }
  }
  if (turns == 0 && over.map.cusps.empty()) out += "    neither equilibria nor limit points turn back\n";
  return out;
}

}  // namespace

std::string statics_text(const Case& c, const StaticStudy& study) {
  std::string out = c.title + "\n  limit points\n";
  if (study.limit_points.empty()) out += "    none: the pressure rises with R throughout\n";
  for (const LimitPoint& p : study.limit_points) {
    out += "    " + std::string(p.maximum ? "maximum" : "minimum") + " of " + rounded(p.pressure, 10) +
           " Pa at R = " + rounded(p.stretch, 10) + "\n";
  }
  out += "  two stable states\n";
  if (study.windows.empty()) out += "    at no pressure\n";
  for (const BistableWindow& window : study.windows) {
    out += "    from " + rounded(window.least, 10) + " to " + rounded(window.greatest, 10) + " Pa; ";
    out += window.maxwell ? "equally deep at " + rounded(*window.maxwell, 10) + " Pa (Maxwell)\n"
                          : "one is deeper throughout\n";
  }
  out += wells_text(study) + "  jumps under a prescribed pressure\n" + jumps_text(study.jumps);
  out += "  filled through a supply\n    ";
  out += std::isfinite(study.critical_compliance)
             ? "never jumps up to a compliance of " + rounded(study.critical_compliance, 8) + " m^3/Pa\n"
             : "never jumps\n";
  if (study.supply) {
    out += "  jumps with a compliance of " + rounded(study.supply->compliance, 8) + " m^3/Pa\n" +
           jumps_text(study.filling_jumps);
  }
  if (study.over) out += over_text(*study.over);
  return out;
}

std::string statics_csv(const Case& c, const StaticStudy& study) {
  const OutputSettings& o = c.output;
  const double m3 = unit_factor(o.volume_unit, "m^3");
  const double pa = unit_factor(o.pressure_unit, "Pa");
  const double joule = unit_factor(o.energy_unit, "J");
  std::string out = "R [1],volume [" + o.volume_unit + "],p_gauge [" + o.pressure_unit + "],strain_energy [" +
                    o.energy_unit + "],potential_energy [" + o.energy_unit + "],stable\n";
  for (const StaticRow& row : static_curve(c, study)) {
    append_number(out, row.stretch);
    out += ',';
    append_number(out, working_volume(c.parameters, row.stretch), m3);
    out += ',';
    append_number(out, row.pressure, pa);
    out += ',';
    append_number(out, strain_energy_of(c.parameters, row.stretch), joule);
    out += ',';
    append_number(out, potential_energy(c.parameters, row.stretch, study.pressure), joule);
    out += row.stable ? ",1\n" : ",0\n";
  }
  return out;
}

namespace {

/// @param columns    of keys
/// @param has_first  the curves have values of both
void append_curves(std::string& out, const std::string& kind, const std::vector<RestCurve>& curves, int columns,
                   bool has_first) {
  std::size_t number = 0;
  for (const RestCurve& curve : curves) {
    ++number;
    for (const RestPoint& point : curve.points) {
      out += kind + ',' + std::to_string(number) + ',';
      append_number(out, has_first ? point.first : point.parameter);
      if (columns == 2) out += ',';
      if (has_first) append_number(out, point.parameter);
      out += ',';
      append_number(out, point.stretch);
      out += ',';
      append_number(out, point.pressure);
      out += point.stable ? ",1" : ",0";
      out += point.turning ? ",1\n" : ",0\n";
    }
  }
}

}  // namespace

std::string branches_csv(const StaticStudy& study) {
  const KeyRange& key = study.over.value().range;
  const int columns = study.plane ? 2 : 1;
  std::string out = "curve,number," + key.key + " [" + key.unit + "],";
  if (study.plane) out += study.plane->second.key + " [" + study.plane->second.unit + "],";
  out += "R [1],p_gauge [Pa],stable,turns\n";
  append_curves(out, "equilibria", study.over->equilibria, columns, false);
  append_curves(out, "limit-points", study.over->limit_points, columns, false);
  if (study.plane) append_curves(out, "plane", study.plane->limit_points, columns, true);
  return out;
}

}  // namespace turgor
