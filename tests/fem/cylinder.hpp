#pragma once
// A cylinder of liquid, 0 <= r <= 1, 0 <= z <= 1 in n x n cells unless told otherwise, inlet below, walls above and
// around, and flows in it.

#include <cmath>

#include "turgor/fem/flow_balance.hpp"
#include "turgor/fem/flow_solver.hpp"
#include "turgor/mesh/balloon_mesh.hpp"

namespace turgor {

struct CylinderRequest {
  std::size_t columns;  ///< of cells, from the axis to the outer side
  std::size_t rows;
  double radius = 1;
  double length = 1;
  Side below = Side::inlet;
  Side around = Side::wall;
};

inline BalloonMesh cylinder(const CylinderRequest& request) {
  const auto [n, rows, radius, length, below, around] = request;
  BalloonMesh mesh;
  const auto at = [n = n](std::size_t i, std::size_t j) { return j * (n + 1) + i; };
  const double width = radius / static_cast<double>(n);
  const double height = length / static_cast<double>(rows);
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= n; ++i)
      mesh.points.push_back({static_cast<double>(i) * width, static_cast<double>(j) * height});
  }
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      mesh.cells.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      mesh.wall_edge.push_back(BalloonMesh::no_edge);
    }
    mesh.boundary.push_back({{at(n, j), at(n, j + 1)}, around});
    mesh.boundary.push_back({{at(0, j + 1), at(0, j)}, Side::axis});
  }
  for (std::size_t i = 0; i < n; ++i) {
    mesh.boundary.push_back({{at(i, 0), at(i + 1, 0)}, below});
    mesh.boundary.push_back({{at(i + 1, rows), at(i, rows)}, Side::wall});
  }
  return mesh;
}

/// @param around  what the outer side is
inline BalloonMesh cylinder(std::size_t n, Side around = Side::wall) {
  return cylinder({.columns = n, .rows = n, .around = around});
}

/// A solenoidal flow that is smooth at the axis, on a mesh that moves and bends:
///   u = g(t) (-(r + r^3) cos z, (2 + 4 r^2) sin z), p = h(t) (1 + r^2) cos z, g = 1 + sin(3 t)/2, h = cos 2 t.
struct MadeUpFlow {
  double density;
  double viscosity;

  static double g(double t) { return 1 + std::sin(3 * t) / 2; }
  static double g_rate(double t) { return 1.5 * std::cos(3 * t); }
  static double h(double t) { return std::cos(2 * t); }

  static Point2 velocity(const Point2& x, double t) {
    const auto [r, z] = x;
    return {-g(t) * (r + r * r * r) * std::cos(z), g(t) * (2 + 4 * r * r) * std::sin(z)};
  }
  static double pressure(const Point2& x, double t) { return h(t) * (1 + x[0] * x[0]) * std::cos(x[1]); }

  /// rho (du/dt + u.grad u) + grad p - mu Laplace u
  [[nodiscard]] Point2 body_force(const Point2& x, double t) const {
    const auto [r, z] = x;
    const double c = std::cos(z);
    const double s = std::sin(z);
    const double odd = r + r * r * r;
    const double even = 2 + 4 * r * r;
    const Point2 u = velocity(x, t);
    const Point2 carried{g(t) * (-u[0] * (1 + 3 * r * r) * c + u[1] * odd * s),
                         g(t) * (u[0] * 8 * r * s + u[1] * even * c)};
    const Point2 spread{-g(t) * (7 * r - r * r * r) * c, g(t) * (14 - 4 * r * r) * s};
    return {density * (-g_rate(t) * odd * c + carried[0]) + 2 * r * h(t) * c - viscosity * spread[0],
            density * (g_rate(t) * even * s + carried[1]) - h(t) * (1 + r * r) * s - viscosity * spread[1]};
  }

  /// On a plane z = const whose outward normal points down.
  [[nodiscard]] Point2 traction(const Point2& x, double t) const {
    const auto [r, z] = x;
    const double shear = g(t) * ((r + r * r * r) + 8 * r) * std::sin(z);
    return {-viscosity * shear, pressure(x, t) - 2 * viscosity * g(t) * (2 + 4 * r * r) * std::cos(z)};
  }

  static Point2 position(const Point2& X, double t) {
    return {X[0] * (1 + 0.15 * std::sin(3 * t) * X[1]), X[1] * (1 + 0.1 * std::sin(2 * t) * (1 + X[0] * X[0]))};
  }
  static Point2 mesh_velocity(const Point2& X, double t) {
    return {X[0] * 0.45 * std::cos(3 * t) * X[1], X[1] * 0.2 * std::cos(2 * t) * (1 + X[0] * X[0])};
  }

  [[nodiscard]] FlowDefinition definition() const {
    FlowDefinition flow;
    flow.density = density;
    flow.viscosity = viscosity;
    flow.inflow_penalty = 0;
    flow.position = position;
    flow.mesh_velocity = mesh_velocity;
    flow.wall_velocity = velocity;
    flow.body_force = [*this](const Point2& x, double t) { return body_force(x, t); };
    flow.inlet_traction = [*this](const Point2& x, double t) { return traction(x, t); };
    return flow;
  }

  [[nodiscard]] static FlowLevel level(const FlowSpace& space, double t) {
    FlowLevel level{t, std::vector<double>(static_cast<std::size_t>(space.size()), 0.0)};
    for (std::size_t i = 0; i < space.nodes().size(); ++i) {
      const Point2 u = velocity(position(space.nodes()[i], t), t);
      level.unknowns[2 * i] = u[0];
      level.unknowns[2 * i + 1] = u[1];
    }
    return level;
  }
};

/// Root mean square errors over the domain.
struct FlowErrors {
  double velocity;
  double pressure;
};

template <class Velocity, class Pressure>
FlowErrors errors_of(const FlowSolver& solver, const Velocity& velocity, const Pressure& pressure) {
  FlowErrors sum{};
  double volume = 0;
  for (const auto& cell : solver.space().cells()) {
    const CellState state = solver.state_of(cell);
    const CellUnknowns u = gather(solver.space(), cell, solver.solution());
    for (const ShapeValues& shape : solver.space().element().points()) {
      const CellPoint at = cell_point(shape, state.position);
      Point2 x{};
      Point2 v{};
      double p = 0;
      for (std::size_t c = 0; c < 2; ++c) {
        for (std::size_t i = 0; i < velocity_nodes; ++i) {
          x[c] += shape.value[i] * state.position[c][i];
          v[c] += shape.value[i] * u.velocity[c][i];
        }
      }
      for (std::size_t i = 0; i < pressure_nodes; ++i) p += shape.pressure[i] * u.pressure[i];
      const Point2 exact = velocity(x, solver.time());
      const double off = p - pressure(x, solver.time());
      sum.velocity += at.volume * (std::pow(v[0] - exact[0], 2) + std::pow(v[1] - exact[1], 2));
      sum.pressure += at.volume * off * off;
      volume += at.volume;
    }
  }
  return {std::sqrt(sum.velocity / volume), std::sqrt(sum.pressure / volume)};
}

}  // namespace turgor
