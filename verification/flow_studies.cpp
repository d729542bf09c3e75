// Errors of the flow solver on series of meshes and steps, as a table of comma-separated values: flow-studies NAME

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <numbers>
#include <string>

#include "fem/known_flows.hpp"
#include "rest_flow.hpp"
#include "studies.hpp"
#include "turgor/fem/session.hpp"

namespace turgor {
namespace {

double size_of(std::size_t n) { return 1 / static_cast<double>(n); }

constexpr std::array schemes{FemScheme::bdf1, FemScheme::bdf2};

/// At the axis, which the mesh only touches: radial velocity, and slope of the axial one by the parabola through the
/// first three nodes beside it, greatest along the axis.
void print_axis(const FlowSolver& solver, double h) {
  const FlowSpace& space = solver.space();
  const auto u = [&](int node, int c) { return solver.solution()[static_cast<std::size_t>(space.velocity(node, c))]; };
  double radial = 0;
  double slope = 0;
  for (const auto& cell : space.cells()) {
    const auto at = [&](std::size_t i) { return static_cast<std::size_t>(cell.nodes[i]); };
    // deal.II's numbers: corners 0 and 2 are on the axis, edge 2 is between corners 0 and 1
    if (space.nodes()[at(0)][0] != 0) continue;
    radial = std::max({radial, std::abs(u(cell.nodes[0], 0)), std::abs(u(cell.nodes[2], 0))});
    const double width = solver.positions()[2 * at(1)];
    slope = std::max(slope, std::abs(-3 * u(cell.nodes[0], 1) + 4 * u(cell.nodes[6], 1) - u(cell.nodes[1], 1)) / width);
  }
  print("axis", "radial velocity", h, radial);
  print("axis", "slope of axial velocity", h, slope);
}

void manufactured() {
  for (const std::size_t n : {4U, 8U, 16U, 32U, 64U}) {
    for (const double viscosity : {0.1, 1e-4}) {
      const FlowErrors off = made_up_errors({.density = 1.3, .viscosity = viscosity}, n, FemScheme::bdf2, 1e-3, 3e-3,
                                            [&](const FlowSolver& solver) {
                                              if (viscosity == 0.1) print_axis(solver, size_of(n));
                                            });
      const std::string liquid = viscosity == 0.1 ? "" : " at little viscosity";
      print("space", "velocity" + liquid, size_of(n), off.velocity);
      print("space", "pressure" + liquid, size_of(n), off.pressure);
    }
  }
  for (const FemScheme scheme : schemes) {
    for (const int steps : {5, 10, 20, 40, 80}) {
      const double dt = 0.5 / steps;
      const FlowErrors off = made_up_errors({.density = 1.3, .viscosity = 0.1}, 32, scheme, dt, 0.5);
      print("time", std::string(name_of(scheme)), dt, off.velocity);
    }
  }
}

void channel() {
  for (const std::size_t n : {2U, 4U, 8U, 16U, 32U}) {
    const FlowErrors straight = poiseuille_errors(n, false);
    print("Poiseuille", "velocity", size_of(n), straight.velocity);
    print("Poiseuille", "pressure", size_of(n), straight.pressure);
    const FlowErrors bent = poiseuille_errors(n, true);
    print("Poiseuille", "velocity on a bent mesh", size_of(n), bent.velocity);
    print("Poiseuille", "pressure on a bent mesh", size_of(n), bent.pressure);
    const FlowErrors wave = womersley_errors({.number = 15}, n, FemScheme::bdf2, 1e-3, 0.02);
    print("Womersley in space", "velocity at number 15", size_of(n), wave.velocity);
  }
  for (const FemScheme scheme : schemes) {
    for (const int steps : {20, 40, 80, 160}) {
      const double dt = 2.0 / steps;
      print("Womersley in time", std::string(name_of(scheme)) + " at number 5", dt,
            womersley_errors({.number = 5}, 24, scheme, dt, 2).velocity);
    }
  }
}

void potential_limit() {
  for (const double fineness : {0.25, 0.5, 1.0, 2.0}) {
    const RestFlowErrors off = rest_flow_errors(0.1, fineness);
    print("field", "velocity", off.cell, off.velocity);
    print("field", "pressure", off.cell, off.pressure);
    print("field", "force", off.cell, off.force);
    print("field", "outflow", off.cell, off.outflow);
  }
}

void moving_mesh() {
  for (const std::size_t n : {4U, 8U, 16U}) {
    const FlowErrors uniform = uniform_flow_errors(n, 0.1);
    print("uniform flow", "velocity", size_of(n), uniform.velocity);
    print("uniform flow", "pressure", size_of(n), uniform.pressure);
    print("volume", "flux less rate of volume", size_of(n), volume_law_error(n));
  }
  for (const FemScheme scheme : schemes) {
    for (const int steps : {20, 40, 80, 160, 320}) {
      print("force", std::string(name_of(scheme)), 1.0 / steps, oscillating_mesh_force_error(scheme, 1.0 / steps));
    }
  }
  for (std::uint32_t seed = 1; seed <= 20; ++seed) print("tangent", "tangent", seed, tangent_error(seed));
}

/// Kinetic energy at t = 1 less the works at relative to the energy, of liquid that a cylinder's moving walls and a
/// pressure drive from rest, as history.csv adds them up.
void print_energy(std::size_t n, double dt) {
  const BalloonMesh mesh = cylinder(n);
  const FlowSpace space(mesh);
  FlowDefinition flow;
  flow.density = 1;
  flow.viscosity = 0.01;
  flow.position = [](const Point2& X, double t) { return MadeUpFlow::position(X, t * t * t); };
  flow.mesh_velocity = [](const Point2& X, double t) {
    const Point2 w = MadeUpFlow::mesh_velocity(X, t * t * t);
    return Point2{3 * t * t * w[0], 3 * t * t * w[1]};
  };
  flow.inlet_pressure = [](double t) { return std::pow(std::sin(5 * t), 3); };
  FlowSolver solver(space, flow, tight());
  double last = 0;
  double work = 0;
  double kinetic = 0;
  take_steps(solver, dt, 1, [&](const FlowSolver& now) {
    const FlowBalance b = flow_balance(now, [](const Point2&) { return Point2{}; });
    const double power = b.wall_power + b.inlet_power + b.inlet_kinetic - b.viscous_loss - b.upwind_loss -
                         b.grad_div_loss - b.penalty_loss;
    work += dt / 2 * (last + power);
    last = power;
    kinetic = b.kinetic_energy;
  });
  print("energy in a cylinder", "works at " + std::to_string(n) + " cells across", dt,
        std::abs(kinetic - work) / kinetic);
}

void balances() {
  for (const std::size_t n : {8U, 16U}) {
    for (const int steps : {50, 100, 200, 400}) print_energy(n, 1.0 / steps);
  }
}

struct Study {
  const char* name;
  void (*run)();
};
constexpr std::array studies{Study{"manufactured", manufactured},
                             Study{"channel", channel},
                             Study{"potential-limit", potential_limit},
                             Study{"moving-mesh", moving_mesh},
                             Study{"balances", balances},
                             Study{"orifice-inertance", orifice_inertance},
                             Study{"coupled-modes", coupled_modes},
                             Study{"coupled-orders", coupled_orders},
                             Study{"elastic-tube", elastic_tube}};

int main_of(const std::string& name) {
  const auto* const study = std::ranges::find_if(studies, [&](const Study& s) { return name == s.name; });
  if (study == studies.end()) {
    std::cerr << "flow-studies: no study \"" << name << "\"; there are\n";
    for (const Study& other : studies) std::cerr << "  " << other.name << '\n';
    return 2;
  }
  const FemSession session;
  std::puts("panel,quantity,x,value");
  study->run();
  return 0;
}

}  // namespace
}  // namespace turgor

int main(int count, char** arguments) {
  try {
    return turgor::main_of(count == 2 ? arguments[1] : "");
  } catch (const std::exception& error) {
    std::cerr << "flow-studies: " << error.what() << '\n';
    return 1;
  }
}
