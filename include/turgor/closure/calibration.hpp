#pragma once
// Closure::calibrated: the coefficients of (2.8) fitted to finite elements. Data, script and bands are in
// verification/calibrated-closure.

#include "turgor/flow/force_table.hpp"

namespace turgor {

/// Range of kappa = r_ch/r that the finite elements covered. Beyond it the fits go on as they are: smooth and positive
/// over all of ForceTable, and a guess.
inline constexpr double least_calibrated_kappa = 1.0 / 60;
inline constexpr double greatest_calibrated_kappa = 1.0 / 10;

/// Relative error bands of the fits over that range; with a channel that of the jet at an instant. Its mean in time is
/// within 3 % from kappa = 1/30 on, 10 % below.
struct CalibrationBand {
  double inertial;
  double centripetal;
};

/// @param channel  whether the orifice opens into one
[[nodiscard]] constexpr CalibrationBand calibration_band(bool channel) {
  return channel ? CalibrationBand{0.06, 0.2} : CalibrationBand{0.005, 0.005};
}

/// h3 = [4 pi^2 + 4 pi kappa ln(1/(2 kappa))]/(16 pi): the first two orders in kappa of the added mass of a sphere that
/// grows through the rim of a round hole with uniform pressure in it.
[[nodiscard]] double calibrated_inertial(double kappa);

/// h5, fitted to the force of a balloon that deflates at a constant rate.
/// @param channel  whether the orifice opens into one, from whose sharp edge the flow separates
[[nodiscard]] double calibrated_centripetal(double kappa, bool channel);

/// Both as a table.
[[nodiscard]] const ForceTable& calibrated_force_table(bool channel);

}  // namespace turgor
