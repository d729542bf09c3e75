#include "turgor/view/verification_picture.hpp"

#include <algorithm>
#include <cmath>

#include "force_curves.hpp"
#include "gnuplot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

/// The unit of the greatest among some forces of every row.
template <class Forces>
ForceUnit unit_of(const Verification& v, const Forces& forces) {
  double greatest = 0;
  for (const VerifiedRow& row : v.rows) {
    for (const double model : row.models) greatest = std::max(greatest, std::abs(forces(row, model)));
  }
  return unit_for(greatest);
}

double difference(const VerifiedRow& row, double model) { return model - row.fem.force_mode; }

Plot error_plot(const Verification& v, double time_unit, const ForceUnit& unit) {
  Plot plot("error_");
  for (std::size_t i = 0; i < v.closures.size(); ++i) {
    Curve curve;
    for (const VerifiedRow& row : v.rows) {
      curve.push_back({row.fem.time / time_unit, difference(row, row.models[i]) / unit.newtons, false});
    }
    plot.add(std::string(name_of(v.closures[i])), curve, closure_style(v.closures[i]));
  }
  return plot;
}

}  // namespace

std::string draw_verification(const Case& c, const Verification& v, const std::filesystem::path& folder) {
  const double s = unit_factor(c.output.time_unit, "s");
  const ForceUnit unit = unit_of(
      v, [](const VerifiedRow& row, double model) { return std::max(std::abs(model), std::abs(row.fem.force_mode)); });
  const ForceUnit error_unit = unit_of(v, difference);
  const Plot motion = motion_plot(c, s);
  Plot force;
  add_finite_elements(force, v.fem, s, unit);
  add_forces(force, c, v.closures, s, unit);
  const Plot error = error_plot(v, s, error_unit);

  std::string commands = "set multiplot\nset lmargin at screen 0.115; set rmargin at screen 0.97\n";
  commands += "set xrange [0:" + rounded(c.solve.t_end / s, 10) + "]\nset xzeroaxis lt 1 lc rgb 'grey60'\n";
  commands += panel_between(0.72, 0.90) + "set title " + quoted(c.title) + " offset 0,1.2\n";
  commands += "set ylabel 'normalised [1]' offset 1\nset format x ''\nset yrange [-1.1:1.1]\nset ytics 1\n";
  commands += "set key at graph 1, graph 1.03 right bottom horizontal samplen 3\n" + motion.command();
  commands += panel_between(0.39, 0.64) + "unset title\nset autoscale y\nset ytics autofreq\n";
  commands +=
      "set offsets 0,0,graph 0.06,graph 0.06\nset key samplen 2.5 maxrows 1 width -1 font ',13'\nset ylabel 'F [" +
      unit.name + "]' offset 1\n" + force.command();
  commands += panel_between(0.10, 0.35) + "unset key\nset format x '%g'\nset xlabel 't [" + c.output.time_unit + "]'\n";
  commands += "set ylabel 'error [" + error_unit.name + "]' offset 1\n" + error.command();
  return gnuplot(folder, "verify", motion.data() + force.data() + error.data(), commands + "unset multiplot\n",
                 {800, 720});
}

}  // namespace turgor
