#include "turgor/fem/flow_fields.hpp"

namespace turgor {

namespace {

/// Ours by lines of the unit square (0,0), (1,0), (0,1), (1,1), left, right, lower, upper, centre; VTK's go around.
constexpr std::array<std::size_t, velocity_nodes> vtk_order{0, 1, 3, 2, 6, 5, 7, 4, 8};

/// The pressure at every velocity node; it is bilinear in a cell, and continuous.
std::vector<double> nodal_pressure(const FlowSolver& solver) {
  const FlowSpace& space = solver.space();
  std::vector<double> nodal(space.nodes().size());
  for (const auto& cell : space.cells()) {
    std::array<double, pressure_nodes> p{};
    for (std::size_t k = 0; k < pressure_nodes; ++k) {
      p[k] = solver.solution()[static_cast<std::size_t>(space.pressure(cell.pressures[k]))];
    }
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      const auto [xi, eta] = space.element().node(i);
      nodal[static_cast<std::size_t>(cell.nodes[i])] =
          (1 - eta) * ((1 - xi) * p[0] + xi * p[1]) + eta * ((1 - xi) * p[2] + xi * p[3]);
    }
  }
  return nodal;
}

}  // namespace

VtuGrid flow_fields(const FlowSolver& solver) {
  const FlowSpace& space = solver.space();
  VtuGrid grid;
  PointData velocity{"velocity", 3, {}};
  PointData displacement{"displacement", 3, {}};
  PointData mesh{"mesh_velocity", 3, {}};
  for (std::size_t i = 0; i < space.nodes().size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      grid.points.push_back(solver.positions()[2 * i + c]);
      velocity.values.push_back(solver.solution()[2 * i + c]);
      displacement.values.push_back(solver.positions()[2 * i + c] - space.nodes()[i][c]);
      mesh.values.push_back(solver.mesh_velocities()[2 * i + c]);
    }
    for (std::vector<double>* list : {&grid.points, &velocity.values, &displacement.values, &mesh.values}) {
      list->push_back(0.0);
    }
  }
  for (const auto& cell : space.cells()) {
    auto& corners = grid.biquadratic.emplace_back();
    for (std::size_t k = 0; k < velocity_nodes; ++k) corners[k] = cell.nodes[vtk_order[k]];
  }
  grid.data = {std::move(velocity), {"pressure", 1, nodal_pressure(solver)}, std::move(displacement), std::move(mesh)};
  return grid;
}

}  // namespace turgor
