// Figures 4 and 6: balloons that are filled and emptied by one pressure program through openings of several sizes.

#include "../view/curves.hpp"
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

Curve curve_of(const Response& response) {
  return stretch_curve(*response.run.trajectory, {}, response.run.oscillator->scales().time);
}

std::string equation_of(Model model) {
  switch (model) {
    case Model::full: return "(2.22)";
    case Model::orifice: return "(2.23)";
    case Model::long_channel: return "(2.25)";
  }
  return "";
}

/// R(t) of all balloons, by their own equation and by the complete one.
Plot stretch_plot(const std::vector<Response>& own, const std::vector<Response>& complete) {
  Plot plot;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::string size = rounded(own[i].of.parameters.orifice_radius * 100, 3) + " cm, ";
    plot.add("own" + std::to_string(i), curve_of(own[i]),
             line_style(tone(i, own.size()), "r_{ch} = " + size + equation_of(own[i].run.oscillator->model())));
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
  studio.table(name, table);

  const Case& c = own.front().of;  // all have one program
  constexpr double kPa = 1000;
  const Curve pressures = pressure_curve(c, 1, kPa);
  Plot pressure;
  pressure.add("pressure", pressures, line_style("black", ""));
  const Plot stretch = stretch_plot(own, complete);
  std::string commands = "set multiplot\nset xrange [0:" + rounded(c.solve.t_end, 10) + "]\n";
  commands += panel(0.1, 0.97, 0.36, 0.97) + "set ylabel 'stretch R = r/r_0 [1]' offset 1\nset format x ''\n";
  commands += "set key top right\nset autoscale noextend\nset offsets 0,0,graph 0.06,graph 0.06\n";
  commands += stretch.command() + panel(0.1, 0.97, 0.12, 0.33) + "set format x '%g'\nunset key\n";
  commands += "set ytics " + rounded(tic_step(pressures), 6) + "\nset xlabel 't [s]'\n";
  commands += "set ylabel 'p_{ext} - p_a [kPa]' offset 1\n" + pressure.command() + "unset multiplot\n";
  studio.picture(name, stretch.data() + pressure.data(), commands, {900, 640});
}

}  // namespace turgor
