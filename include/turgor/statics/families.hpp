#pragma once
// States of rest and limit points of balloons that depend on one or two parameters, as curves.

#include <functional>
#include <vector>

#include "turgor/statics/bistability.hpp"
#include "turgor/statics/continuation.hpp"

namespace turgor {

/// A balloon and the gauge pressure [Pa] at its inlet.
struct LoadedBalloon {
  Parameters<double> parameters;
  double pressure;
};
using LoadedFamily = std::function<LoadedBalloon(double)>;
using TwoParameterFamily = std::function<LoadedBalloon(double first, double second)>;

/// Values of a parameter, in its own unit; from < to.
struct ParameterRange {
  double from;
  double to;
};

/// One point of a curve of states of rest.
struct RestPoint {
  double parameter;  ///< the last one of the family
  double first;      ///< the other one of a family of two; 0 else
  double stretch;
  double pressure;  ///< [Pa]
  bool stable;      ///< dp0/dR > 0; false on curves of limit points
  bool turning;     ///< the parameter turns back here: a limit point, or on a curve of limit points a cusp
};

struct RestCurve {
  std::vector<RestPoint> points;
  BranchEnd end;
};

/// Equilibria at the family's own pressure against its parameter: every curve that meets an end of the range.
/// By follow_branch() in ln R and the parameter over its range. Curves that close within the range are not found.
/// @throws what the family throws
[[nodiscard]] std::vector<RestCurve> equilibrium_curves(const LoadedFamily& family, const ParameterRange& range);

/// Limit points with R > 1 and their pressures against the family's parameter: every curve that meets an end of the
/// range. They turn at cusps.
[[nodiscard]] std::vector<RestCurve> limit_point_curves(const BalloonFamily& family, const ParameterRange& range);

/// Pairs of parameters at which an equilibrium is a limit point: where, in the plane of both, the number of equilibria
/// changes. Every curve that meets an end of either range.
[[nodiscard]] std::vector<RestCurve> limit_point_curves(const TwoParameterFamily& family, const ParameterRange& first,
                                                        const ParameterRange& second);

}  // namespace turgor
