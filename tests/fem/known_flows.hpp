#pragma once
// Errors of the flow solver for flows that are known, in a cylinder; for tests and for verification/flow_studies.cpp.

#include <algorithm>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>

#include "cylinder.hpp"

namespace turgor {

constexpr FlowControls tight(FemScheme scheme = FemScheme::bdf2) {
  return {.scheme = scheme, .update_tolerance = 1e-9, .linear_tolerance = 1e-8, .max_newton = 20};
}

/// A level with the velocity u(X) at every node.
template <class Velocity>
FlowLevel level_of(const FlowSpace& space, double t, const Velocity& u) {
  FlowLevel level{t, std::vector<double>(static_cast<std::size_t>(space.size()), 0.0)};
  for (std::size_t i = 0; i < space.nodes().size(); ++i) {
    const Point2 at = u(space.nodes()[i]);
    level.unknowns[2 * i] = at[0];
    level.unknowns[2 * i + 1] = at[1];
  }
  return level;
}

/// Calls after_step(solver) after each of equal steps to `end`.
template <class AfterStep>
void take_steps(FlowSolver& solver, double dt, double end, const AfterStep& after_step) {
  const auto steps = std::lround(end / dt);
  for (long k = 1; k <= steps; ++k) {
    solver.step_to(static_cast<double>(k) * dt);
    after_step(solver);
  }
}
inline void take_steps(FlowSolver& solver, double dt, double end) {
  take_steps(solver, dt, end, [](const FlowSolver&) {});
}

/// @param at_end  called with the solver in the end
template <class AtEnd>
FlowErrors made_up_errors(const MadeUpFlow& flow, std::size_t n, FemScheme scheme, double dt, double end,
                          const AtEnd& at_end) {
  const BalloonMesh mesh = cylinder(n);
  const FlowSpace space(mesh);
  FlowSolver solver(space, flow.definition(), tight(scheme));
  solver.start({MadeUpFlow::level(space, -dt), MadeUpFlow::level(space, 0)});
  take_steps(solver, dt, end);
  at_end(solver);
  return errors_of(solver, MadeUpFlow::velocity, MadeUpFlow::pressure);
}
inline FlowErrors made_up_errors(const MadeUpFlow& flow, std::size_t n, FemScheme scheme, double dt, double end) {
  return made_up_errors(flow, n, scheme, dt, end, [](const FlowSolver&) {});
}

/// A uniform flow of water of 0.7 m/s on the mesh of MadeUpFlow, which moves through it.
inline FlowErrors uniform_flow_errors(std::size_t n, double dt) {
  const BalloonMesh mesh = cylinder(n, Side::channel);
  const FlowSpace space(mesh);
  const auto uniform = [](const Point2&, double = 0) { return Point2{0, 0.7}; };
  FlowDefinition flow;
  flow.viscosity = 0.1;
  flow.slip = true;
  flow.position = MadeUpFlow::position;
  flow.mesh_velocity = MadeUpFlow::mesh_velocity;
  flow.wall_velocity = uniform;
  FlowSolver solver(space, flow, tight());
  solver.start({level_of(space, -dt, uniform), level_of(space, 0, uniform)});
  take_steps(solver, dt, 0.5);
  return errors_of(solver, uniform, [](const Point2&, double) { return 0.0; });
}

/// Volume per radian of the mesh of a space when its nodes are where position(X, t) puts them.
template <class Position>
double mesh_volume(const FlowSpace& space, double t, const Position& position) {
  double volume = 0;
  for (const auto& cell : space.cells()) {
    NodalVector<double> nodes{};
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      const Point2 x = position(space.nodes()[static_cast<std::size_t>(cell.nodes[i])], t);
      for (std::size_t c = 0; c < 2; ++c) nodes[c][i] = x[c];
    }
    for (const ShapeValues& shape : space.element().points()) volume += cell_point(shape, nodes).volume;
  }
  return volume;
}

/// What enters a cylinder whose walls move as MadeUpFlow's mesh, less the rate of the mesh's volume by differences of
/// sixth order, good for 1e-12; greatest over ten steps, relative to the greatest rate.
inline double volume_law_error(std::size_t n) {
  const BalloonMesh mesh = cylinder(n);
  const FlowSpace space(mesh);
  FlowDefinition flow;
  flow.density = 1;
  flow.viscosity = 0.01;
  flow.position = MadeUpFlow::position;
  flow.mesh_velocity = MadeUpFlow::mesh_velocity;
  FlowSolver solver(space, flow, tight());
  double greatest = 0;
  double error = 0;
  take_steps(solver, 0.1, 1, [&](const FlowSolver& now) {
    constexpr double h = 0.005;
    const auto change = [&](int k) {
      return mesh_volume(space, now.time() + k * h, flow.position) -
             mesh_volume(space, now.time() - k * h, flow.position);
    };
    const double rate = (45 * change(1) - 9 * change(2) + change(3)) / (60 * h);
    greatest = std::max(greatest, std::abs(rate));
    error = std::max(error, std::abs(now.inlet().inflow(now.solution()) - rate));
  });
  return error / greatest;
}

/// A tube of radius 1 on a mesh at rest, which profiles enter as they are.
inline FlowDefinition still(double viscosity) {
  FlowDefinition flow;
  flow.viscosity = viscosity;
  flow.density = 1;
  flow.position = [](const Point2& X, double) { return X; };
  flow.mesh_velocity = [](const Point2&, double) { return Point2{}; };
  flow.tangential_zero = true;
  flow.inflow_penalty = 0;  // these profiles come in uneven
  return flow;
}

/// A displacement that bends the inside of the cylinder and leaves its boundary where it is.
inline Point2 bend(const Point2& X) {
  const double inside = 1.6 * X[0] * (1 - X[0]) * X[1] * (1 - X[1]);
  return {inside, inside};
}

/// Poiseuille's flow u_z = 2 (1 - r^2), p = 8 mu (1 - z), mu = 0.3, from rest.
/// @param bent  the mesh inside
inline FlowErrors poiseuille_errors(std::size_t n, bool bent) {
  constexpr double viscosity = 0.3;
  const BalloonMesh mesh = cylinder(n, Side::channel);
  const FlowSpace space(mesh);
  FlowDefinition flow = still(viscosity);
  const auto profile = [](const Point2& x, double) { return Point2{0, 2 * (1 - x[0] * x[0])}; };
  flow.wall_velocity = profile;
  flow.inlet_pressure = [](double) { return 8 * viscosity; };
  if (bent) {
    flow.position = [](const Point2& X, double) {
      const Point2 d = bend(X);
      return Point2{X[0] + d[0], X[1] + d[1]};
    };
  }
  FlowSolver solver(space, flow, tight());
  take_steps(solver, 1e3, 4e3);
  return errors_of(solver, profile, [](const Point2& x, double) { return 8 * viscosity * (1 - x[1]); });
}

/// J0 by its series, which for |x| < 20, halfway between the axes, loses at most six digits.
inline std::complex<double> bessel_j0(std::complex<double> x) {
  std::complex<double> term = 1;
  std::complex<double> sum = 1;
  for (int k = 1; k < 60; ++k) {
    term *= -x * x / (4.0 * k * k);
    sum += term;
  }
  return sum;
}

/// Oscillating flow in a tube of radius 1 under a pressure gradient cos(omega t), density 1: Womersley, J. Physiol. 127
/// (1955) 553.
struct WomersleyFlow {
  double number = 5;  ///< (omega/nu)^{1/2}
  double omega = 2;

  [[nodiscard]] Point2 velocity(const Point2& x, double t) const {
    using namespace std::complex_literals;
    const std::complex<double> wave = std::pow(1i, 1.5) * number;
    const std::complex<double> shape = 1.0 - bessel_j0(wave * x[0]) / bessel_j0(wave);
    return {0, (1.0 / (1i * omega) * shape * std::exp(1i * omega * t)).real()};
  }
};

inline FlowErrors womersley_errors(const WomersleyFlow& exact, std::size_t n, FemScheme scheme, double dt, double end) {
  const double omega = exact.omega;
  const BalloonMesh mesh = cylinder(n, Side::channel);
  const FlowSpace space(mesh);
  FlowDefinition flow = still(omega / (exact.number * exact.number));
  const auto profile = [&](const Point2& x, double t) { return exact.velocity(x, t); };
  flow.wall_velocity = [&](const Point2& x, double t) { return x[0] < 1 ? profile(x, t) : Point2{}; };
  flow.inlet_pressure = [omega](double t) { return std::cos(omega * t); };
  FlowSolver solver(space, flow, tight(scheme));
  const auto level = [&](double t) { return level_of(space, t, [&](const Point2& x) { return profile(x, t); }); };
  solver.start({level(-dt), level(0)});
  take_steps(solver, dt, end);
  return errors_of(solver, profile, [&](const Point2& x, double t) { return std::cos(omega * t) * (1 - x[1]); });
}

/// What the force on the wall is off, root mean square over the steps to t = 1, when only the mesh oscillates: the flow
/// u = (-r, 2 z), p = 1 is steady and in the spaces, so that nothing but the time scheme is seen.
inline double oscillating_mesh_force_error(FemScheme scheme, double dt) {
  constexpr double viscosity = 0.1;
  constexpr double omega = 2 * std::numbers::pi;
  const BalloonMesh mesh = cylinder(4);
  const FlowSpace space(mesh);
  const auto velocity = [](const Point2& x, double) { return Point2{-x[0], 2 * x[1]}; };
  const auto position = [](const Point2& X, double t) {
    const Point2 d = bend(X);
    return Point2{X[0] + d[0] * std::sin(omega * t), X[1] + d[1] * std::cos(omega * t)};
  };
  FlowDefinition flow = still(viscosity);
  flow.tangential_zero = false;
  flow.position = position;
  flow.mesh_velocity = [](const Point2& X, double t) {
    const Point2 d = bend(X);
    return Point2{d[0] * omega * std::cos(omega * t), -d[1] * omega * std::sin(omega * t)};
  };
  flow.wall_velocity = velocity;
  flow.body_force = [](const Point2& x, double) { return Point2{x[0], 4 * x[1]}; };
  flow.inlet_traction = [](const Point2&, double) { return Point2{0, 1 - 4 * viscosity}; };
  FlowSolver solver(space, flow, tight(scheme));
  const auto level = [&](double t) {
    return level_of(space, t, [&](const Point2& X) { return velocity(position(X, t), t); });
  };
  solver.start({level(-dt), level(0)});
  double sum = 0;
  take_steps(solver, dt, 1, [&](const FlowSolver& now) {
    const double force = flow_balance(now, [](const Point2&) { return Point2{0, 1}; }).force_mode;
    sum += dt * std::pow(force - std::numbers::pi * (1 - 4 * viscosity), 2);
  });
  return std::sqrt(sum);
}

/// Greatest difference between the tangent of a random cell and complex steps of its residual. The step of 1e-30 has no
/// difference to lose digits in, so that only rounding is left.
inline double tangent_error(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  const TaylorHood element;
  CellState cell{};
  NodalVector<std::complex<double>> u{};
  NodalVector<double> real_u{};
  std::array<std::complex<double>, pressure_nodes> p{};
  std::array<double, pressure_nodes> real_p{};
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      cell.position[c][i] = (c == 0 ? 0.3 : 0.0) + element.node(i)[c] + 0.05 * any(random);
      cell.mesh_velocity[c][i] = any(random);
      cell.history[c][i] = any(random);
      cell.frozen[c][i] = any(random);
      cell.body_force[c][i] = any(random);
      u[c][i] = real_u[c][i] = any(random);
    }
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) p[i] = real_p[i] = any(random);
  const CellSettings settings{
      .density = 1.3, .viscosity = 0.2, .rate_factor = 3, .time_step = 0.5, .supg = 1, .grad_div = 0.5};
  CellResidual<double> residual{};
  CellTangent tangent{};
  if (!(integrate_cell(element, settings, cell, real_u, real_p, residual, &tangent) > 0)) return NAN;
  constexpr std::complex<double> step(0, 1e-30);
  double greatest = 0;
  for (std::size_t j = 0; j < cell_unknowns; ++j) {
    auto u_off = u;
    auto p_off = p;
    if (j < 2 * velocity_nodes) {
      u_off[j / velocity_nodes][j % velocity_nodes] += step;
    } else {
      p_off[j - 2 * velocity_nodes] += step;
    }
    CellResidual<std::complex<double>> off{};
    integrate_cell(element, settings, cell, u_off, p_off, off, nullptr);
    for (std::size_t i = 0; i < cell_unknowns; ++i) {
      const std::complex<double> value = i < 2 * velocity_nodes ? off.momentum[i / velocity_nodes][i % velocity_nodes]
                                                                : off.continuity[i - 2 * velocity_nodes];
      greatest = std::max(greatest, std::abs(tangent[i][j] - value.imag() / step.imag()));
    }
  }
  return greatest;
}

}  // namespace turgor
