#pragma once
// Many balloons: SIMD lanes against CVODE, against one lane, and on two threads.

#include <nlohmann/json.hpp>

namespace turgor::bench {

/// Water balloons of section 2.5 with random orifices (r_ch log-uniform in 1 ... 3 cm, no channel) under random
/// pressure (up in 2 s, held for 2 s, down in 2 s; 30 ... 40 kPa), full model, 12 s; errors are of R at the end.
/// {members, rtol, instruction_set, chunk,
///  seconds: of all members on one core, processor time,
///  rms_error, largest_error: of the first `compared`,
///  cvode_seconds: CVODE BDF's for as many members at our rms_error, interpolated (log-log) between two tolerances,
///  cvode_tolerances, cvode_rms_errors, cvode_largest_errors: of these two; cvode_stuck: members that it
///  does not bring to their end, left out of its errors and time,
///  over_cvode: how many times longer CVODE takes,
///  simd_over_scalar, simd_avx2_over_scalar: members per second against one lane,
///  threads_2_over_1: by the clock on the wall, which other programs on the machine slow down,
///  threads_2_processor_time: of both together over that of one thread, which they do not}
[[nodiscard]] nlohmann::ordered_json ensemble_comparison();

}  // namespace turgor::bench
