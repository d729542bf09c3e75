#pragma once
// Parameter studies through the command line.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace turgor::bench {

/// The shipped sweep on a finer grid, from start-up to finished file: {members, threads_1_per_second,
/// threads_2_per_second, ranks_1_per_second, ranks_2_per_second}, members per second by the clock on the wall; ranks
/// have one thread each, and are null without mpirun. Null when the program was built without `turgor sweep`.
[[nodiscard]] nlohmann::ordered_json sweep_timings(const std::string& program, const std::filesystem::path& cases,
                                                   const std::filesystem::path& scratch);

}  // namespace turgor::bench
