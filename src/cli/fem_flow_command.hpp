#pragma once
// turgor fem flow: the flow under a dictated motion; turgor fem fsi: that of a balloon with an elastic wall.

#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "turgor/fem/flow_problem.hpp"

namespace turgor::cli {

struct FemFlowArguments {
  CaseArguments input;
  std::string directory;
  bool force = false;
  bool resume = false;
  bool no_pictures = false;
  bool quiet = false;
  double max_wall_seconds = 0;  ///< 0: no limit
};

/// Declares `flow` (dictated motion) or `fsi` (elastic wall) with its arguments, which must outlive `fem`.
CLI::App* add_fem_flow(CLI::App& fem, FemFlowArguments& arguments);
CLI::App* add_fem_fsi(CLI::App& fem, FemFlowArguments& arguments);

/// Runs it and returns the exit code.
/// @param versions  of the libraries behind the solver
int compute_fem_flow(const FemFlowArguments& arguments, const FlowProblemMaker& make_problem,
                     const std::vector<std::pair<std::string, std::string>>& versions);

}  // namespace turgor::cli
