#pragma once
// A run as text: JSON for programs, tables for spreadsheets, a summary for people.

#include <string>

#include "turgor/run/run_case.hpp"

namespace turgor {

/// run.json: status, versions, timings, integrator statistics, quantities of interest, model choice, warnings.
[[nodiscard]] std::string run_json(const Case& c, const RunResult& result);

/// trajectory.csv: one row per requested time, units of [output]; ends where the run ended.
[[nodiscard]] std::string trajectory_csv(const Case& c, const RunResult& result);

/// dimensionless.csv: T, R, dR/dT, P and regime at the same times, on the one clock of the case's scales.
[[nodiscard]] std::string dimensionless_csv(const Case& c, const RunResult& result);

/// events.csv: every change of regime.
[[nodiscard]] std::string events_csv(const Case& c, const RunResult& result);

/// A few lines for the screen; with `verbose` also the model comparison and the integrator's work.
[[nodiscard]] std::string summary(const Case& c, const RunResult& result, bool verbose);

/// Times of the rows of tables that a case asks for [s].
[[nodiscard]] std::vector<double> requested_times(const SolveSettings& solve);

/// A time at which tables have a row.
struct RowTime {
  double scaled;   ///< on the trajectory's clock
  double seconds;  ///< t [s]; exactly as requested
};

/// The requested times up to where the run ended. A run that came to rest stays there; one that ended early in another
/// way has its end as the last row.
[[nodiscard]] std::vector<RowTime> row_times(const Case& c, const RunResult& result);

/// A row of tables, SI units.
struct TrajectoryRow {
  PhysicalState state;
  Energies energies;
};
/// The rows of trajectory.csv; times are exactly as requested.
[[nodiscard]] std::vector<TrajectoryRow> trajectory_rows(const Case& c, const RunResult& result);

/// A double as text in a table, in the unit that `factor` converts to; -0 becomes 0.
void append_number(std::string& out, double value, double factor = 1);

/// A line "  name              text" of a summary on the screen.
[[nodiscard]] std::string summary_line(const std::string& name, const std::string& text);

}  // namespace turgor
