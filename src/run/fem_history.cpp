#include "turgor/run/fem_history.hpp"

#include <array>
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

// [scales] follow from the closure, and a dictated motion uses neither them nor the elastic wall.
const std::array<std::string, 7> may_differ{"model", "output", "scales", "fem", "wall", "solve.samples", "solve.times"};

InvalidInput unfit(const fs::path& folder, std::string problem, std::string advice = {}) {
  return InvalidInput(option, "\"" + folder.string() + "\"", std::move(problem), std::move(advice));
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void require_same_case(const Case& c, const fs::path& folder) {
  const fs::path file = folder / "resolved.toml";
  const Node theirs = parse_toml(text_of(file), file.string());
  const Node ours = parse_toml(c.resolved, c.file.string());
  const auto difference = first_difference(theirs, ours, may_differ);
  if (!difference) return;
  const auto shown = [](const Node* node) { return node == nullptr ? "nothing" : node->text(); };
  throw unfit(folder,
              "belongs to another case: it has " + difference->path + " = " + shown(difference->first) + ", " +
                  c.file.string() + " has " + shown(difference->second),
              "name the run of this case, or repeat the --set of that run");
}

/// What extract_csv says, under the option that names the folder.
CsvExtract read_table(const fs::path& file) {
  try {
    return extract_csv(file, {{"t", "s"}, {"r", "m"}, {"force", "N"}, {"force_mode", "N"}});
  } catch (const InvalidInput& error) {
    const Issue& issue = error.issues().front();
    throw InvalidInput(option, issue.value, issue.problem, issue.advice);
  }
}

/// Rows must be those of the dictated motion, to what is left of the radius in a table of other units.
void require_motion(const Case& c, const fs::path& file, const std::vector<double>& times,
                    const std::vector<double>& radii) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto wrong = [&](const std::string& problem) {
      return InvalidInput(option, file.string() + ", row " + std::to_string(i + 2), problem, "compute the run again");
    };
    const double t = times[i];
    if (!(t >= 0 && t <= c.solve.t_end * (1 + rounding))) {
      throw wrong("t = " + shortest(t) + " s is not between 0 and solve.t_end");
    }
    if (i > 0 && !(t > times[i - 1])) throw wrong("t = " + shortest(t) + " s does not come after the row before");
    const double r = dictated_motion(c).at(t).radius;
    if (std::abs(radii[i] - r) > rounding * r) {
      throw wrong("at t = " + shortest(t) + " s it has r = " + shortest(radii[i]) + " m, where [motion] has " +
                  shortest(r) + " m");
    }
  }
}

/// Why a run may have come to no end; nothing when it has.
void warn(FemHistory& history, const Case& c, const fs::path& folder, bool cut) {
  const auto report = nlohmann::json::parse(history.report, nullptr, false);
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
  for (const char* needed : {"resolved.toml", "history.csv"}) {
    std::error_code error;
    if (!fs::is_regular_file(folder / needed, error)) {
      throw unfit(folder, std::string("is no run directory of `turgor fem flow`: it has no ") + needed);
    }
  }
  require_same_case(c, folder);
  const fs::path file = folder / "history.csv";
  const CsvExtract table = read_table(file);
  const auto& [times, radii, forces, mode_forces] =
      std::tie(table.columns[0], table.columns[1], table.columns[2], table.columns[3]);
  if (times.empty()) throw unfit(folder, "has no rows in its history.csv", "let the run come to its first row");
  require_motion(c, file, times, radii);
  FemHistory history{{}, text_of(folder / "run.json"), {}, {}};
  for (std::size_t i = 0; i < times.size(); ++i) history.rows.push_back({times[i], forces[i], mode_forces[i]});
  warn(history, c, folder, table.cut);
  return history;
}

}  // namespace turgor
