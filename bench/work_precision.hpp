#pragma once
// Work against precision: this integrator and its peers on the reference trajectories.

#include <nlohmann/json.hpp>

namespace turgor::bench {

/// One entry per reference trajectory and tolerance: {case, tolerance, error, seconds, cvode_bdf_seconds,
/// cvode_adams_seconds, odeint_seconds}. error = max |R - R_ref| over the reference times; a peer's seconds are
/// interpolated (log-log, between its own tolerances) to that same error, null where it does not reach it.
[[nodiscard]] nlohmann::ordered_json work_precision();

}  // namespace turgor::bench
