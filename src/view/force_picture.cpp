#include <algorithm>
#include <array>
#include <cmath>

#include "gnuplot.hpp"
#include "plot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/view/pictures.hpp"

namespace turgor {

namespace {

using Motion = PrescribedMotion<double>;

struct Style {
  const char* colour;
  const char* dashes;
};
constexpr std::array closure_styles{Style{green, "'_. '"}, Style{orange, "'-'"}, Style{vermilion, "1"},
                                    Style{"black", "'. '"}};

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

/// N, kN, MN, ...: such that the numbers of an axis stay short.
struct ForceUnit {
  std::string name;
  double newtons;
};
ForceUnit unit_for(double force) {
  ForceUnit unit{"N", 1};
  for (const char* name : {"kN", "MN", "GN"}) {
    if (force / unit.newtons > 5e3) unit = {name, unit.newtons * 1e3};
  }
  return unit;
}

/// The radii of a motion [m] with some room, so that no curve lies on the frame.
std::string radius_range(const RadiusRange<double>& radius, double m) {
  const double way = radius.greatest - radius.least;
  const double room = way > 1e-7 * radius.greatest ? 0.06 * way : 1e-3 * radius.greatest;
  return "[" + rounded((radius.least - room) / m, 10) + ":" + rounded((radius.greatest + room) / m, 10) + "]";
}

Plot motion_plot(const Case& c, double s) {
  const double start = dictated_motion(c).at(0).radius;
  const auto curve = [&](const auto& value) {
    return normalised(curve_of(c, s, [&](double, const Motion::State& state) { return value(state); }));
  };
  Plot plot;
  plot.add("change", curve([&](const Motion::State& state) { return state.radius - start; }),
           line_style(blue, "r - r(0)"));
  plot.add("velocity", curve([](const Motion::State& state) { return state.rate; }),
           line_style(vermilion, "dr/dt", "'-'"));
  plot.add("acceleration", curve([](const Motion::State& state) { return -state.acceleration; }),
           line_style("black", "-d^2r/dt^2", "'_. '"));
  return plot;
}

Plot force_plot(const Case& c, double s, double m, const ForceUnit& unit) {
  Plot plot;
  plot.add("radius", curve_of(c, s, [&](double, const Motion::State& state) { return state.radius / m; }),
           "lines axes x1y2 lw 2 lc rgb '" + std::string(blue) + "' dt '. ' title 'r'");
  for (const Closure closure : compared_closures(c)) {
    const std::string name(name_of(closure));
    const Style& style = closure_styles.at(static_cast<std::size_t>(closure));
    const auto force = [&](double t, const Motion::State& state) {
      return forces_at(c, {closure}, t, state).all.front() / unit.newtons;
    };
    plot.add(name, curve_of(c, s, force), line_style(style.colour, name, style.dashes));
  }
  return plot;
}

}  // namespace

std::string draw_force(const Case& c, const ForceHistory& history, const std::filesystem::path& folder) {
  const double s = unit_factor(c.output.time_unit, "s");
  const double m = unit_factor(c.output.length_unit, "m");
  double greatest = 0;
  for (const ForceSummary& of : history.closures) greatest = std::max(greatest, std::abs(of.peak.force));
  const ForceUnit unit = unit_for(greatest);
  const Plot motion = motion_plot(c, s);
  const Plot force = force_plot(c, s, m, unit);

  std::string commands = "set multiplot\nset lmargin at screen 0.115; set rmargin at screen 0.85\n";
  commands += "set xrange [0:" + rounded(c.solve.t_end / s, 10) + "]\nset xzeroaxis lt 1 lc rgb 'grey60'\n";
  commands += "set tmargin at screen 0.86; set bmargin at screen 0.60\n";
  commands += "set title " + quoted(c.title) + " offset 0,1.2\n";
  commands += "set ylabel 'normalised [1]' offset 1\nset format x ''\nset yrange [-1.1:1.1]\nset ytics 1\n";
  commands += "set key at graph 1, graph 1.03 right bottom horizontal samplen 3\n" + motion.command();
  commands += "set tmargin at screen 0.51; set bmargin at screen 0.13\nunset title\nset format x '%g'\n";
  commands += "set autoscale y\nset ytics autofreq nomirror\nset y2tics nomirror textcolor rgb '" + std::string(blue) +
              "'\nset offsets 0,0,graph 0.06,graph 0.06\nset y2range " + radius_range(history.radius, m) + "\n";
  commands += "set xlabel 't [" + c.output.time_unit + "]'\nset ylabel 'F [" + unit.name + "]' offset 1\n";
  commands += "set y2label 'r [" + c.output.length_unit + "]' textcolor rgb '" + std::string(blue) + "' offset -1\n";
  commands += force.command() + "unset multiplot\n";
  return gnuplot(folder, "force", motion.data() + force.data(), commands);
}

}  // namespace turgor
