#include "turgor/run/verification.hpp"

#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/report.hpp"
#include "verification_parts.hpp"

namespace turgor {

namespace {

Json to_json(const PartErrors& of, const std::vector<Closure>& closures) {
  Json errors = Json::object();
  for (std::size_t i = 0; i < closures.size(); ++i) {
    errors[std::string(name_of(closures[i]))] = to_json(of.closures[i], "N", of.reference);
  }
  return {{"part", of.part.name()},      {"rows", of.rows},
          {"rms_fem_N", of.rms},         {"relative_to", of.relative_to_deflation ? "deflation" : "part"},
          {"reference_N", of.reference}, {"errors", errors}};
}

Json to_json(const ForceComparison& comparison, const std::vector<Closure>& closures) {
  Json parts = Json::array();
  for (const PartErrors& part : comparison.parts) parts.push_back(to_json(part, closures));
  Json even(nullptr);
  for (std::size_t i = 0; i < comparison.even_deflation.size(); ++i) {
    const ForceRatio& ratio = comparison.even_deflation[i];
    even[std::string(name_of(closures[i]))] = {
        {"mean", ratio.mean}, {"least", ratio.least}, {"greatest", ratio.greatest}};
  }
  return {{"parts", parts}, {"even_deflation_ratio_minus_1", even}};
}

constexpr std::size_t label_width = 33;
constexpr std::size_t number_width = 9;

std::string error_table(const ForceComparison& comparison, const std::vector<Closure>& closures,
                        const std::string& force) {
  std::string out = "\n  model - " + force + ", in % of its RMS over the part, with * over the whole deflation\n" +
                    std::string(label_width, ' ');
  for (const Closure closure : closures) out += right(std::string(name_of(closure)), 3 * number_width);
  out += "\n" + std::string(label_width, ' ');
  for (std::size_t i = 0; i < closures.size(); ++i) {
    for (const char* title : {"mean", "RMS", "greatest"}) out += right(title, number_width);
  }
  out += "\n";
  for (const PartErrors& of : comparison.parts) {
    out +=
        left((of.part.course ? "    " : "  ") + of.part.name() + (of.relative_to_deflation ? " *" : ""), label_width);
    for (const Deviation& e : of.closures) {
      for (const double value : {e.mean, e.rms, e.greatest}) {
        out += right(percent_of(value, of.reference), number_width);
      }
    }
    out += "\n";
  }
  return out;
}

std::string ratio_table(const Verification& v) {
  if (v.mode.even_deflation.empty() || v.whole.even_deflation.empty()) return {};
  std::string out =
      "\n  model/finite elements - 1, in %, while deflating at constant velocity: mean (least to greatest)\n";
  const auto shown = [](const ForceRatio& ratio) {
    return percent(ratio.mean) + " (" + percent(ratio.least) + " to " + percent(ratio.greatest) + ")";
  };
  for (std::size_t i = 0; i < v.closures.size(); ++i) {
    out += summary_line(std::string(name_of(v.closures[i])), left("force_mode " + shown(v.mode.even_deflation[i]), 38) +
                                                                 "  force " + shown(v.whole.even_deflation[i]));
  }
  return out;
}

}  // namespace

std::string verification_csv(const Case& c, const Verification& v) {
  const OutputSettings& o = c.output;
  const double s = unit_factor(o.time_unit, "s");
  const double m = unit_factor(o.length_unit, "m");
  const std::string speed = o.length_unit + "/" + o.time_unit;
  std::string out = "t [" + o.time_unit + "],r [" + o.length_unit + "],drdt [" + speed + "],d2rdt2 [" + speed +
                    "^2],force_fem [N],force_mode_fem [N]";
  for (const Closure closure : v.closures) out += ",force_" + std::string(name_of(closure)) + " [N]";
  out += "\n";
  for (const VerifiedRow& row : v.rows) {
    append_number(out, row.fem.time, s);
    const auto column = [&](double value, double factor = 1) {
      out += ',';
      append_number(out, value, factor);
    };
    column(row.state.radius, m);
    column(row.state.rate, m / s);
    column(row.state.acceleration, m / s / s);
    column(row.fem.force);
    column(row.fem.force_mode);
    for (const double force : row.models) column(force);
    out += "\n";
  }
  return out;
}

std::string verification_json(const Case& c, const Verification& v) {
  Json closures = Json::array();
  for (const Closure closure : v.closures) closures.push_back(name_of(closure));
  const Json document{{"title", c.title},
                      {"status", "complete"},
                      {"versions", {{"turgor", version}, {"compiler", compiler}}},
                      {"closure", name_of(c.parameters.closure)},
                      {"closures", closures},
                      {"finite_elements", fem_json(v.fem)},
                      {"force_mode", to_json(v.mode, v.closures)},
                      {"force", to_json(v.whole, v.closures)},
                      {"warnings", to_json(v.warnings)}};
  return dumped(document);
}

std::string verification_summary(const Case& c, const Verification& v) {
  return c.title + "\n" + fem_line(v.fem) + error_table(v.mode, v.closures, "force_mode") +
         error_table(v.whole, v.closures, "force") + ratio_table(v) + "\n" + warning_lines(v.warnings);
}

}  // namespace turgor
