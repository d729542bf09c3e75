#include "turgor/closure/calibration.hpp"

#include <cmath>
#include <numbers>

namespace turgor {

namespace {

// Printed by verification/calibrated-closure/fit.py.
constexpr double orifice_at_zero = 1.7224;
constexpr double orifice_slope = -0.8775;
constexpr double channel_mean = 1.6159;

ForceTable make_table(bool channel) {
  return {calibrated_inertial, [channel](double kappa) { return calibrated_centripetal(kappa, channel); }};
}

}  // namespace

double calibrated_inertial(double kappa) { return std::numbers::pi / 4 - kappa / 4 * std::log(2 * kappa); }

double calibrated_centripetal(double kappa, bool channel) {
  return channel ? channel_mean : orifice_at_zero + orifice_slope * kappa;
}

const ForceTable& calibrated_force_table(bool channel) {
  static const ForceTable orifice_table = make_table(false);
  static const ForceTable channel_table = make_table(true);
  return channel ? channel_table : orifice_table;
}

}  // namespace turgor
