#include "verification_parts.hpp"

#include "turgor/base/text.hpp"
#include "turgor/run/report.hpp"

namespace turgor {

namespace {

Json relative(double value, double reference) { return reference > 0 ? Json(value / reference) : Json(nullptr); }

}  // namespace

Json to_json(const Deviation& of, const std::string& unit, double reference) {
  return {{"mean_" + unit, of.mean},
          {"rms_" + unit, of.rms},
          {"greatest_" + unit, of.greatest},
          {"greatest_at_s", of.greatest_time},
          {"mean", relative(of.mean, reference)},
          {"rms", relative(of.rms, reference)},
          {"greatest", relative(of.greatest, reference)}};
}

Json to_json(const std::vector<Warning>& warnings) {
  Json list = Json::array();
  for (const Warning& warning : warnings) list.push_back({{"name", warning.name}, {"text", warning.text}});
  return list;
}

Json fem_json(const std::string& status, const std::string& text, std::size_t rows, double t_last) {
  const Json report = Json::parse(text, nullptr, false);
  Json out{{"status", status}, {"rows", rows}, {"t_last_s", t_last}};
  for (const char* key : {"versions", "discretisation", "steps"}) {
    if (report.is_object() && report.contains(key)) out[key] = report[key];
  }
  return out;
}

std::string fem_line(const std::string& status, std::size_t rows, double t_last) {
  return summary_line("finite elements",
                      status + ", " + std::to_string(rows) + " rows up to " + rounded(t_last, 6) + " s");
}

std::string right(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

std::string left(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string percent(double share) { return rounded(100 * share, 3); }

std::string percent_of(double value, double reference) { return reference > 0 ? percent(value / reference) : "-"; }

std::string warning_lines(const std::vector<Warning>& warnings) {
  std::string out;
  for (const Warning& warning : warnings) out += "  warning: " + warning.text + "\n";
  return out;
}

std::string dumped(const Json& document) { return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace turgor
