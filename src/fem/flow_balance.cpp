#include "turgor/fem/flow_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace turgor {

namespace {

constexpr double turn = 2 * std::numbers::pi;

void add_cells(const FlowSolver& solver, FlowBalance& sum) {
  const FlowSpace& space = solver.space();
  const CellSettings& s = solver.settings();
  for (const auto& cell : space.cells()) {
    const CellState state = solver.state_of(cell);
    const CellUnknowns unknowns = gather(space, cell, solver.solution());
    for (const ShapeValues& shape : space.element().points()) {
      const CellPoint at = cell_point(shape, state.position);
      const Stabilization stable = stabilization(at, s, frozen_advection(shape, state));
      const auto v = point_values(shape, at, s, state, unknowns.velocity, unknowns.pressure);
      const double w = turn * at.volume;
      sum.volume += w;
      const double speed_squared = v.velocity[0] * v.velocity[0] + v.velocity[1] * v.velocity[1];
      sum.power_of_inertia += w * s.density / 2 * v.divergence * speed_squared;
      double stretching = 2 * v.velocity[0] * v.velocity[0] / (at.radius * at.radius);
      for (std::size_t c = 0; c < 2; ++c) {
        const double along = v.advection[0] * v.gradient[c][0] + v.advection[1] * v.gradient[c][1];
        sum.kinetic_energy += w * s.density / 2 * v.velocity[c] * v.velocity[c];
        sum.power_of_inertia += w * s.density * (v.rate[c] + along) * v.velocity[c];
        sum.upwind_loss += w * stable.streamline * along * v.strong[c];
        for (std::size_t d = 0; d < 2; ++d) {
          stretching += (v.gradient[c][d] + v.gradient[d][c]) * v.gradient[c][d];
        }
      }
      sum.viscous_loss += w * s.viscosity * stretching;
      sum.grad_div_loss += w * stable.grad_div * v.divergence * v.divergence;
    }
  }
}

void add_wall(const FlowSolver& solver, const std::function<Point2(const Point2&)>& mode, FlowBalance& sum) {
  const FlowSpace& space = solver.space();
  const auto& x = solver.positions();
  for (const auto& edge : space.edges()) {
    if (edge.side != Side::wall) continue;
    for (const EdgeValues& q : space.element().edge_points()) {
      Point2 tangent{};
      double radius = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = static_cast<std::size_t>(edge.nodes[k]);
        radius += q.value[k] * x[2 * node];
        for (std::size_t c = 0; c < 2; ++c) tangent[c] += q.derivative[k] * x[2 * node + c];
      }
      double pressure = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        pressure += q.pressure[k] * solver.solution()[static_cast<std::size_t>(space.pressure(edge.pressures[k]))];
      }
      const double area = turn * q.weight * radius * std::hypot(tangent[0], tangent[1]);
      sum.area += area;
      sum.force += pressure * area;
    }
  }
  for (const int node : space.nodes_on(Side::wall)) {
    const Point2 shape = mode(space.nodes()[static_cast<std::size_t>(node)]);
    for (int c = 0; c < 2; ++c) {
      const auto i = static_cast<std::size_t>(space.velocity(node, c));
      sum.force_mode -= turn * solver.reactions()[i] * shape[static_cast<std::size_t>(c)];
      sum.wall_power += turn * solver.reactions()[i] * solver.solution()[i];
    }
  }
}

}  // namespace

FlowBalance flow_balance(const FlowSolver& solver, const std::function<Point2(const Point2& X)>& mode) {
  FlowBalance sum{};
  add_cells(solver, sum);
  add_wall(solver, mode, sum);
  const OpenBoundary& inlet = solver.inlet();
  sum.inflow = turn * inlet.inflow(solver.solution());
  const OpenBoundary::Powers powers = inlet.powers(solver.solution(), solver.frozen());
  const FlowDefinition& flow = solver.definition();
  sum.inlet_power = solver.inlet_pressure(solver.solution()) * sum.inflow;
  sum.inlet_kinetic = turn * flow.density * powers.kinetic;
  sum.penalty_loss = turn * flow.density * flow.inflow_penalty * powers.penalty;
  return sum;
}

double least_jacobian(const FlowSolver& solver) {
  const FlowSpace& space = solver.space();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& cell : space.cells()) {
    NodalVector<double> reference{};
    NodalVector<double> present{};
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      const auto node = static_cast<std::size_t>(cell.nodes[i]);
      for (std::size_t c = 0; c < 2; ++c) {
        reference[c][i] = space.nodes()[node][c];
        present[c][i] = solver.positions()[2 * node + c];
      }
    }
    for (const ShapeValues& shape : space.element().points()) {
      least = std::min(least, cell_point(shape, present).jacobian / cell_point(shape, reference).jacobian);
    }
  }
  return least;
}

}  // namespace turgor
