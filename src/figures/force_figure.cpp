// Figure 3: the force of the liquid on balloons whose radius is dictated.

#include <algorithm>
#include <cmath>
#include <optional>

#include "../view/force_curves.hpp"
#include "fem_runs.hpp"
#include "makers.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/force_history.hpp"

namespace turgor {

namespace {

const std::vector<Closure> shown{Closure::theoretical, Closure::corrected};

Table histories(const std::vector<Case>& cases) {
  constexpr int points = 500;
  Table table("r_ch [m],L_ch [m],t [s],r [m],drdt [m/s],d2rdt2 [m/s^2],force by (2.12) [N],force by (2.15) [N]");
  for (const Case& c : cases) {
    for (int k = 0; k <= points; ++k) {
      const double t = c.solve.t_end * k / points;
      const auto state = dictated_motion(c).at(t);
      const ClosureForces forces = forces_at(c, shown, t, state);
      table.add({c.parameters.orifice_radius, c.parameters.channel_length, t, state.radius, state.rate,
                 state.acceleration, forces.all[0], forces.all[1]});
    }
  }
  return table;
}

/// Peaks of the shown closures, from the motion itself.
Table peaks(const std::vector<Case>& cases) {
  Table table("r_ch [m],L_ch [m],closure,inflating peak [N],at [s],deflating peak [N],at [s]");
  for (const Case& c : cases) {
    for (const ForceSummary& of : force_history(c).closures) {
      if (std::ranges::find(shown, of.closure) == shown.end()) continue;
      const ForcePeak none{std::nan(""), std::nan("")};
      const ForcePeak up = of.inflating.value_or(none);
      const ForcePeak down = of.deflating.value_or(none);
      table.add({c.parameters.orifice_radius, c.parameters.channel_length, std::string(name_of(of.closure)), up.force,
                 up.time, down.force, down.time});
    }
  }
  return table;
}

double greatest_force(const Case& c) {
  double greatest = 0;
  for (const ForceSummary& of : force_history(c).closures) {
    if (of.closure == Closure::theoretical) greatest = std::abs(of.peak.force);
  }
  return greatest;
}

using FemHistories = std::vector<std::optional<FemHistory>>;

/// A column of the picture: one size of the orifice.
class Column {
 public:
  Column(std::size_t index, const std::vector<Case>& cases, const FemHistories& fem)
      : index_(index),
        count_(cases.size() / 2),  // orifices first, then channels in the same order
        orifice_(cases[index]),
        channel_(cases[count_ + index]),
        fem_orifice_(fem[index]),
        fem_channel_(fem[count_ + index]) {}

  /// Appends data blocks and returns the commands of its three panels.
  [[nodiscard]] std::string draw(std::string& data) const {
    const double s = unit_factor(orifice_.output.time_unit, "s");
    const bool first = index_ == 0;
    const Plot motion = motion_plot(orifice_, s, "motion" + std::to_string(index_));
    data += motion.data();
    std::string commands = "set xrange [0:" + rounded(orifice_.solve.t_end / s, 10) + "]\n";
    commands += "set xtics " + rounded(round_step(orifice_.solve.t_end / s / 3), 6) + "\n";
    commands += place(0.74, 0.93) + "set format x ''\nunset xlabel\nset yrange [-1.15:1.15]\nset ytics 1\n";
    commands += "set title 'r_{ch} = " + rounded(orifice_.parameters.orifice_radius * 100, 3) + " cm' offset 0,-0.5\n";
    commands += first ? "set ylabel 'normalised [1]' offset 0.8\n" : "unset ylabel\n";
    commands += motion.command() + "unset title\nset autoscale y\nset ytics autofreq\n";
    commands += forces(orifice_, fem_orifice_, "no channel", 0.445, 0.70, data);
    commands += "set format x '%g'\nset xlabel 't [" + orifice_.output.time_unit + "]' offset 0,0.4\n";
    return commands + forces(channel_, fem_channel_, "channel", 0.15, 0.405, data);
  }

 private:
  [[nodiscard]] std::string place(double bottom, double top) const {
    const double width = 0.97 / static_cast<double>(count_);
    const double left = 0.07 + width * static_cast<double>(index_);
    return panel(left, left + width - 0.06, bottom, top);
  }
  [[nodiscard]] std::string forces(const Case& c, const std::optional<FemHistory>& fem, const std::string& name,
                                   double bottom, double top, std::string& data) const {
    const ForceUnit unit = unit_for(greatest_force(c));
    Plot plot((c.parameters.channel_length > 0 ? "channel" : "orifice") + std::to_string(index_));
    const double s = unit_factor(c.output.time_unit, "s");
    if (fem) add_finite_elements(plot, *fem, s, unit);
    add_forces(plot, c, shown, s, unit);
    data += plot.data();
    return place(bottom, top) + "set ylabel '" + (index_ == 0 ? name + ": " : "") + "F [" + unit.name + "]' offset " +
           (index_ == 0 ? "0.8" : "2") + "\nset offsets 0,0,graph 0.08,graph 0.08\n" + plot.command();
  }

  std::size_t index_;
  std::size_t count_;
  const Case& orifice_;
  const Case& channel_;
  const std::optional<FemHistory>& fem_orifice_;
  const std::optional<FemHistory>& fem_channel_;
};

}  // namespace

void make_force_figure(Studio& studio) {
  std::vector<Case> cases;
  cases.reserve(studio.cases().size());
  for (const std::string& name : studio.cases()) cases.push_back(studio.read(name));
  studio.table("figure-3", histories(cases));
  studio.table("figure-3-peaks", peaks(cases));
  const FemHistories fem = fem_runs(studio, cases, &read_fem_history, "Solid black");
  std::string data;
  std::string commands =
      "set multiplot\nset xzeroaxis lt 1 lc rgb 'grey60'\nset tics font ',12'\nunset key\nset autoscale noextend\n";
  for (std::size_t i = 0; i < cases.size() / 2; ++i) commands += Column(i, cases, fem).draw(data);
  std::vector<std::string> key{line_style(blue, "r - r(0)", {}), line_style(vermilion, "dr/dt", "'-'"),
                               line_style("black", "-d^2r/dt^2", "'_. '"), line_style(green, "F by (2.12)", "'_. '"),
                               line_style(orange, "F by (2.15)", "'-'")};
  if (!studio.fem().empty()) key.push_back(line_style("black", "F by finite elements"));
  commands += key_row(0.005, key);
  studio.picture("figure-3", data, commands + "unset multiplot\n", {1300, 760});
}

}  // namespace turgor
