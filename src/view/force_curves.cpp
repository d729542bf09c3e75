#include "force_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "turgor/run/force_history.hpp"

namespace turgor {

namespace {

using Motion = PrescribedMotion<double>;

struct Style {
  const char* colour;
  const char* dashes;
};
constexpr std::array closure_styles{Style{green, "'_. '"}, Style{orange, "'-'"}, Style{vermilion, "(14,8)"},
                                    Style{purple, "'. '"}, Style{blue, "'-. '"}};

/// value(t, state) along the motion, in the given unit of time; where it jumps it has both values.
template <class Value>
Curve curve_of(const Case& c, double time_unit, const Value& value) {
  constexpr int points = 2000;  // of the picture, and some in each phase
  constexpr int least_in_phase = 16;
  const Motion& motion = dictated_motion(c);
  Curve curve;
  for (const Motion::Interval& in : motion.intervals(c.solve.t_end)) {
    const int n = least_in_phase + static_cast<int>(points * (in.end - in.begin) / c.solve.t_end);
    for (int k = 0; k <= n; ++k) {
      const double t = k == n ? in.end : in.begin + (in.end - in.begin) * k / n;
      curve.push_back({t / time_unit, value(t, motion.within(in.phase, t)), false});
    }
  }
  return curve;
}

/// Divided by its greatest size; a curve that is zero throughout stays so.
Curve normalised(Curve curve) {
  double greatest = 0;
  for (const CurvePoint& point : curve) greatest = std::max(greatest, std::abs(point.y));
  for (CurvePoint& point : curve) point.y /= greatest > 0 ? greatest : 1;
  return curve;
}

}  // namespace

ForceUnit unit_for(double force) {
  ForceUnit unit{"N", 1};
  for (const char* name : {"kN", "MN", "GN"}) {
    if (force / unit.newtons > 5e3) unit = {name, unit.newtons * 1e3};
  }
  return unit;
}

std::string closure_style(Closure closure) { return closure_style(closure, std::string(name_of(closure)), false); }

std::string closure_style(Closure closure, const std::string& title, bool fine) {
  const Style& style = closure_styles.at(static_cast<std::size_t>(closure));
  return line_style(style.colour, title, fine ? fine_dashes : style.dashes);
}

Plot motion_plot(const Case& c, double time_unit, const std::string& prefix) {
  const double start = dictated_motion(c).at(0).radius;
  const auto curve = [&](const auto& value) {
    return normalised(curve_of(c, time_unit, [&](double, const Motion::State& state) { return value(state); }));
  };
  Plot plot(prefix);
  plot.add("change", curve([&](const Motion::State& state) { return state.radius - start; }),
           line_style(blue, "r - r(0)"));
  plot.add("velocity", curve([](const Motion::State& state) { return state.rate; }),
           line_style(vermilion, "dr/dt", "'-'"));
  plot.add("acceleration", curve([](const Motion::State& state) { return -state.acceleration; }),
           line_style("black", "-d^2r/dt^2", "'_. '"));
  return plot;
}

void add_forces(Plot& plot, const Case& c, const std::vector<Closure>& closures, double time_unit,
                const ForceUnit& unit) {
  for (const Closure closure : closures) {
    const std::string name(name_of(closure));
    const auto force = [&](double t, const Motion::State& state) {
      return forces_at(c, {closure}, t, state).all.front() / unit.newtons;
    };
    plot.add(name, curve_of(c, time_unit, force), closure_style(closure));
  }
}

void add_finite_elements(Plot& plot, const FemHistory& fem, double time_unit, const ForceUnit& unit) {
  Curve curve;
  for (const FemForces& row : fem.rows) curve.push_back({row.time / time_unit, row.force_mode / unit.newtons, false});
  plot.add("fem", curve, line_style("black", "finite elements"));
}

void add_radius(Plot& plot, const Case& c, double time_unit, double length_unit) {
  plot.add("radius",
           curve_of(c, time_unit, [&](double, const Motion::State& state) { return state.radius / length_unit; }),
           "lines axes x1y2 lw 2 lc rgb '" + std::string(blue) + "' dt '. ' title 'r'");
}

}  // namespace turgor
