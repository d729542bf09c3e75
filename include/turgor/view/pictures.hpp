#pragma once
// Pictures of a run, drawn by gnuplot from the dense output and the events, never from sampled rows; and of a force
// history.

#include <filesystem>
#include <string>

#include "turgor/run/force_history.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// Draws history.{svg,png} (R over p against t) and portrait.{svg,png} (dR/dt against R, coloured by regime) into a
/// folder, and leaves the gnuplot scripts that made them beside them.
/// @return what went wrong, in words for a warning; empty when all is well (a missing gnuplot is no error of the run)
[[nodiscard]] std::string draw_pictures(const Case& c, const RunResult& result, const std::filesystem::path& folder);

/// Draws force.{svg,png} in the manner of the paper's figure 3: the dictated motion, normalised, over the force by each
/// closure against t.
[[nodiscard]] std::string draw_force(const Case& c, const ForceHistory& history, const std::filesystem::path& folder);

}  // namespace turgor
