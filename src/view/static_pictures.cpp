#include "turgor/view/static_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "gnuplot.hpp"
#include "plot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

constexpr const char* shade = "'grey90'";

/// A unit of the axes of these pictures.
struct Shown {
  std::string unit;
  double factor;  ///< of the unit in SI units
  [[nodiscard]] double operator()(double value) const { return value / factor; }
};

Shown shown(const Case& c, const std::string& si) {
  std::string unit = si;
  if (si == "m") unit = c.output.length_unit;
  if (si == "s") unit = c.output.time_unit;
  if (si == "J") unit = c.output.energy_unit;
  if (si == "Pa") unit = c.output.pressure_unit == "Pa" ? "kPa" : c.output.pressure_unit;
  return {unit, unit == "1" ? 1 : unit_factor(unit, si)};
}

std::string label(const std::string& name, const Shown& shown) { return quoted(name + " [" + shown.unit + "]"); }

/// The stretches of a curve that are stable, or those that are not; both include limit points.
template <class Row, class Y, class X>
void append_part(Curve& part, const std::vector<Row>& rows, bool stable, const X& x, const Y& y) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool starts = i > 0 && rows[i - 1].stable != rows[i].stable;
    if (rows[i].stable == stable) {
      if (starts) part.push_back({x(rows[i - 1]), y(rows[i - 1]), true});
      part.push_back({x(rows[i]), y(rows[i]), i == 0});
    }
  }
}

Curve level(double y, double from, double to) { return {{from, y, false}, {to, y, false}}; }

void add_pressures(Plot& plot, const Case& c, const StaticStudy& study, const std::vector<StaticRow>& rows) {
  const Shown pa = shown(c, "Pa");
  const double from = rows.front().stretch;
  const double to = rows.back().stretch;
  const auto R = [](const StaticRow& row) { return row.stretch; };
  const auto p = [&](const StaticRow& row) { return pa(row.pressure); };
  Curve stable;
  Curve unstable;
  append_part(stable, rows, true, R, p);
  append_part(unstable, rows, false, R, p);
  plot.add("stable", stable, line_style(blue, "stable"));
  plot.add("unstable", unstable, line_style(vermilion, "unstable", unstable_dashes));
  for (std::size_t i = 0; i < study.windows.size(); ++i) {
    if (!study.windows[i].maxwell) continue;
    plot.add("maxwell" + std::to_string(i), level(pa(*study.windows[i].maxwell), from, to),
             line_style(green, i == 0 ? "equally deep wells (Maxwell)" : "", fine_dashes));
  }
  plot.add("final", level(pa(study.pressure), from, to), line_style("black", "final pressure", dots_and_dashes));
  Curve limits;
  Curve rests;
  for (const LimitPoint& point : study.limit_points) limits.push_back({point.stretch, pa(point.pressure), false});
  for (const Equilibrium& state : study.equilibria) rests.push_back({state.stretch, pa(study.pressure), false});
  plot.add("limits", limits, points_style(orange, "limit points", 5));
  plot.add("rests", rests, points_style("black", "equilibria at the final pressure"));
}

/// Commands that shade the bistable windows behind everything.
std::string shaded(const Case& c, const StaticStudy& study) {
  const Shown pa = shown(c, "Pa");
  std::string out;
  int number = 1;
  for (const BistableWindow& window : study.windows) {
    out += "set object " + std::to_string(number++) + " rectangle from graph 0, first " +
           rounded(pa(window.least), 10) + " to graph 1, first " + rounded(pa(window.greatest), 10) +
           " behind fc rgb " + shade + " fs solid noborder\n";
  }
  return out;
}

/// Highest energy worth showing: a little above the wells and what separates them, since beyond the outer wells energy
/// only rises.
std::string energy_range(const Case& c, const StaticStudy& study, const Curve& energy) {
  const Shown joule = shown(c, "J");
  if (study.wells.size() < 2) return "set yrange [*:*]\n";
  double least = joule(study.wells.front().energy);
  double greatest = least;
  for (const Equilibrium& state : study.equilibria) {
    const double at = joule(potential_energy(c.parameters, state.stretch, study.pressure));
    least = std::min(least, at);
    greatest = std::max(greatest, at);
  }
  greatest = std::max(greatest, energy.front().y);
  const double margin = 0.3 * (greatest - least);
  return "set yrange [" + rounded(least - margin, 10) + ":" + rounded(greatest + margin, 10) + "]\n";
}

}  // namespace

std::string draw_statics(const Case& c, const StaticStudy& study, const std::filesystem::path& folder,
                         const std::string& name) {
  const std::vector<StaticRow> rows = static_curve(c, study);
  const Shown pa = shown(c, "Pa");
  const Shown joule = shown(c, "J");
  Plot pressure;
  add_pressures(pressure, c, study, rows);

  Curve energy;
  for (const StaticRow& row : rows) {
    energy.push_back({row.stretch, joule(potential_energy(c.parameters, row.stretch, study.pressure)), false});
  }
  Curve bottoms;
  Curve tops;
  for (const Equilibrium& state : study.equilibria) {
    const double at = joule(potential_energy(c.parameters, state.stretch, study.pressure));
    (state.stable ? bottoms : tops).push_back({state.stretch, at, false});
  }
  Plot energies;
  energies.add("energy", energy, line_style(blue, ""));
  energies.add("bottoms", bottoms, points_style(green, "stable"));
  energies.add("tops", tops, points_style(vermilion, "unstable"));

  double highest = 0;  // near locking and in compression pressures leave every scale
  double lowest = std::min(0.0, pa(study.pressure));
  for (const LimitPoint& point : study.limit_points) highest = std::max(highest, pa(point.pressure));
  for (const StaticRow& row : rows) {
    if (study.limit_points.empty()) highest = std::max(highest, pa(row.pressure));
  }
  highest = std::max(highest, pa(study.pressure));

  std::string commands = "set multiplot\nset lmargin at screen 0.18; set rmargin at screen 0.97\n";
  commands += "set xrange [" + rounded(rows.front().stretch, 8) + ":" + rounded(rows.back().stretch, 8) + "]\n";
  commands += "set yrange [" + rounded(1.15 * lowest, 10) + ":" + rounded(1.3 * highest, 10) + "]\n";
  commands += "set tmargin at screen 0.92; set bmargin at screen 0.42\nset title " + quoted(c.title) + "\n";
  commands += "set ylabel " + label("static pressure", pa) + " offset 1\nset format x ''\n";
  commands += "set key bottom right font ',12' opaque\n" + shaded(c, study) + pressure.command();
  commands += "unset object\nset tmargin at screen 0.39; set bmargin at screen 0.12\nunset title\nset format x '%g'\n";
  commands += "set ylabel " + label("potential energy", joule) + " offset -0.5\nset xlabel 'stretch R = r/r_0 [1]'\n";
  commands +=
      "set key noopaque top center\n" + energy_range(c, study, energy) + energies.command() + "unset multiplot\n";
  constexpr PictureSize size{800, 720};
  return gnuplot(folder, name, pressure.data() + energies.data(), commands, size);
}

namespace {

/// A bistability map as data blocks and a plot command.
struct MapPlot {
  std::string data;
  std::string command;
};

MapPlot map_plot(const BistabilityMap& map, const MapLabels& labels, const std::vector<MapMark>& load) {
  const auto x = [&](double parameter) { return parameter / labels.parameter_unit; };
  const auto y = [&](double pressure) { return pressure / labels.pressure_unit; };
  std::string region = "$region << EOD\n";
  Curve lower;
  Curve upper;
  Curve maxwell;
  Curve cusps;
  for (const BistabilityMap::Row& row : map.rows) {
    region += rounded(x(row.parameter), 10) + " " + rounded(y(row.window.least), 10) + " " +
              rounded(y(row.window.greatest), 10) + "\n";
    lower.push_back({x(row.parameter), y(row.window.least), false});
    upper.push_back({x(row.parameter), y(row.window.greatest), false});
    if (row.window.maxwell) maxwell.push_back({x(row.parameter), y(*row.window.maxwell), false});
  }
  for (const Cusp& cusp : map.cusps) {
    const CurvePoint tip{x(cusp.parameter), y(cusp.pressure), false};
    cusps.push_back(tip);
    const bool first = map.rows.empty() || cusp.parameter < map.rows.front().parameter;
    for (Curve* curve : {&lower, &upper, &maxwell}) curve->insert(first ? curve->begin() : curve->end(), tip);
  }
  Curve marks;
  for (const MapMark& mark : load) marks.push_back({x(mark.parameter), y(mark.pressure), false});
  Plot plot;
  plot.add("upper", upper, line_style(vermilion, "maximum"));
  plot.add("lower", lower, line_style(blue, "minimum"));
  plot.add("maxwell", maxwell, line_style(green, "Maxwell", fine_dashes));
  plot.add("load", marks,
           marks.size() > 1 ? line_style("black", "this case", dots_and_dashes) : points_style("black", "this case"));
  plot.add("cusps", cusps, points_style(orange, "cusp", 5));
  const std::string command = plot.command();
  return {region + "EOD\n" + plot.data(), "plot $region with filledcurves lc rgb " + std::string(shade) +
                                              " title 'two stable states', \\\n     " + command.substr(5)};
}

std::string map_axes(const MapLabels& labels) {
  return "set xlabel " + quoted(labels.parameter) + "\nset ylabel " + quoted(labels.pressure) +
         " offset 1\nset key top left font ',11' maxrows 3 width -3\nset yrange [*:*]\nset offsets 0,0,graph "
         "0.18,graph 0.05\n";
}

MapLabels labels_of(const Case& c, const KeyRange& range) {
  const Shown key = shown(c, range.unit);
  const Shown pa = shown(c, "Pa");
  return {c.title, range.key + " [" + key.unit + "]", "pressure [" + pa.unit + "]", key.factor, pa.factor};
}

std::string x_range(const KeyRange& range, const Shown& key) {
  return "set xrange [" + rounded(key(range.from), 10) + ":" + rounded(key(range.to), 10) + "]\n";
}

Plot stretches_plot(const KeyStudy& over, const Shown& key) {
  Curve stable;
  Curve unstable;
  Curve turns;
  const auto x = [&](const RestPoint& point) { return key(point.parameter); };
  const auto R = [](const RestPoint& point) { return point.stretch; };
  for (const RestCurve& curve : over.equilibria) {
    append_part(stable, curve.points, true, x, R);
    append_part(unstable, curve.points, false, x, R);
    for (const RestPoint& point : curve.points) {
      if (point.turning) turns.push_back({x(point), R(point), false});
    }
  }
  Plot plot;
  plot.add("stable", stable, line_style(blue, "stable"));
  plot.add("unstable", unstable, line_style(vermilion, "unstable", unstable_dashes));
  plot.add("turns", turns, points_style(orange, "limit points", 5));
  return plot;
}

std::string draw_plane(const Case& c, const PlaneStudy& plane, const std::filesystem::path& folder) {
  const Shown first = shown(c, plane.first.unit);
  const Shown second = shown(c, plane.second.unit);
  Curve lines;
  for (const RestCurve& curve : plane.limit_points) {
    bool starts = true;
    for (const RestPoint& point : curve.points) {
      lines.push_back({first(point.first), second(point.parameter), starts});
      starts = false;
    }
  }
  Plot plot;
  plot.add("limits", lines, line_style(blue, ""));
  if (lines.empty()) return {};
  std::string commands =
      "set title " + quoted(c.title + ": limit points of the static pressure") + "\n" + x_range(plane.first, first);
  commands += "set yrange [" + rounded(second(plane.second.from), 10) + ":" + rounded(second(plane.second.to), 10) +
              "]\nset xlabel " + label(plane.first.key, first) + "\nset ylabel " + label(plane.second.key, second) +
              "\nunset key\n";
  return gnuplot(folder, "plane", plot.data(), commands + plot.command());
}

}  // namespace

std::string draw_over(const Case& c, const StaticStudy& study, const std::filesystem::path& folder) {
  const KeyStudy& over = study.over.value();
  const MapLabels labels = labels_of(c, over.range);
  const Shown key = shown(c, over.range.unit);
  const Plot stretches = stretches_plot(over, key);
  std::vector<MapMark> load;
  for (const RestCurve& curve : over.equilibria) {
    for (const RestPoint& point : curve.points) load.push_back({point.parameter, point.pressure});
  }
  std::ranges::sort(load, {}, &MapMark::parameter);
  const bool has_map = !over.map.rows.empty();
  const bool has_states = !over.equilibria.empty();
  const int panels = (has_map ? 1 : 0) + (has_states ? 1 : 0);
  std::string problem;
  if (panels > 0) {
    std::string commands = "set multiplot layout 1," + std::to_string(panels) + " title " + quoted(c.title) + "\n";
    commands += x_range(over.range, key);
    std::string data;
    if (has_states) {
      data += stretches.data();
      commands += "set title 'states of rest at the final pressure' font ',14'\nset xlabel " +
                  quoted(labels.parameter) +
                  "\nset ylabel 'stretch R = r/r_0 [1]' offset 1\nset key top left font ',11' maxrows 3 width -3\n" +
                  "set offsets 0,0,graph 0.15,graph 0.05\n" + stretches.command();
    }
    if (has_map) {
      const MapPlot map = map_plot(over.map, labels, load);
      data += map.data;
      commands += "set title 'pressures with two stable states' font ',14'\n" + map_axes(labels) + map.command;
    }
    const PictureSize size{panels == 2 ? 1200 : 800, 540};
    problem = gnuplot(folder, "over", data, commands + "unset multiplot\n", size);
  }
  if (study.plane && problem.empty()) problem = draw_plane(c, *study.plane, folder);
  return problem;
}

std::string draw_bistability_map(const BistabilityMap& map, const MapLabels& labels, const std::vector<MapMark>& load,
                                 const std::filesystem::path& folder, const std::string& name) {
  const MapPlot plot = map_plot(map, labels, load);
  return gnuplot(folder, name, plot.data,
                 "set title " + quoted(labels.title) + "\n" + map_axes(labels) +
                     "set autoscale xfix\nset offsets graph 0.04,0,graph 0.18,graph 0.05\n" + plot.command);
}

}  // namespace turgor
