// Figure 7 and the bistability map: the balloon at rest.

#include <cmath>

#include "makers.hpp"
#include "turgor/asymptotics/equilibria.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/static_study.hpp"
#include "turgor/view/static_pictures.hpp"

namespace turgor {

namespace {

Table static_table(const Case& c, const StaticStudy& study) {
  const double unit = mooney_rivlin_unit(c.parameters);
  Table table("R [1],p_gauge [Pa],P0/S2 [1],stable,limit point,potential energy at the mean pressure [J]");
  for (const StaticRow& row : static_curve(c, study)) {
    table.add({row.stretch, row.pressure, row.pressure / unit, row.stable ? 1.0 : 0.0, row.limit_point ? 1.0 : 0.0,
               potential_energy(c.parameters, row.stretch, study.pressure)});
  }
  return table;
}

/// The closed approximations against the pressure.
struct Approximations {
  Curve small;
  Curve large;
};

Approximations approximations(const Parameters<double>& p, double to, Table& table) {
  constexpr int points = 300;
  const double unit = mooney_rivlin_unit(p);
  Approximations all;
  for (int k = 1; k <= points; ++k) {
    const double P = to * k / points;
    const double small = where_defined([&] { return small_equilibrium(p, P * unit).stretch.value; });
    const double large = where_defined([&] { return large_equilibrium(p, P * unit).value; });
    const auto exact = equilibria(p, P * unit);
    const double nan = std::nan("");
    table.add({P, P * unit, small, large, exact.empty() ? nan : exact.front().stretch,
               exact.empty() ? nan : exact.back().stretch});
    if (std::isfinite(small)) all.small.push_back({P, small, false});
    if (std::isfinite(large)) all.large.push_back({P, large, false});
  }
  return all;
}

void draw_approximations(Studio& studio, const Case& c, const StaticStudy& study) {
  const double unit = mooney_rivlin_unit(c.parameters);
  constexpr double to = 8;
  Table table("P0/S2 [1],p_gauge [Pa],R by (3.3) [1],R by (3.5) [1],least exact R [1],greatest exact R [1]");
  const Approximations closed = approximations(c.parameters, to, table);
  studio.table("figure-7-approximations", table);

  Curve stable;
  Curve unstable;
  bool was = false;
  for (const StaticRow& row : static_curve(c, study)) {
    if (row.limit_point) {  // belongs to both
      for (Curve* curve : {&stable, &unstable}) curve->push_back({row.pressure / unit, row.stretch, false});
      stable.back().gap = !was;
      unstable.back().gap = was;
    } else {
      (row.stable ? stable : unstable).push_back({row.pressure / unit, row.stretch, false});
      was = row.stable;
    }
  }
  Curve limits;
  for (const LimitPoint& point : study.limit_points) limits.push_back({point.pressure / unit, point.stretch, false});
  Plot plot;
  plot.add("stable", stable, line_style(blue, "stable"));
  plot.add("unstable", unstable, line_style(vermilion, "unstable", unstable_dashes));
  plot.add("small", closed.small, "lines lw 3.5 dt " + fine_dashes + " lc rgb '" + orange + "' title '(3.3)'");
  plot.add("large", closed.large, "lines lw 3.5 dt " + fine_dashes + " lc rgb '" + green + "' title '(3.5)'");
  plot.add("limits", limits, points_style("black", "limit points", 5));
  const std::string commands = "set title " + quoted(c.title) + "\nset xrange [0:" + rounded(to) +
                               "]\nset yrange [0.8:7]\nset xlabel 'static pressure P_0/S_2 [1]'\n" +
                               "set ylabel 'stretch R = r/r_0 [1]' offset 1\nset key top left\n" + plot.command();
  studio.picture("figure-7-approximations", plot.data(), commands, {800, 600});
}

}  // namespace

void make_statics_figure(Studio& studio) {
  const std::string& name = studio.cases().front();
  const double mean = mean_limit_pressure(studio.read(name).parameters);
  const Case c = studio.read(name, {held_at(mean)});
  const StaticStudy study = study_statics(c, {});
  studio.table("figure-7", static_table(c, study));
  studio.picture("figure-7", [&](const auto& folder) { return draw_statics(c, study, folder, "figure-7"); });
  draw_approximations(studio, c, study);
}

void make_bistability_figure(Studio& studio) {
  const std::string& name = studio.cases().front();
  const Case c = studio.read(name);
  const double pressure = mean_limit_pressure(c.parameters);
  const double unit = mooney_rivlin_unit(c.parameters);
  const std::optional<MooneyRivlinMap> map = mooney_rivlin_map(c);
  if (!map) throw InvalidInput("material.s1", "", "the map needs s1 > 0 and s2 > 0");
  Table table("S1/S2 [1],least P0/S2 [1],greatest P0/S2 [1],Maxwell P0/S2 [1]");
  for (const Cusp& cusp : map->map.cusps) table.add({cusp.parameter, cusp.pressure, cusp.pressure, cusp.pressure});
  for (const BistabilityMap::Row& row : map->map.rows) {
    table.add({row.parameter, row.window.least, row.window.greatest, row.window.maxwell.value_or(std::nan(""))});
  }
  studio.table("figure-bistability", table);
  studio.picture("figure-bistability", [&](const auto& folder) {
    return draw_bistability_map(map->map, {"Mooney-Rivlin balloons: two stable states", "S1/S2 [1]", "P0/S2 [1]"},
                                {{map->ratio, pressure / unit}}, folder, "figure-bistability");
  });
}

}  // namespace turgor
