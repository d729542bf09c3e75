#include "turgor/view/membrane_picture.hpp"

#include <algorithm>

#include "gnuplot.hpp"
#include "plot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

/// The stable part of the curve, or the unstable one; both include limit points.
template <class Y>
Curve part_of(const MembraneStudy& study, bool stable, const Y& y) {
  Curve part;
  bool gap = false;
  for (const MembraneRow& row : study.curve) {
    if (row.stable() == stable || row.limit_point) {
      part.push_back({row.stretch, y(row), gap && !part.empty()});
      gap = false;
    } else {
      gap = true;
    }
  }
  return part;
}

Plot pressures(const MembraneStudy& study, const std::string& name) {
  const double unit = unit_factor(name, "Pa");
  const auto p = [&](const MembraneRow& row) { return row.state.pressure / unit; };
  Curve sphere;
  for (const MembraneRow& row : study.curve) sphere.push_back({row.stretch, row.sphere_pressure / unit, false});
  Curve limits;
  for (const MembraneLimit& limit : study.limits) limits.push_back({limit.row.stretch, p(limit.row), false});
  Curve rests;
  for (const MembraneRow& row : study.equilibria) rests.push_back({row.stretch, p(row), false});
  Plot plot;
  plot.add("stable", part_of(study, true, p), line_style(blue, "membrane, stable"));
  plot.add("unstable", part_of(study, false, p), line_style(vermilion, "membrane, unstable"));
  plot.add("sphere", sphere, line_style("black", "sphere (3.1)", fine_dashes));
  plot.add("limits", limits, points_style(orange, "limit points", 5));
  plot.add("rests", rests, points_style("black", "at " + rounded(study.pressure / unit, 4) + " " + name));
  return plot;
}

/// In per cent of (3.1); not next to slack, where both are nothing.
Curve differences(const MembraneStudy& study) {
  constexpr double slack = 1.02;
  Curve curve;
  for (const MembraneRow& row : study.curve) {
    if (row.stretch < slack) continue;
    curve.push_back({row.stretch, 100 * (row.state.pressure / row.sphere_pressure - 1), false});
  }
  return curve;
}

/// Both halves of each shape; in the middle of an element the parabola through its nodes passes its middle node, so
/// straight lines between nodes are true to a pixel.
Plot shapes(const MembraneStudy& study, double unit) {
  Plot plot;
  const std::vector<MembraneRow> all = shapes_of(study);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Eigen::VectorXd& places = all[k].state.places;
    Curve right;
    Curve left;
    for (Eigen::Index i = 0; i < places.size(); i += 2) {
      right.push_back({places(i) / unit, places(i + 1) / unit, false});
      left.push_back({-places(i) / unit, places(i + 1) / unit, false});
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    const std::size_t colour = k * (viridis.size() - 2) / std::max<std::size_t>(all.size() - 1, 1);
    plot.add("shape" + std::to_string(k), right,
             line_style(viridis[colour], "R = " + rounded(all[k].stretch, 4) + (all[k].limit_point ? ", limit" : "")));
  }
  return plot;
}

}  // namespace

std::string draw_membrane(const Case& c, const MembraneStudy& study, const std::filesystem::path& folder) {
  const std::string pa = picture_pressure_unit(c);
  const Plot pressure = pressures(study, pa);
  const Curve above = differences(study);
  Plot difference;
  difference.add("above", above, line_style(blue, ""));
  const Plot shape = shapes(study, unit_factor(c.output.length_unit, "m"));
  std::string commands = "set multiplot title " + quoted(c.title) + "\n";
  commands += "set lmargin at screen 0.09; set rmargin at screen 0.55\nset xrange [1:" +
              rounded(study.curve.back().stretch, 8) + "]\n";
  commands += panel_between(0.4, 0.92) + "set format x ''\nset ylabel " + quoted("gauge pressure [" + pa + "]") +
              " offset 1\nset key " + (study.limits.empty() ? "top left" : "bottom right") +
              " font ',12'\nset yrange [*:*]\nset offsets 0,0,graph 0.05,0\n" + pressure.command();
  commands += panel_between(0.12, 0.36) + "set format x '%g'\nset xlabel 'stretch R = r_{eff}/r_0 [1]'\nset ylabel " +
              quoted("above (3.1) [%]") + " offset 1\nunset key\nset offsets 0,0,graph 0.1,graph 0.1\nset ytics " +
              rounded(tic_step(above)) + "\n" + difference.command() + "set ytics auto\n";
  const std::string length = c.output.length_unit;
  commands += "set lmargin at screen 0.62; set rmargin at screen 0.98\n" + panel_between(0.12, 0.92) +
              "set size ratio -1\nset xrange [*:*]\nset offsets graph 0.03,graph 0.03,graph 0.35,0\nset xlabel " +
              quoted("r [" + length + "]") + "\nset ylabel " + quoted("z [" + length + "]") +
              " offset 1\nset key top left font ',11' maxrows 4\n" + shape.command() + "unset multiplot\n";
  constexpr PictureSize size{1200, 640};
  return gnuplot(folder, "statics", pressure.data() + difference.data() + shape.data(), commands, size);
}

}  // namespace turgor
