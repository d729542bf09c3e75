#pragma once
// The Legendre series of the flow: coefficients A_m of (2.6), and the sums of appendix B as the paper truncates them.

#include <vector>

#include "turgor/flow/outflow_profile.hpp"

namespace turgor {

/// A_1 ... A_N of (2.6), element m - 1 holding A_m, and their derivatives with respect to eps.
struct Harmonics {
  double kappa;
  std::vector<double> amplitude;  ///< A_m
  std::vector<double> change;     ///< dA_m/deps

  [[nodiscard]] int count() const { return static_cast<int>(amplitude.size()); }
};

/// A_m of (2.7) by recurrences that lose no digits, in time proportional to `count`.
/// @param kappa  0 < kappa < 1
/// @param count  N >= 1
/// @throws InvalidInput when these are out of range
[[nodiscard]] Harmonics uniform_harmonics(double kappa, int count);

/// The coefficients (2.14) of any profile by quadrature, in time proportional to count^2 kappa.
/// @throws InvalidInput as uniform_harmonics()
[[nodiscard]] Harmonics profile_harmonics(double kappa, const OutflowProfile& profile, int count);

/// g3 and g5 of appendix B from the first N harmonics of every series. They approach the exact values slowly: N must be
/// some 15/eps.
struct TruncatedForce {
  double g3;
  double g5;                   ///< with the last, integral term of the double series
  double g5_without_integral;  ///< as the paper computes it
  double first_term;           ///< of the double series, 2 pi (2-eps) (sum A_m/2 (eps-1)^(m-1))^2/2
};

/// The double series in time N log N: the integral of v^2 over the wall is a sum over (a_m b_n)/(m - n), a product with
/// a Toeplitz matrix.
[[nodiscard]] TruncatedForce truncated_force(const Harmonics& a);

}  // namespace turgor
