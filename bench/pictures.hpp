#pragma once
// Pictures of the comparisons, with the gnuplot scripts that draw them.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "valve_comparison.hpp"

namespace turgor::bench {

/// Time against error for some of the trajectories of work_precision(): work-precision.png.
void draw_work_precision(const nlohmann::ordered_json& entries, const std::filesystem::path& folder);

/// Maxima of y1 and rates of impact against q, by both programs: valve.png.
void draw_valve(const ValveComparison& valve, const std::filesystem::path& folder);

}  // namespace turgor::bench
