// A gentle push on a balloon of viscous liquid: orders of the coupled solver in time and space, balances, restart.

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "fem/coupled_balloon.hpp"
#include "studies.hpp"

namespace turgor {

namespace {

constexpr double end = 0.2;  // [s], half of the push: all is smooth up to there

/// Held at R = 1.1, then pushed by 300 Pa within 0.4 s; liquid of 1 Pa s, whose layers of 1 cm are resolved.
/// @param step  [ms]
Case pushed_slowly(FemScheme scheme, double fineness, double step) {
  Case c = stretched("1.1", "tolerance = 1e-7\n");
  for (double* size : {&c.fem.h_rim, &c.fem.h_orifice, &c.fem.h_wall}) *size /= fineness;
  const double held = HeldBalloon(c).state().pressure;
  std::ostringstream segments;
  segments << std::setprecision(17) << R"([{ step = ")" << held << R"( Pa" }, { to = ")" << held + 300
           << R"( Pa", over = "0.4 s", shape = "smooth" }])";
  c.pressure = case_of(balloon(segments.str())).pressure;
  c.parameters.fluid_viscosity = 1;
  c.fem.scheme = scheme;
  c.fem.time_step = step / 1000;
  return c;
}

/// At `end`.
struct Outcome {
  std::array<double, 3> values;  ///< radius, height of the pole, volume, less those at the start
  double energy;                 ///< what is missing from it, over the inlet's work
  double volume;                 ///< what is missing from it, over what has entered
};
constexpr std::array<const char*, 3> names{"radius", "height of the pole", "volume"};

std::array<double, 3> values_of(const FlowRow& row) { return {row.radius, row.top, row.volume}; }

Outcome outcome(const Case& c) {
  const auto flow = make_coupled_flow(c);
  const FlowRow before = flow->row();
  SolverRow last{};
  while (flow->time() < end) last = flow->step(end);
  const FlowRow row = flow->row();
  Outcome found{};
  for (std::size_t i = 0; i < 3; ++i) found.values[i] = values_of(row)[i] - values_of(before)[i];
  const double gained = row.kinetic + row.wall_kinetic + row.elastic - before.elastic;
  found.energy = std::abs(gained + row.viscous_work + row.stabilisation_work - row.inlet_work) / row.inlet_work;
  found.volume = std::abs(last.volume_error) * before.volume / found.values[2];
  return found;
}

/// Of each value but the finest, the change to the next one, over the finest; sizes fall by halves.
void print_changes(const std::string& panel, const std::string& what, const std::vector<double>& sizes,
                   const std::vector<Outcome>& found) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double finest = found.back().values[i];
    for (std::size_t k = 0; k + 1 < found.size(); ++k) {
      print(panel, what + names[i], sizes[k], std::abs((found[k].values[i] - found[k + 1].values[i]) / finest));
    }
  }
}

void print_time_orders(FemScheme scheme) {
  const std::vector<double> steps{20, 10, 5, 2.5, 1.25};  // [ms]
  std::vector<Outcome> found;
  const std::string name(name_of(scheme));
  for (const double step : steps) {
    found.push_back(outcome(pushed_slowly(scheme, 1, step)));
    print("balances", "energy by " + name, step, found.back().energy);
    print("balances", "volume by " + name, step, found.back().volume);
  }
  print_changes("time", name + " ", steps, found);
}

void print_space_orders() {
  std::vector<double> sizes;
  std::vector<Outcome> found;
  for (const double fineness : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    sizes.push_back(2 / fineness);  // [mm] at the rim
    found.push_back(outcome(pushed_slowly(FemScheme::bdf2, fineness, 20)));
  }
  print_changes("space", "", sizes, found);
}

/// Numbers of a row that are not the same after going on from a checkpoint.
void print_restart() {
  const Case c = pushed_slowly(FemScheme::bdf2, 1, 10);
  const auto through = make_coupled_flow(c);
  while (through->time() < end / 2) (void)through->step(end / 2);
  Checkpoint checkpoint;
  through->save(checkpoint);
  const auto resumed = make_coupled_flow(c);
  resumed->load(checkpoint);
  for (const auto& flow : {through.get(), resumed.get()}) {
    while (flow->time() < end) (void)flow->step(end);
  }
  const auto numbers = [](const FlowRow& row) {
    return std::array{row.time,    row.radius,       row.top,        row.volume,    row.flow_rate,
                      row.kinetic, row.wall_kinetic, row.elastic,    row.force,     row.viscous_work,
                      row.rate,    row.area,         row.inlet_work, row.wall_work, row.stabilisation_work};
  };
  const auto a = numbers(through->row());
  const auto b = numbers(resumed->row());
  int differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing += a[i] == b[i] ? 0 : 1;
  print("restart", "numbers that differ", end, differing);
}

}  // namespace

void coupled_orders() {
  print_time_orders(FemScheme::bdf1);
  print_time_orders(FemScheme::bdf2);
  print_restart();
  print_space_orders();
}

}  // namespace turgor
