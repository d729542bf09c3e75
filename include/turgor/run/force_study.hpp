#pragma once
// The force coefficients of (2.8) against kappa, and what an outflow profile makes of them.

#include <optional>
#include <string>
#include <vector>

#include "turgor/flow/force_coefficients.hpp"
#include "turgor/flow/harmonics.hpp"

namespace turgor {

/// g1...g5 at one kappa = r_ch/r, beside their approximations for uniform outflow.
struct CoefficientRow {
  double kappa;
  double eps;
  ForceCoefficients exact;
  ForceCoefficients paper;  ///< (2.9), (2.10)
  ForceCoefficients close;  ///< close_fits()
  std::optional<TruncatedForce> truncated;
};

/// @param kappas     least table kappa (2^-17) to 1, 1 excluded
/// @param harmonics  number of harmonics of the paper's truncated sums; 0: without them
/// @throws InvalidInput when kappa is out of range
[[nodiscard]] std::vector<CoefficientRow> coefficient_table(const std::vector<double>& kappas,
                                                            const OutflowProfile& profile, int harmonics);

/// Every number of every row; relative errors are approximation/exact - 1.
[[nodiscard]] std::string coefficients_csv(const std::vector<CoefficientRow>& rows);
[[nodiscard]] std::string coefficients_json(const std::vector<CoefficientRow>& rows);
/// Two tables for the screen.
[[nodiscard]] std::string coefficients_text(const std::vector<CoefficientRow>& rows);

/// How much a profile changes the liquid's inertial and centripetal forces: g3 and g5 over those of uniform outflow.
struct ProfileFactors {
  double inertial;
  double centripetal;
};

/// The constants of (2.15) in the paper's notation, 223/32 and 75/32 there: those of (2.12), 9 sqrt2/2 and 3/2, times
/// the factors.
struct ProfileConstants {
  double inertial;
  double centripetal;
};
[[nodiscard]] ProfileConstants closure_constants(const ProfileFactors& factors);

struct ProfileRow {
  double kappa;
  ProfileFactors exact;
  /// As in the paper, section 2.3: truncated sums, the centripetal factor from the first term of the double series.
  ProfileFactors paper;
};

struct ProfileStudy {
  OutflowProfile profile;
  int harmonics;
  std::vector<ProfileRow> rows;
  ProfileFactors exact;  ///< means over the rows
  ProfileFactors paper;
};

/// @throws InvalidInput when kappa or the number of harmonics is out of range
[[nodiscard]] ProfileStudy study_profile(OutflowProfile profile, const std::vector<double>& kappas, int harmonics);

[[nodiscard]] std::string profile_csv(const ProfileStudy& study);
[[nodiscard]] std::string profile_json(const ProfileStudy& study);
[[nodiscard]] std::string profile_text(const ProfileStudy& study);

}  // namespace turgor
