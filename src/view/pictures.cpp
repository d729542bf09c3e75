#include "turgor/view/pictures.hpp"

#include "curves.hpp"
#include "gnuplot.hpp"
#include "plot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

std::string draw_history(const Case& c, const RunResult& result, const std::filesystem::path& folder) {
  const Trajectory<double>& trajectory = *result.trajectory;
  const double s = unit_factor(c.output.time_unit, "s");
  const std::string pressure_unit = picture_pressure_unit(c);
  const double clock = result.oscillator->scales().time / s;

  Plot stretch;
  stretch.add("inflating", stretch_curve(trajectory, Regime::inflating, clock), line_style(blue, "inflating"));
  stretch.add("deflating", stretch_curve(trajectory, Regime::deflating, clock), line_style(vermilion, "deflating"));
  stretch.add("rest", stretch_curve(trajectory, Regime::rest, clock), line_style("black", "at rest"));
  constexpr std::size_t too_many_to_tell_apart = 60;
  if (trajectory.events.size() <= too_many_to_tell_apart) {
    Curve events;
    for (const auto& event : trajectory.events) events.push_back({event.time * clock, event.stretch, false});
    stretch.add("events", events, "points pt 7 ps 0.35 lc rgb 'black' title 'change of regime'");
  }
  const Curve pressures = pressure_curve(c, s, unit_factor(pressure_unit, "Pa"));
  Plot pressure;
  pressure.add("pressure", pressures, line_style("black", ""));

  std::string commands = "set multiplot\nset lmargin at screen 0.115; set rmargin at screen 0.97\n";
  commands += "set xrange [0:" + rounded(c.solve.t_end / s, 10) + "]\n";
  commands += "set tmargin at screen 0.90; set bmargin at screen 0.40\n";
  commands += "set title " + quoted(c.title) + " offset 0,-0.5\n";
  commands +=
      "set ylabel 'stretch R = r/r_0 [1]' offset 1\nset format x ''\nset key top right\nset offsets 0,0,graph "
      "0.06,graph 0.06\n";
  commands += stretch.command();
  commands += "set tmargin at screen 0.37; set bmargin at screen 0.13\nunset title\nset format x '%g'\nunset key\n";
  commands += "set ytics " + rounded(tic_step(pressures), 6) + "\n";
  commands +=
      "set xlabel 't [" + c.output.time_unit + "]'\nset ylabel 'p_{ext} - p_a [" + pressure_unit + "]' offset 1\n";
  commands += pressure.command() + "unset multiplot\n";
  return gnuplot(folder, "history", stretch.data() + pressure.data(), commands);
}

std::string draw_portrait(const Case& c, const RunResult& result, const std::filesystem::path& folder) {
  const Trajectory<double>& trajectory = *result.trajectory;
  const double per_time = unit_factor(c.output.time_unit, "s") / result.oscillator->scales().time;
  const Point<double> first = trajectory.at(0);
  Plot plot;
  plot.add("inflating", portrait_curve(trajectory, Regime::inflating, per_time), line_style(blue, "inflating"));
  plot.add("deflating", portrait_curve(trajectory, Regime::deflating, per_time), line_style(vermilion, "deflating"));
  plot.add("start", {{first.stretch, first.rate * per_time, false}},
           "points pt 6 ps 1.6 lw 1.5 lc rgb 'black' title 'start'");
  plot.add("end", {{trajectory.last.stretch, trajectory.last.rate * per_time, false}},
           "points pt 7 ps 0.8 lc rgb 'black' title 'end'");

  std::string commands = "set title " + quoted(c.title) + "\n";
  commands += "set xlabel 'stretch R = r/r_0 [1]'\nset ylabel 'dR/dt [1/" + c.output.time_unit + "]'\n";
  commands += "set key outside bottom center horizontal\nset xzeroaxis lt 1 lc rgb 'grey60'\n";
  commands += "set offsets graph 0.03,graph 0.03,graph 0.05,graph 0.05\n" + plot.command();
  return gnuplot(folder, "portrait", plot.data(), commands);
}

}  // namespace

std::string draw_pictures(const Case& c, const RunResult& result, const std::filesystem::path& folder) {
  if (result.trajectory->steps.empty()) return "no pictures: the run has no steps";
  const std::string history = draw_history(c, result, folder);
  const std::string portrait = draw_portrait(c, result, folder);
  return history.empty() ? portrait : history;
}

}  // namespace turgor
