// Figures 4 and 6: balloons that are filled and emptied by one pressure program through openings of several sizes.

#include "../view/curves.hpp"
#include "fem_runs.hpp"
#include "makers.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

struct Response {
  Case of;
  RunResult run;
};

Response respond(const Studio& studio, const std::string& name, const std::vector<std::string>& overrides) {
  Case c = studio.read(name, overrides);
  RunResult run = run_motion(c);
  if (!is_complete(run.trajectory->outcome)) throw ComputationFailed(name + ": " + run.trajectory->message);
  return {std::move(c), std::move(run)};
}

void add_rows(Table& table, const Response& response) {
  constexpr int points = 1200;
  const double clock = response.run.oscillator->scales().time;
  for (int k = 0; k <= points; ++k) {
    const double t = response.of.solve.t_end * k / points;
    const PhysicalState state = physical_state(*response.run.oscillator, *response.run.trajectory, t / clock);
    table.add({response.of.parameters.orifice_radius, response.of.parameters.channel_length,
               std::string(name_of(response.run.oscillator->model())), t, state.stretch, state.stretch_rate,
               state.gauge_pressure});
  }
}

/// R as r_eff/r0.
void add_rows(Table& table, const Case& c, const FemResponse& fem) {
  const double r0 = c.parameters.radius;
  for (const FemRadius& row : fem.rows) {
    table.add({c.parameters.orifice_radius, c.parameters.channel_length, std::string("finite elements"), row.time,
               row.radius / r0, row.rate / r0, row.gauge_pressure});
  }
}

Curve curve_of(const Response& response) {
  return stretch_curve(*response.run.trajectory, {}, response.run.oscillator->scales().time);
}

/// r_eff/r0 of every run that there is. Not in black as elsewhere, which the darkest tone comes too close to.
void add_finite_elements(Plot& plot, const std::vector<Case>& cases,
                         const std::vector<std::optional<FemResponse>>& fem) {
  bool first = true;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!fem[i]) continue;
    Curve curve;
    for (const FemRadius& row : fem[i]->rows)
      curve.push_back({row.time, row.radius / cases[i].parameters.radius, false});
    plot.add("fem" + std::to_string(i), curve, line_style(vermilion, first ? "finite elements" : ""));
    first = false;
  }
}

/// R(t) of all balloons, by their own equation and by the complete one.
Plot stretch_plot(const std::vector<Response>& own, const std::vector<Response>& complete) {
  Plot plot;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::string size = rounded(own[i].of.parameters.orifice_radius * 100, 3) + " cm, ";
    plot.add(
        "own" + std::to_string(i), curve_of(own[i]),
        line_style(tone(i, own.size()), "r_{ch} = " + size + std::string(equation_of(own[i].run.oscillator->model()))));
  }
  for (std::size_t i = 0; i < complete.size(); ++i) {
    plot.add(
        "full" + std::to_string(i), curve_of(complete[i]),
        "lines lw 1.2 dt " + fine_dashes + " lc rgb 'black' " + (i == 0 ? "title 'the same by (2.22)'" : "notitle"));
  }
  return plot;
}

}  // namespace

void make_response_figure(Studio& studio) {
  const std::string& name = studio.made().figure->tables.front();
  Table table("r_ch [m],L_ch [m],model,t [s],R [1],dRdt [1/s],p_gauge [Pa]");
  std::vector<Response> own;
  std::vector<Response> complete;
  for (const std::string& file : studio.cases()) {
    own.push_back(respond(studio, file, {}));
    complete.push_back(respond(studio, file, {"model.name=full"}));
    add_rows(table, own.back());
    add_rows(table, complete.back());
  }
  std::vector<Case> cases;
  cases.reserve(own.size());
  for (const Response& response : own) cases.push_back(response.of);
  const std::vector<std::optional<FemResponse>> fem = fem_runs(studio, cases, &read_fem_response, "Vermilion");
  for (std::size_t i = 0; i < fem.size(); ++i) {
    if (fem[i]) add_rows(table, cases[i], *fem[i]);
  }
  studio.table(name, table);

  const Case& c = own.front().of;  // all have one program
  constexpr double kPa = 1000;
  const Curve pressures = pressure_curve(c, 1, kPa);
  Plot pressure;
  pressure.add("pressure", pressures, line_style("black", ""));
  Plot stretch = stretch_plot(own, complete);
  add_finite_elements(stretch, cases, fem);
  std::string commands = "set multiplot\nset xrange [0:" + rounded(c.solve.t_end, 10) + "]\n";
  commands += panel(0.1, 0.97, 0.36, 0.97) + "set ylabel 'stretch R = r/r_0 [1]' offset 1\nset format x ''\n";
  commands += "set key top right\nset autoscale noextend\nset offsets 0,0,graph 0.06,graph 0.06\n";
  commands += stretch.command() + panel(0.1, 0.97, 0.12, 0.33) + "set format x '%g'\nunset key\n";
  commands += "set ytics " + rounded(tic_step(pressures), 6) + "\nset xlabel 't [s]'\n";
  commands += "set ylabel 'p_{ext} - p_a [kPa]' offset 1\n" + pressure.command() + "unset multiplot\n";
  studio.picture(name, stretch.data() + pressure.data(), commands, {900, 640});
}

}  // namespace turgor
