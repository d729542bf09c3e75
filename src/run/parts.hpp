#pragma once
// The pieces of run_case(), each in its own source file.

#include "turgor/run/run_case.hpp"

namespace turgor {

/// Fills in the quantities of interest of a result whose trajectory and energies are there.
[[nodiscard]] std::vector<Quantity> quantities_of_interest(const RunResult& result);

/// Which assumptions of the model this result strains, and by how much.
[[nodiscard]] std::vector<Warning> strained_assumptions(const Case& c, const RunResult& result);

/// Least and greatest stretch on a trajectory.
struct StretchRange {
  double least;
  double greatest;
};
[[nodiscard]] StretchRange stretch_range(const Trajectory<double>& trajectory);

}  // namespace turgor
