#pragma once
// The force of the liquid in a deflating balloon, tabulated against kappa = r_ch/r.

#include <cmath>
#include <limits>

namespace turgor {

/// h3 = kappa g3/(16 pi) and h5 = kappa^4 g5/(32 pi), with g3 and g5 of (2.8), and their derivatives with respect to
/// kappa. For uniform outflow both tend to 1 as kappa -> 0.
template <class T>
struct ForceFactors {
  T inertial, inertial_slope;
  T centripetal, centripetal_slope;
};

/// STAND-IN with the final interface; its numbers are fits good to 1e-4, to be replaced by the exact table.
class ForceTable {
 public:
  /// Uniform outflow, f = 1.
  static const ForceTable& uniform() {
    static const ForceTable table;
    return table;
  }

  static constexpr double least_kappa = 7.62939453125e-06;  // 2^-17
  static constexpr double greatest_kappa = 0.75;

  /// Not a number outside [least_kappa, greatest_kappa].
  template <class T>
  [[nodiscard]] ForceFactors<T> at(const T& kappa) const {
    using std::log;
    using std::sqrt;
    if (!(kappa >= T(least_kappa) && kappa <= T(greatest_kappa))) {
      const T nan = std::numeric_limits<T>::quiet_NaN();
      return {nan, nan, nan, nan};
    }
    const T pi = T(3.14159265358979323846L);
    const T root = sqrt(1 - kappa * kappa);
    const T eps = kappa * kappa / (1 + root);
    const T eps_slope = kappa / root;
    const T g3 = 8 * pi * kappa / eps + 2 * pi * (2 * log(2 / kappa) - 5) + T(10.4) * kappa;
    const T g3_slope = 8 * pi / eps - 8 * pi * kappa / (eps * eps) * eps_slope - 4 * pi / kappa + T(10.4);
    const T s = sqrt(eps);
    const T poly = 1 - sqrt(T(2)) * s + T(3.9934) * eps - T(8.8263) * eps * s + 4 * eps * eps;
    const T poly_slope = (-sqrt(T(2)) / (2 * s) + T(3.9934) - T(1.5) * T(8.8263) * s + 8 * eps) * eps_slope;
    const T k4 = kappa * kappa * kappa * kappa / 4;
    const T e2 = eps * eps;
    const T c = k4 / e2;
    const T c_slope = kappa * kappa * kappa / e2 - 2 * k4 / (e2 * eps) * eps_slope;
    return {kappa * g3 / (16 * pi), (g3 + kappa * g3_slope) / (16 * pi), c * poly, c_slope * poly + c * poly_slope};
  }
};

}  // namespace turgor
