#pragma once
// What the reports of both kinds of verification share.

#include <nlohmann/json.hpp>
#include <string>

#include "turgor/run/deviation.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {

using Json = nlohmann::ordered_json;

/// "mean_N", "rms_N", ... [unit], "greatest_at_s", and the same over a reference; null where that is 0.
[[nodiscard]] Json to_json(const Deviation& deviation, const std::string& unit, double reference);

[[nodiscard]] Json to_json(const std::vector<Warning>& warnings);

/// What identifies a run in its own report.
[[nodiscard]] Json fem_json(const std::string& status, const std::string& report, std::size_t rows, double t_last);
template <class Row>
[[nodiscard]] Json fem_json(const FemRun<Row>& fem) {
  return fem_json(fem.status, fem.report, fem.rows.size(), fem.rows.back().time);
}

/// The line of a summary on the run that is compared with.
[[nodiscard]] std::string fem_line(const std::string& status, std::size_t rows, double t_last);
template <class Row>
[[nodiscard]] std::string fem_line(const FemRun<Row>& fem) {
  return fem_line(fem.status, fem.rows.size(), fem.rows.back().time);
}

/// A cell of a table on the screen.
[[nodiscard]] std::string right(std::string text, std::size_t width);
[[nodiscard]] std::string left(std::string text, std::size_t width);
[[nodiscard]] std::string percent(double share);
/// In percent of a reference; a dash where that is 0.
[[nodiscard]] std::string percent_of(double value, double reference);

[[nodiscard]] std::string warning_lines(const std::vector<Warning>& warnings);
[[nodiscard]] std::string dumped(const Json& document);

}  // namespace turgor
