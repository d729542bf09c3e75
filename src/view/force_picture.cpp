#include <algorithm>
#include <cmath>

#include "force_curves.hpp"
#include "gnuplot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/view/pictures.hpp"

namespace turgor {

namespace {

/// The radii of a motion [m] with some room, so that no curve lies on the frame.
std::string radius_range(const RadiusRange<double>& radius, double m) {
  const double way = radius.greatest - radius.least;
  const double room = way > 1e-7 * radius.greatest ? 0.06 * way : 1e-3 * radius.greatest;
  return "[" + rounded((radius.least - room) / m, 10) + ":" + rounded((radius.greatest + room) / m, 10) + "]";
}

}  // namespace

std::string draw_force(const Case& c, const ForceHistory& history, const std::filesystem::path& folder) {
  const double s = unit_factor(c.output.time_unit, "s");
  const double m = unit_factor(c.output.length_unit, "m");
  double greatest = 0;
  for (const ForceSummary& of : history.closures) greatest = std::max(greatest, std::abs(of.peak.force));
  const ForceUnit unit = unit_for(greatest);
  const Plot motion = motion_plot(c, s);
  Plot force;
  add_radius(force, c, s, m);
  add_forces(force, c, compared_closures(c), s, unit);

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
