#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/report.hpp"
#include "turgor/run/response_verification.hpp"
#include "verification_parts.hpp"

namespace turgor {

namespace {

constexpr const char* m = "m";

/// By equation, then by closure.
template <class Entry>
Json by_model(const ResponseVerification& v, const Entry& entry) {
  Json out = Json::object();
  for (std::size_t i = 0; i < v.models.size(); ++i) {
    const ModelResponse& model = v.models[i];
    out[std::string(name_of(model.run.oscillator->model()))][std::string(name_of(model.closure))] = entry(i);
  }
  return out;
}

Json to_json(const Landmarks& of) {
  return {{"final_m", of.final}, {"greatest_m", of.greatest}, {"greatest_at_s", of.greatest_time}};
}

Json to_json(const ModelResponse& model) {
  Json out{{"outcome", name_of(model.run.trajectory->outcome)}, {"rows", model.radii.size()}};
  if (model.landmarks) out.update(to_json(*model.landmarks));
  return out;
}

Json to_json(const PhaseErrors& of, const ResponseVerification& v) {
  Json out{{"part", of.phase ? name_of(of.phase->course) : "whole"}};
  if (of.phase) out.update({{"from_s", of.phase->begin}, {"to_s", of.phase->end}});
  out["rows"] = of.rows;
  out["errors"] =
      by_model(v, [&](std::size_t i) { return of.models[i] ? to_json(*of.models[i], m, v.stroke) : Json(nullptr); });
  return out;
}

constexpr std::size_t label_width = 33;
constexpr std::size_t number_width = 11;

std::string title_line(const std::string& label, std::initializer_list<std::string> titles) {
  std::string out = "\n" + left("  " + label, label_width);
  for (const std::string& title : titles) out += right(title, number_width);
  return out + "\n";
}

std::string error_table(const PhaseErrors& of, const ResponseVerification& v) {
  std::string out = title_line(of.phase ? of.phase->name() : "whole run", {"mean", "RMS", "greatest", "at t [s]"});
  for (std::size_t i = 0; i < v.models.size(); ++i) {
    out += left("    " + v.models[i].name(), label_width);
    if (const auto& error = of.models[i]) {
      for (const double value : {error->mean, error->rms, error->greatest}) {
        out += right(percent_of(value, v.stroke), number_width);
      }
      out += right(rounded(error->greatest_time), number_width);
    } else {
      out += right("-", number_width);
    }
    out += "\n";
  }
  return out;
}

std::string landmark_table(const Case& c, const ResponseVerification& v) {
  const OutputSettings& o = c.output;
  const double length = unit_factor(o.length_unit, m);
  const double time = unit_factor(o.time_unit, "s");
  constexpr int digits = 6;
  std::string out = title_line(
      "radius", {"greatest [" + o.length_unit + "]", "at t [" + o.time_unit + "]", "final [" + o.length_unit + "]"});
  const auto add = [&](const std::string& name, const std::optional<Landmarks>& of) {
    out += left("    " + name, label_width);
    if (of) {
      out += right(rounded(of->greatest / length, digits), number_width) +
             right(rounded(of->greatest_time / time, digits), number_width) +
             right(rounded(of->final / length, digits), number_width);
    } else {
      out += right("-", number_width);
    }
    out += "\n";
  };
  add("finite elements", v.landmarks);
  for (const ModelResponse& model : v.models) add(model.name(), model.landmarks);
  return out;
}

}  // namespace

std::string verification_csv(const Case& c, const ResponseVerification& v) {
  const OutputSettings& o = c.output;
  const double s = unit_factor(o.time_unit, "s");
  const double length = unit_factor(o.length_unit, m);
  const std::string unit = " [" + o.length_unit + "]";
  std::string out = "t [" + o.time_unit + "],p_gauge [" + o.pressure_unit + "],r_eff_fem" + unit;
  if (v.shape) out += ",shape_energy_fem [J]";
  for (const ModelResponse& model : v.models) {
    out +=
        ",r_" + std::string(name_of(model.run.oscillator->model())) + "_" + std::string(name_of(model.closure)) + unit;
  }
  out += "\n";
  for (std::size_t i = 0; i < v.fem.rows.size(); ++i) {
    const FemRadius& row = v.fem.rows[i];
    append_number(out, row.time, s);
    out += ',';
    append_number(out, row.gauge_pressure, unit_factor(o.pressure_unit, "Pa"));
    out += ',';
    append_number(out, row.radius, length);
    if (v.shape) {
      out += ',';
      append_number(out, v.shape->rows[i], 1);
    }
    for (const ModelResponse& model : v.models) {
      out += ',';
      if (i < model.radii.size()) append_number(out, model.radii[i], length);
    }
    out += "\n";
  }
  return out;
}

std::string verification_json(const Case& c, const ResponseVerification& v) {
  Json parts = Json::array();
  for (const PhaseErrors& part : v.parts) parts.push_back(to_json(part, v));
  Json fem = fem_json(v.fem);
  fem.update(to_json(v.landmarks));
  fem["stroke_m"] = v.stroke;
  if (v.shape) {
    fem["shape_energy"] = {
        {"greatest_J", v.shape->greatest}, {"at_s", v.shape->time}, {"greatest_elastic_J", v.shape->elastic}};
  }
  return dumped({{"title", c.title},
                 {"status", "complete"},
                 {"versions", {{"turgor", version}, {"compiler", compiler}}},
                 {"finite_elements", fem},
                 {"models", by_model(v, [&](std::size_t i) { return to_json(v.models[i]); })},
                 {"parts", parts},
                 {"warnings", to_json(v.warnings)}});
}

std::string verification_summary(const Case& c, const ResponseVerification& v) {
  std::string out = c.title + "\n" + fem_line(v.fem) + landmark_table(c, v) +
                    "\n  model - r_eff of finite elements, in % of the latter's stroke of " +
                    rounded(v.stroke / unit_factor(c.output.length_unit, m), 6) + " " + c.output.length_unit + "\n";
  for (const PhaseErrors& part : v.parts) out += error_table(part, v);
  if (v.shape && v.shape->elastic > 0) {
    out +=
        "\n  energy of the shape, elastic beyond rest at the same volume: up to " + rounded(v.shape->greatest, 4) +
        " J, " + rounded(100 * v.shape->greatest / v.shape->elastic, 3) +
        " % of the greatest elastic energy, at t = " + rounded(v.shape->time / unit_factor(c.output.time_unit, "s")) +
        " " + c.output.time_unit + "\n";
  }
  return out + "\n" + warning_lines(v.warnings);
}

}  // namespace turgor
