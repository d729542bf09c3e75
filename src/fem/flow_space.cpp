#include "turgor/fem/flow_space.hpp"

#include <deal.II/base/geometry_info.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <map>
#include <set>

namespace turgor {

namespace {

using EdgeKey = std::array<std::size_t, 2>;

EdgeKey key_of(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

/// deal.II's corners 0..3 lie at (0,0), (1,0), (0,1), (1,1); ours go round.
void make_triangulation(const BalloonMesh& mesh, dealii::Triangulation<2>& triangulation) {
  std::vector<dealii::Point<2>> points;
  points.reserve(mesh.points.size());
  for (const Point2& x : mesh.points) points.emplace_back(x[0], x[1]);
  std::vector<dealii::CellData<2>> cells;
  for (const auto& corners : mesh.cells) {
    dealii::CellData<2> cell;
    cell.vertices = {static_cast<unsigned>(corners[0]), static_cast<unsigned>(corners[1]),
                     static_cast<unsigned>(corners[3]), static_cast<unsigned>(corners[2])};
    cells.push_back(cell);
  }
  dealii::GridTools::consistently_order_cells(cells);  // turns cells, keeps their order
  triangulation.create_triangulation(points, cells, dealii::SubCellData());
}

/// Where in the unit square of a cell of the mesh deal.II's corners 0, 1, 2 lie, which says how deal.II has turned it.
class Turned {
 public:
  Turned(const std::array<std::size_t, 4>& corners, const std::array<std::size_t, 3>& first_three) {
    for (std::size_t v = 0; v < 3; ++v) {
      const auto at = static_cast<std::size_t>(std::ranges::find(corners, first_three[v]) - corners.begin());
      corner_[v] = {at == 1 || at == 2 ? 1.0 : 0.0, at >= 2 ? 1.0 : 0.0};
    }
  }
  [[nodiscard]] Point2 operator()(const Point2& unit) const {
    Point2 x{};
    for (std::size_t d = 0; d < 2; ++d) {
      x[d] = corner_[0][d] + unit[0] * (corner_[1][d] - corner_[0][d]) + unit[1] * (corner_[2][d] - corner_[0][d]);
    }
    return x;
  }

 private:
  std::array<Point2, 3> corner_{};
};

}  // namespace

FlowSpace::FlowSpace(const BalloonMesh& mesh) {
  dealii::Triangulation<2> triangulation;
  make_triangulation(mesh, triangulation);
  const dealii::FE_Q<2> velocity(2);
  const dealii::FE_Q<2> pressure(1);
  dealii::DoFHandler<2> velocity_dofs(triangulation);
  dealii::DoFHandler<2> pressure_dofs(triangulation);
  velocity_dofs.distribute_dofs(velocity);
  pressure_dofs.distribute_dofs(pressure);
  dealii::DoFRenumbering::Cuthill_McKee(velocity_dofs);
  nodes_.resize(velocity_dofs.n_dofs());
  pressure_count_ = static_cast<int>(pressure_dofs.n_dofs());

  std::map<EdgeKey, Side> sides;
  for (const auto& edge : mesh.boundary) sides[key_of(edge.points[0], edge.points[1])] = edge.side;

  std::vector<dealii::types::global_dof_index> of_velocity(velocity_nodes);
  std::vector<dealii::types::global_dof_index> of_pressure(pressure_nodes);
  auto other = pressure_dofs.begin_active();
  for (const auto& cell : velocity_dofs.active_cell_iterators()) {
    cell->get_dof_indices(of_velocity);
    (other++)->get_dof_indices(of_pressure);
    Cell numbered{};
    std::ranges::transform(of_velocity, numbered.nodes.begin(), [](auto i) { return static_cast<int>(i); });
    std::ranges::transform(of_pressure, numbered.pressures.begin(), [](auto i) { return static_cast<int>(i); });
    cells_.push_back(numbered);
    const std::size_t at = cell->active_cell_index();
    const Turned turned(mesh.cells[at], {cell->vertex_index(0), cell->vertex_index(1), cell->vertex_index(2)});
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      const Point2 x = turned(element_.node(i));
      nodes_[of_velocity[i]] = mesh.at(at, x[0], x[1]);
    }
    for (unsigned f = 0; f < 4; ++f) {
      if (!cell->at_boundary(f)) continue;
      const auto a = dealii::GeometryInfo<2>::face_to_cell_vertices(f, 0);
      const auto b = dealii::GeometryInfo<2>::face_to_cell_vertices(f, 1);
      const auto side = sides.at(key_of(cell->vertex_index(a), cell->vertex_index(b)));
      const bool along = f == 1 || f == 2;  // counterclockwise: right face upwards, lower face to the right
      const unsigned first = along ? a : b;
      const unsigned second = along ? b : a;
      edges_.push_back({side,
                        {numbered.nodes[first], numbered.nodes[second], numbered.nodes[4 + f]},
                        {numbered.pressures[first], numbered.pressures[second]}});
    }
  }
}

std::vector<int> FlowSpace::nodes_on(Side side) const {
  std::set<int> nodes;
  for (const Edge& edge : edges_) {
    if (edge.side == side) nodes.insert(edge.nodes.begin(), edge.nodes.end());
  }
  return {nodes.begin(), nodes.end()};
}

std::array<int, cell_unknowns> FlowSpace::unknowns(const Cell& cell) const {
  std::array<int, cell_unknowns> list{};
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    list[i] = velocity(cell.nodes[i], 0);
    list[velocity_nodes + i] = velocity(cell.nodes[i], 1);
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) list[2 * velocity_nodes + i] = pressure(cell.pressures[i]);
  return list;
}

CellUnknowns gather(const FlowSpace& space, const FlowSpace::Cell& cell, const std::vector<double>& all) {
  CellUnknowns values{};
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    for (int c = 0; c < 2; ++c) {
      values.velocity[static_cast<std::size_t>(c)][i] = all[static_cast<std::size_t>(space.velocity(cell.nodes[i], c))];
    }
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) {
    values.pressure[i] = all[static_cast<std::size_t>(space.pressure(cell.pressures[i]))];
  }
  return values;
}

}  // namespace turgor
