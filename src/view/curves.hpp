#pragma once
// Curves for pictures: dense enough that nothing aliases, thin enough to draw.

#include <optional>
#include <string>
#include <vector>

#include "turgor/run/run_case.hpp"

namespace turgor {

struct CurvePoint {
  double x;
  double y;
  bool gap;  ///< the curve is interrupted before this point
};
using Curve = std::vector<CurvePoint>;

/// R against t = T clock, the parts of one regime or, without one, all. Where a column of the picture holds more points
/// than it can show, their extremes are kept: an oscillation too fast to see becomes its envelope, never another
/// oscillation.
[[nodiscard]] Curve stretch_curve(const Trajectory<double>& trajectory, std::optional<Regime> regime, double clock);

/// dR/dt = per_second dR/dT against R, the parts of one regime; points closer than a picture resolves are left out.
[[nodiscard]] Curve portrait_curve(const Trajectory<double>& trajectory, Regime regime, double per_second);

/// Pascals make unreadable axes, so pictures use kPa unless the case chose a unit.
[[nodiscard]] std::string picture_pressure_unit(const Case& c);

/// Gauge pressure against time, in the given units [s], [Pa]; jumps are drawn as vertical lines.
[[nodiscard]] Curve pressure_curve(const Case& c, double time_unit, double pressure_unit);

}  // namespace turgor
