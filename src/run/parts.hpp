#pragma once
// What the sources of this room share.

#include "turgor/run/report.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// Fills in the quantities of interest of a result whose trajectory and energies are there.
[[nodiscard]] std::vector<Quantity> quantities_of_interest(const RunResult& result);

/// Least and greatest stretch on a trajectory.
struct StretchRange {
  double least;
  double greatest;
};
[[nodiscard]] StretchRange stretch_range(const Trajectory<double>& trajectory);

/// Greatest mean speeds in the orifice on a trajectory [m/s], not negative.
struct OrificeSpeeds {
  double in;
  double out;
};
[[nodiscard]] OrificeSpeeds orifice_speeds(const RunResult& result);

/// Which assumptions of the model this result strains, and by how much.
[[nodiscard]] std::vector<Warning> strained_assumptions(const Case& c, const RunResult& result);

/// The same for the size of the orifice alone, over a range of stretches.
[[nodiscard]] std::vector<Warning> strained_orifice(const Parameters<double>& p, const StretchRange& range);

}  // namespace turgor
