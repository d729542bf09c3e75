// Figures 8 and 9: free motion in the phase plane.

#include <algorithm>
#include <cmath>

#include "makers.hpp"
#include "motion.hpp"
#include "turgor/asymptotics/piecewise_solution.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/portrait_report.hpp"
#include "turgor/view/portrait_picture.hpp"

namespace turgor {

namespace {

constexpr int half_cycles = 2;

/// A state in the phase plane, SI units.
struct State {
  double time, stretch, rate;
  Regime regime;
};
using States = std::vector<State>;

/// The exact motion from rest.
States exact_states(const LargeMotion& large, double start) {
  constexpr int points = 12;  // of a step
  const double clock = large.motion.scales().time;
  constexpr double long_enough = 1e9;
  States states;
  for (const auto& step : large.exact(start, long_enough, half_cycles).steps) {
    for (int k = 0; k <= points; ++k) {
      const double theta = static_cast<double>(k) / points;
      const double rate = step.rate_at(theta) / clock;
      const bool inflating = step.regime == Regime::inflating;
      states.push_back({(step.start + theta * step.duration) * clock, step.stretch_at(theta),
                        inflating ? std::max(rate, 0.0) : std::min(rate, 0.0), step.regime});
    }
  }
  return states;
}

/// The paper's piecewise solution, its rate by central differences; dense where a half-cycle begins and ends.
States closed_states(const LargeMotion& large, double start) {
  const PiecewiseSolution solution(large.motion, start, half_cycles, Chain::paper);
  const double clock = large.motion.scales().time;
  constexpr int points = 160;
  constexpr double least = 1e-7;  // of a half-cycle
  States states;
  for (const auto& half : solution.half_cycles()) {
    const double end = half.begin + half.duration.value;
    states.push_back({half.begin * clock, half.from, 0, half.regime});
    for (int k = 1; k < 2 * points; ++k) {
      const double near = 0.5 * std::pow(least, std::abs(k - points) / static_cast<double>(points));
      const double T = half.begin + half.duration.value * (k < points ? near : 1 - near);
      const double h = 1e-3 * std::min(T - half.begin, end - T);
      const double rate = (solution.at(T + h).value - solution.at(T - h).value) / (2 * h);
      states.push_back({T * clock, solution.at(T).value, rate / clock, half.regime});
    }
  }
  return states;
}

/// The parts of a path in one regime.
void append(Curve& curve, const States& states, Regime regime) {
  bool gap = true;
  for (const State& state : states) {
    const bool here = state.regime == regime;
    if (here) curve.push_back({state.stretch, state.rate, gap});
    gap = !here;
  }
}

const std::string exact_line = "lines lw 2.5 lc rgb 'black' title 'exact'";
const std::string closed_line = line_style(orange, "closed approximations", unstable_dashes);
const std::string start_point = points_style("black", "start, at rest", 7, "0.8");
const std::string rest_point = points_style(green, "stable equilibrium", 7, "1.1");

/// One balloon in two panels that join at rest, each on a scale of square roots of its own.
class Approach {
 public:
  Approach(std::string name, const LargeMotion& large) : name_(std::move(name)), large_(large) {}

  void add(double start, Table& table) {
    const auto keep = [&](const States& states, const std::string& solution, Curve& upper, Curve& lower) {
      for (const State& s : states) table.add({name_, start, solution, s.time, s.stretch, s.rate});
      append(upper, states, Regime::inflating);
      append(lower, states, Regime::deflating);
    };
    keep(exact_states(large_, start), "exact", exact_upper_, exact_lower_);
    keep(closed_states(large_, start), "closed", closed_upper_, closed_lower_);
    starts_.push_back({start, 0, false});
  }

  [[nodiscard]] std::string draw(double left, double right, const std::string& title, std::string& data) const {
    const double up = 1.06 * std::max(greatest(exact_upper_), greatest(closed_upper_));
    const double down = 1.06 * greatest(exact_lower_);
    Plot upper(name_ + "_upper_");
    Plot lower(name_ + "_lower_");
    fill(upper, exact_upper_, closed_upper_);
    fill(lower, exact_lower_, closed_lower_);
    data += upper.data() + lower.data();
    std::string out = "set xrange [4.3:5.5]\nset xtics 0.2\nset clip two\nunset key\n";
    out += panel(left, right, 0.545, 0.92) + "set title '" + title + "' offset 0,-0.5\nset format x ''\nunset xlabel\n";
    out += side_labels(left) + "set yrange [0:" + rounded(up, 5) + "]\n";
    out += "set nonlinear y via sqrt(y) inverse y*y\n" + root_tics(up, 1) + upper.command();
    out += panel(left, right, 0.17, 0.545) + "unset title\nset format x '%g'\nset xlabel 'stretch R = r/r_0 [1]'\n";
    out += "unset label\nset yrange [" + rounded(-down, 5) + ":0]\n";
    out += "set nonlinear y via -sqrt(-y) inverse -y*y\n" + root_tics(down, -1);
    return out + lower.command();
  }

 private:
  static double greatest(const Curve& curve) {
    double rate = 0;
    for (const CurvePoint& point : curve) rate = std::max(rate, std::abs(point.y));
    return rate;
  }
  static std::string side_labels(double left) {
    const std::string x = rounded(left - 0.083, 6);
    return "set label 1 'inflating: dR/dt [1/s]' at screen " + x + ",0.73 rotate center\n" +
           "set label 2 'deflating: dR/dt [1/s]' at screen " + x + ",0.36 rotate center\n";
  }
  void fill(Plot& plot, const Curve& exact, const Curve& closed) const {
    plot.add("exact", exact, exact_line);
    plot.add("closed", closed, closed_line);
    plot.add("starts", starts_, start_point);
    plot.add("equilibrium", {{large_.motion.equilibrium(), 0, false}}, rest_point);
  }

  std::string name_;
  const LargeMotion& large_;
  Curve exact_upper_, exact_lower_, closed_upper_, closed_lower_, starts_;
};

}  // namespace

void make_approach_figure(Studio& studio) {
  const LargeMotion orifice = large_motion(studio, studio.cases()[0]);
  const LargeMotion channel = large_motion(studio, studio.cases()[1]);
  Approach left("orifice", orifice);
  Approach right("channel", channel);
  Table table("opening,R_i [1],solution,t [s],R [1],dRdt [1/s]");
  for (const double start : {4.4, 4.5, 4.6, 4.7, 5.2, 5.4}) {
    left.add(start, table);
    right.add(start, table);
  }
  studio.table("figure-8", table);
  std::string data;
  std::string commands = "set multiplot\n" + left.draw(0.095, 0.49, "orifice (2.23): (3.16), (3.18)", data);
  commands += "unset nonlinear y\n" + right.draw(0.595, 0.985, "channel (2.25): (3.16), (3.19)", data);
  commands += "unset nonlinear y\n" + key_row(0.015, {exact_line, closed_line, start_point, rest_point});
  studio.picture("figure-8", data, commands + "unset multiplot\n", {1200, 720});
}

void make_portraits_figure(Studio& studio) {
  for (std::size_t i = 0; i < studio.cases().size(); ++i) {
    const Case c = studio.read(studio.cases()[i]);
    PortraitQuestion question;
    question.pressure = mean_limit_pressure(c.parameters);
    const PortraitStudy study = study_portrait(c, question);
    const std::string name = studio.made().figure->tables.at(i);
    studio.table_text(name, portrait_csv(study));
    studio.picture(name, [&](const auto& folder) { return draw_phase_portrait(c, study, folder, name); });
  }
}

}  // namespace turgor
