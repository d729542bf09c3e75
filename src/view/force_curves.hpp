#pragma once
// Dictated motions and their forces as curves.

#include <string>
#include <vector>

#include "plot.hpp"
#include "turgor/closure/closure.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {

/// N, kN, MN, ...: such that the numbers of an axis stay short.
struct ForceUnit {
  std::string name;
  double newtons;
};
[[nodiscard]] ForceUnit unit_for(double force);

/// r - r(0), dr/dt and -d2r/dt2 against time [s], each divided by its greatest size.
/// @param prefix  of the plot's data blocks
[[nodiscard]] Plot motion_plot(const Case& c, double time_unit, const std::string& prefix = {});

/// The force by some closures against time, in the given units [s], [N].
void add_forces(Plot& plot, const Case& c, const std::vector<Closure>& closures, double time_unit,
                const ForceUnit& unit);

/// How the force by a closure is drawn.
[[nodiscard]] std::string closure_style(Closure closure);
/// The same with another title.
/// @param fine  as a fine dotted line of that colour
[[nodiscard]] std::string closure_style(Closure closure, const std::string& title, bool fine);

/// The force by finite elements, as far as it goes, in the given units.
void add_finite_elements(Plot& plot, const FemHistory& fem, double time_unit, const ForceUnit& unit);

/// The radius, dotted, on the second y axis, in the given units [s], [m].
void add_radius(Plot& plot, const Case& c, double time_unit, double length_unit);

}  // namespace turgor
