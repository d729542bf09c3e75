#pragma once
// The balloon at rest: static pressure, equilibria, limit points. Double precision, any material.

#include <vector>

#include "turgor/oscillator/parameters.hpp"

namespace turgor {

/// Gauge pressure [Pa] that holds the balloon at rest at stretch R: eq. (3.1) for any material,
/// p0 = d0 W'(R)/(r0 R^2), and its slope dp0/dR [Pa]. With an exact closure R^2 h1 takes the place of R^2: the pressure
/// does not work on the opening.
/// @param R  0 < R < stretch_limit(material); compressed states (R < 1) give negative pressure
struct StaticPressure {
  double value;
  double slope;
};
[[nodiscard]] StaticPressure static_pressure(const Parameters<double>& p, double R);

/// An extremum of the static pressure: the equilibrium branch folds there.
struct LimitPoint {
  double stretch;
  double pressure;  ///< [Pa]
  bool maximum;     ///< a maximum (snap-through when inflating) or a minimum (when deflating)
};

/// All limit points with R > 1, up to the locking stretch or largest_stretch, in order of R.
[[nodiscard]] std::vector<LimitPoint> limit_points(const Parameters<double>& p);

/// A state of rest at a given pressure.
struct Equilibrium {
  double stretch;
  bool stable;  ///< dp0/dR > 0
};

/// All equilibria at gauge pressure [Pa], in order of R; none when the pressure is out of reach of the material.
/// Sought between smallest_stretch and the stretch limit (or largest_stretch), and within closure_limits().
[[nodiscard]] std::vector<Equilibrium> equilibria(const Parameters<double>& p, double pressure);

/// Stretches between which equilibria are sought.
[[nodiscard]] StretchLimits<double> statics_limits(const Parameters<double>& p);

/// No balloon is compressed below: nothing is sought there, nor outside closure_limits().
inline constexpr double smallest_stretch = 0.05;

}  // namespace turgor
