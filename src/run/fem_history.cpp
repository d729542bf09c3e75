#include "turgor/run/fem_history.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tuple>

#include "../case/csv_table.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

constexpr const char* option = "--fem";

/// The two kinds of runs.
struct Kind {
  const char* command;
  std::vector<std::string> may_differ;  ///< parts of the case
  std::vector<CsvName> columns;
};

// [scales] follow from the closure, and a dictated motion uses neither them nor the elastic wall.
const Kind dictated{"turgor fem flow",
                    {"model", "output", "scales", "fem", "wall", "expect", "solve.samples", "solve.times"},
                    {{"t", "s"}, {"r", "m"}, {"force", "N"}, {"force_mode", "N"}}};
const Kind coupled{
    "turgor fem fsi",
    {"model", "output", "scales", "fem", "expect", "solve.samples", "solve.times"},
    {{"t", "s"}, {"p_gauge", "Pa"}, {"r_eff", "m"}, {"dr_effdt", "m/s"}, {"volume", "m^3"}, {"elastic", "J"}}};

InvalidInput unfit(const fs::path& folder, std::string problem, std::string advice = {}) {
  return InvalidInput(option, "\"" + folder.string() + "\"", std::move(problem), std::move(advice));
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void require_same_case(const Case& c, const fs::path& folder, const Kind& kind) {
  const fs::path file = folder / "resolved.toml";
  const Node theirs = parse_toml(text_of(file), file.string());
  const bool theirs_dictated = theirs.find("motion") != nullptr;
  if (theirs_dictated != c.motion.has_value()) {
    throw unfit(folder,
                theirs_dictated ? "is a run of dictated motion, and " + c.file.string() + " leaves the balloon free"
                                : "is a run of an elastic balloon, and " + c.file.string() + " dictates the motion",
                std::string("name a run of `") + kind.command + "`");
  }
  const Node ours = parse_toml(c.resolved, c.file.string());
  const auto difference = first_difference(theirs, ours, kind.may_differ);
  if (!difference) return;
  const auto shown = [](const Node* node) { return node == nullptr ? "nothing" : node->text(); };
  throw unfit(folder,
              "belongs to another case: it has " + difference->path + " = " + shown(difference->first) + ", " +
                  c.file.string() + " has " + shown(difference->second),
              "name the run of this case, or repeat the --set of that run");
}

fs::path table_in(const fs::path& folder) { return folder / "history.csv"; }

/// What extract_csv says, under the option that names the folder.
CsvExtract read_table(const fs::path& folder, const Kind& kind) {
  try {
    return extract_csv(table_in(folder), kind.columns);
  } catch (const InvalidInput& error) {
    const Issue& issue = error.issues().front();
    throw InvalidInput(option, issue.value, issue.problem, issue.advice);
  }
}

/// The table of a run of this case, with at least one row.
CsvExtract read_run(const Case& c, const fs::path& folder, const Kind& kind) {
  for (const char* needed : {"resolved.toml", "history.csv"}) {
    std::error_code error;
    if (!fs::is_regular_file(folder / needed, error)) {
      throw unfit(folder, std::string("is no run directory of `") + kind.command + "`: it has no " + needed);
    }
  }
  require_same_case(c, folder, kind);
  CsvExtract table = read_table(folder, kind);
  if (table.columns.front().empty()) {
    throw unfit(folder, "has no rows in its history.csv", "let the run come to its first row");
  }
  return table;
}

constexpr double rounding = 1e-9;  // of what was written in other units

InvalidInput wrong_row(const fs::path& folder, std::size_t row, const std::string& problem) {
  return {option, table_in(folder).string() + ", row " + std::to_string(row + 2), problem, "compute the run again"};
}

void require_times(const Case& c, const fs::path& folder, const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string t = "t = " + shortest(times[i]) + " s ";
    if (!(times[i] >= 0 && times[i] <= c.solve.t_end * (1 + rounding))) {
      throw wrong_row(folder, i, t + "is not between 0 and solve.t_end");
    }
    if (i > 0 && !(times[i] > times[i - 1])) throw wrong_row(folder, i, t + "does not come after the row before");
  }
}

/// Rows must be those of the dictated motion, to what is left of the radius in a table of other units.
void require_motion(const Case& c, const fs::path& folder, const std::vector<double>& times,
                    const std::vector<double>& radii) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double r = dictated_motion(c).at(times[i]).radius;
    if (std::abs(radii[i] - r) <= rounding * r) continue;
    throw wrong_row(folder, i,
                    "at t = " + shortest(times[i]) + " s it has r = " + shortest(radii[i]) + " m, where [motion] has " +
                        shortest(r) + " m");
  }
}

/// Rows must have the pressure of the program; where it jumps, that from either side.
void require_pressure(const Case& c, const fs::path& folder, const std::vector<double>& times,
                      const std::vector<double>& pressures) {
  const double margin = rounding * c.solve.t_end;
  const PressureRange<double> range = range_of(c.pressure, c.solve.t_end);
  const double tolerance = rounding * std::max(std::abs(range.least), std::abs(range.greatest));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto [low, high] = std::minmax({c.pressure(times[i] - margin), c.pressure(times[i] + margin)});
    if (pressures[i] >= low - tolerance && pressures[i] <= high + tolerance) continue;
    throw wrong_row(folder, i,
                    "at t = " + shortest(times[i]) + " s it has p_gauge = " + shortest(pressures[i]) +
                        " Pa, where [pressure] has " + shortest(c.pressure(times[i])) + " Pa");
  }
}

void require_positive(const fs::path& folder, const std::vector<double>& radii) {
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (!(radii[i] > 0)) throw wrong_row(folder, i, "r_eff = " + shortest(radii[i]) + " m is not positive");
  }
}

/// Why a run may have come to no end; nothing when it has.
template <class Row>
void warn(FemRun<Row>& history, const Case& c, const fs::path& folder, bool cut) {
  const nlohmann::json report = nlohmann::json::parse(history.report, nullptr, false);
  const auto text = [&](const char* key) {
    return report.is_object() && report.contains(key) && report[key].is_string() ? report[key].get<std::string>() : "";
  };
  history.status = text("status").empty() ? "unknown" : text("status");
  if (history.status != "complete") {
    const std::string message = text("message").empty() ? "" : ": " + text("message");
    history.warnings.push_back(
        {"fem-incomplete", "the run in " + folder.string() + " is not complete (status \"" + history.status + "\"" +
                               message + "); compared are its rows up to t = " + rounded(history.rows.back().time, 6) +
                               " of " + rounded(c.solve.t_end, 6) + " s"});
  }
  if (cut) {
    history.warnings.push_back(
        {"fem-cut", "the last line of history.csv in " + folder.string() + " is cut off; it is left out"});
  }
}

}  // namespace

FemHistory read_fem_history(const Case& c, const fs::path& folder) {
  const CsvExtract table = read_run(c, folder, dictated);
  const auto& [times, radii, forces, mode_forces] =
      std::tie(table.columns[0], table.columns[1], table.columns[2], table.columns[3]);
  require_times(c, folder, times);
  require_motion(c, folder, times, radii);
  FemHistory history{{}, text_of(folder / "run.json"), {}, {}};
  for (std::size_t i = 0; i < times.size(); ++i) history.rows.push_back({times[i], forces[i], mode_forces[i]});
  warn(history, c, folder, table.cut);
  return history;
}

FemResponse read_fem_response(const Case& c, const fs::path& folder) {
  const CsvExtract table = read_run(c, folder, coupled);
  const auto& [times, pressures, radii, rates, volumes, energies] = std::tie(
      table.columns[0], table.columns[1], table.columns[2], table.columns[3], table.columns[4], table.columns[5]);
  require_times(c, folder, times);
  require_pressure(c, folder, times, pressures);
  require_positive(folder, radii);
  FemResponse response{{}, text_of(folder / "run.json"), {}, {}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    response.rows.push_back({times[i], pressures[i], radii[i], rates[i], volumes[i], energies[i]});
  }
  warn(response, c, folder, table.cut);
  return response;
}

}  // namespace turgor
