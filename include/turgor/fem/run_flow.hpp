#pragma once
// Takes a flow from its beginning, or from a checkpoint, to the end of its case.

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "turgor/fem/flow_problem.hpp"
#include "turgor/fem/flow_run_folder.hpp"

namespace turgor {

/// A time at which steps end.
struct FlowStop {
  double time;  ///< [s]
  bool row;     ///< history.csv has a row
  bool field;   ///< fields/ has a file
};

/// Rows, fields, knots of the motion, and the end, in order. Times that agree to 1e-12 of the whole are one, so that no
/// step is a rounding error long.
[[nodiscard]] std::vector<FlowStop> flow_stops(const Case& c);

struct FlowRunOptions {
  double max_wall_seconds = std::numeric_limits<double>::infinity();
  Progress progress{};                                          ///< asked after every step
  std::vector<std::pair<std::string, std::string>> versions{};  ///< of libraries, for run.json
  bool pictures = false;                                        ///< of every field
};

struct FlowRunResult {
  std::string status;   ///< "complete", "failed" or "interrupted"
  std::string message;  ///< why it is not complete
  FlowSize size;
  long steps;                                                    ///< all of them, those before a resumption included
  double time;                                                   ///< reached [s]
  double radius, rate;                                           ///< then [m], [m/s]
  double wall_seconds;                                           ///< all of them
  long nonlinear_iterations, linear_iterations, factorisations;  ///< since the start or the resumption
  std::vector<Warning> warnings;
};

/// Advances a problem at t = 0, or at the state it has loaded from the folder's checkpoint, and writes everything into
/// the folder. A step that fails ends the run as "failed", with everything kept up to there; its message has time and
/// state.
/// @throws ComputationFailed when a file cannot be written
[[nodiscard]] FlowRunResult run_flow(const Case& c, FlowProblem& problem, FlowRunFolder& folder,
                                     const FlowRunOptions& options = {});

/// run.json: status, versions, size, work, timings, warnings.
[[nodiscard]] std::string flow_run_json(const Case& c, const FlowRunResult& result, const FlowRunOptions& options);
/// A few lines for the screen.
[[nodiscard]] std::string flow_run_summary(const Case& c, const FlowRunResult& result);

}  // namespace turgor
