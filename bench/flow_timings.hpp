#pragma once
// Fields and force coefficients of the flow inside the balloon.

#include <nlohmann/json.hpp>

namespace turgor::bench {

/// Processor times on one core [s], medians, and errors:
/// {table_coefficients_s, direct_coefficients_s (at 1e-13), truncated_s (20000 harmonics with the integral),
///  truncated_by_terms_s (the same double series term by term, from 2000 harmonics), field_s (200 x 200 places, all of
///  the balloon), field_error (relative, farther than r_ch/10 from the rim), field_by_series_s (the same places by the
///  Legendre series cut at 1e-8)}; kappa = 1/10.
[[nodiscard]] nlohmann::ordered_json flow_timings();

}  // namespace turgor::bench
