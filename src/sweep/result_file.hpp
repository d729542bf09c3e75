#pragma once
// The NetCDF file of a finished sweep: a function of the case and its results alone.

#include <filesystem>

#include "journal.hpp"
#include "turgor/sweep/run_sweep.hpp"

namespace turgor {

/// Writes the file beside and renames it, so that it is either not there or whole. Memory does not grow with the number
/// of members.
/// @throws ComputationFailed when it cannot be written
[[nodiscard]] SweepSummary write_result(const std::filesystem::path& file, const Case& c, const SweepPlan& plan,
                                        const Journal& journal);

/// "pressure.segments[0].to" as a name in NetCDF: "pressure_segments_0_to".
[[nodiscard]] std::string netcdf_name(const std::string& key);

}  // namespace turgor
