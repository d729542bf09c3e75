#pragma once
// What the sources of this room share.

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

/// Which assumptions of the model this result strains, and by how much.
[[nodiscard]] std::vector<Warning> strained_assumptions(const Case& c, const RunResult& result);

/// The same for the size of the orifice alone, over a range of stretches.
[[nodiscard]] std::vector<Warning> strained_orifice(const Parameters<double>& p, const StretchRange& range);

/// A double as text in a table, in the unit that `factor` converts to; -0 becomes 0.
void append_number(std::string& out, double value, double factor = 1);

/// A line "  name              text" of a summary on the screen.
[[nodiscard]] std::string summary_line(const std::string& name, const std::string& text);

}  // namespace turgor
