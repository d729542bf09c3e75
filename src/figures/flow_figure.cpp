// Figure 2: the flow inside the balloon while it deflates, and the pressure on its wall in both directions.

#include "makers.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/run/flow_report.hpp"
#include "turgor/view/flow_picture.hpp"

namespace turgor {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double kPa = 1000;

/// The instant of a run at time t [s].
FlowInstant instant_of(const Case& c, const RunResult& run, double t) {
  const PhysicalState state = physical_state(*run.oscillator, *run.trajectory, t / run.oscillator->scales().time);
  FlowInstant instant{state.stretch, state.stretch_rate, t, {}, state.gauge_pressure};
  instant.acceleration = acceleration_of(c, run.oscillator->model(), instant, state.gauge_pressure);
  return instant;
}

/// Gauge pressure [Pa] of the whole balloon at an instant of inflation, (2.3).
double jet_pressure(const Parameters<double>& p, const FlowInstant& instant) {
  return orifice_pressure(FlowState<double>{p.radius * instant.stretch, p.radius * instant.rate,
                                            p.radius * instant.acceleration.value(), instant.pressure.value(),
                                            p.orifice_radius, p.channel_length, p.fluid_density});
}

Table streamlines(const FlowSnapshot& snapshot, const MeridionalFlow& field) {
  constexpr int tubes = 16;
  const double r = snapshot.state().radius;
  Table table("share of the outflow [1],r [m],z [m]");
  for (int k = 1; k < tubes; ++k) {
    const double share = static_cast<double>(k) / tubes;
    for (const MeridionalPoint& point : field.stream_line(share)) {
      table.add({share, r * point.distance, r * point.height});
    }
  }
  return table;
}

std::string instant_text(const FlowInstant& instant) {
  return "R = " + rounded(instant.stretch, 4) + ", dR/dt = " + rounded(instant.rate, 3) + " 1/s";
}

/// Pressure on the wall less that of the inlet, both ways.
void draw_wall(Studio& studio, const Case& c, const FlowSnapshot& deflating, const FlowInstant& inflating) {
  const std::vector<WallPoint> points = wall_points(deflating);
  const double inlet = deflating.state().inlet_pressure;
  Table table("regime,theta from the orifice [rad],p_gauge [Pa],p_gauge at the inlet [Pa]");
  Curve wall;
  for (const WallPoint& point : points) {
    const double theta = std::numbers::pi - point.theta;
    table.add({-1.0, theta, point.pressure, inlet});
    wall.push_back({theta * degrees, (point.pressure - inlet) / kPa, false});
  }
  const double jet = jet_pressure(c.parameters, inflating);
  Curve uniform;
  for (const double theta : {std::numbers::pi, std::numbers::pi - points.back().theta}) {
    table.add({1.0, theta, jet, inflating.pressure.value()});
    uniform.push_back({theta * degrees, (jet - inflating.pressure.value()) / kPa, false});
  }
  studio.table("figure-2-wall", table);

  Plot plot;
  plot.add("wall", wall, line_style(vermilion, "deflating, " + instant_text(deflating.instant()) + ": (A1)"));
  plot.add("uniform", uniform, line_style(blue, "inflating, " + instant_text(inflating) + ": (2.3)"));
  const double level = std::max(std::abs(uniform.front().y), std::abs(wall.front().y));
  std::string commands = "set title " + quoted(c.title + ": pressure on the wall") + "\nset xrange [0:180]\n";
  commands += "set xtics 30\nset xlabel 'angle from the orifice [°]'\nset ylabel 'p - p_{ext} [kPa]' offset 1\n";
  commands += "set yrange [" + rounded(-0.8 * level, 4) + ":" + rounded(1.2 * level, 4) + "]\n";
  commands += "set xzeroaxis lt 1 lc rgb 'grey60'\nset key center right\n" + plot.command();
  studio.picture("figure-2-wall", plot.data(), commands, {});
}

}  // namespace

void make_flow_figure(Studio& studio) {
  constexpr double rising = 5;  // in the middle of the two ramps of the pressure [s]
  constexpr double falling = 35;
  const Case c = studio.read(studio.cases().front());
  const RunResult run = run_motion(c);
  const FlowSnapshot snapshot(c, instant_of(c, run, falling));
  constexpr int resolution = 200;
  const MeridionalFlow field(snapshot.flow(), resolution);
  studio.table("figure-2-streamlines", streamlines(snapshot, field));
  studio.picture("figure-2", [&](const auto& folder) { return draw_flow(c, snapshot, field, folder, "figure-2"); });
  draw_wall(studio, c, snapshot, instant_of(c, run, rising));
}

}  // namespace turgor
