#pragma once

#include <filesystem>
#include <string>

#include "turgor/sweep/run_sweep.hpp"

namespace turgor {

/// Draws some of a sweep's quantities beside its file, one picture each: OUT-peak_stretch.svg, .png and .gp for OUT.nc.
/// A grid of two axes becomes a map, one of a single axis a curve, anything else a row of clouds, one for each axis.
/// @return what went wrong; empty when all pictures are there
[[nodiscard]] std::string draw_sweep(const Case& c, const SweepSummary& summary, const std::filesystem::path& output);

}  // namespace turgor
