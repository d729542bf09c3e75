#include "curves.hpp"
#include "force_curves.hpp"
#include "gnuplot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/view/verification_picture.hpp"

namespace turgor {

namespace {

/// The simpler equation as its closure's force is drawn elsewhere, (2.22) as a fine line of that colour.
std::string style_of(const ModelResponse& model) {
  return closure_style(model.closure, model.name(), model.run.oscillator->model() == Model::full);
}

Plot radius_plot(const ResponseVerification& v, double time_unit, double length_unit) {
  Plot plot("radius_");
  Curve fem;
  for (const FemRadius& row : v.fem.rows) fem.push_back({row.time / time_unit, row.radius / length_unit, false});
  plot.add("fem", fem, line_style("black", "finite elements"));
  for (std::size_t i = 0; i < v.models.size(); ++i) {
    const RunResult& run = v.models[i].run;
    const Scales<double>& scales = run.oscillator->scales();
    Curve curve = stretch_curve(*run.trajectory, {}, scales.time / time_unit);
    for (CurvePoint& point : curve) point.y *= scales.length / length_unit;
    plot.add(std::to_string(i), curve, style_of(v.models[i]));
  }
  return plot;
}

/// In percent of the stroke; nothing where that is 0.
Plot error_plot(const ResponseVerification& v, double time_unit) {
  Plot plot("error_");
  if (v.stroke == 0) return plot;
  for (std::size_t i = 0; i < v.models.size(); ++i) {
    Curve curve;
    for (std::size_t k = 0; k < v.models[i].radii.size(); ++k) {
      const FemRadius& row = v.fem.rows[k];
      curve.push_back({row.time / time_unit, 100 * (v.models[i].radii[k] - row.radius) / v.stroke, false});
    }
    plot.add(std::to_string(i), curve, style_of(v.models[i]));
  }
  return plot;
}

}  // namespace

std::string draw_verification(const Case& c, const ResponseVerification& v, const std::filesystem::path& folder) {
  const double s = unit_factor(c.output.time_unit, "s");
  const double length = unit_factor(c.output.length_unit, "m");
  const std::string pressure_unit = picture_pressure_unit(c);
  const Curve pressures = pressure_curve(c, s, unit_factor(pressure_unit, "Pa"));
  Plot pressure;
  pressure.add("pressure", pressures, line_style("black", ""));
  const Plot radius = radius_plot(v, s, length);
  const Plot error = error_plot(v, s);

  std::string commands = "set multiplot\nset lmargin at screen 0.125; set rmargin at screen 0.97\n";
  commands += "set xrange [0:" + rounded(c.solve.t_end / s, 10) + "]\nset xzeroaxis lt 1 lc rgb 'grey60'\n";
  commands += panel_between(0.81, 0.94) + "set title " + quoted(c.title) + " offset 0,-0.5\n";
  commands += "set ylabel 'p [" + pressure_unit + "]' offset 1\nset format x ''\nunset key\n";
  commands += "set autoscale noextend\nset offsets 0,0,graph 0.06,graph 0.06\n";
  commands += "set ytics " + rounded(tic_step(pressures), 6) + "\n" + pressure.command();
  commands += panel_between(0.43, 0.79) + "unset title\nset ytics autofreq\n";
  commands += "set key at screen 0.55,0.005 center bottom horizontal maxcols 3 samplen 2.5 font ',13'\n";
  commands += "set ylabel 'r [" + c.output.length_unit + "]' offset 1\n" + radius.command();
  commands += panel_between(0.19, 0.41) + "unset key\nset format x '%g'\n";
  commands += "set xlabel 't [" + c.output.time_unit + "]' offset 0,0.3\nset ylabel 'error [% of stroke]' offset 1\n";
  commands += error.command();
  return gnuplot(folder, "verify", pressure.data() + radius.data() + error.data(), commands + "unset multiplot\n",
                 {800, 760});
}

}  // namespace turgor
