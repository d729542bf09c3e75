#pragma once
// Numbering of velocity and pressure on a meridional mesh.

#include <array>
#include <vector>

#include "turgor/fem/taylor_hood.hpp"
#include "turgor/mesh/balloon_mesh.hpp"

namespace turgor {

/// Nodes and unknowns of the Taylor-Hood space Q2/Q1 on a mesh. Unknowns are numbered: radial and axial velocity of
/// each node, then the pressures.
class FlowSpace {
 public:
  struct Cell {
    std::array<int, velocity_nodes> nodes;
    std::array<int, pressure_nodes> pressures;
  };
  /// An edge of the boundary; the liquid lies to the left of the way from its first node to its second.
  struct Edge {
    Side side;
    std::array<int, 3> nodes;  ///< begin, end, middle
    std::array<int, 2> pressures;
  };

  explicit FlowSpace(const BalloonMesh& mesh);

  [[nodiscard]] const TaylorHood& element() const { return element_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// Place of every node in the configuration that was meshed [m].
  [[nodiscard]] const std::vector<Point2>& nodes() const { return nodes_; }
  /// Nodes on a side, in ascending order.
  [[nodiscard]] std::vector<int> nodes_on(Side side) const;

  [[nodiscard]] int node_count() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] int pressure_count() const { return pressure_count_; }
  [[nodiscard]] int size() const { return 2 * node_count() + pressure_count_; }
  // NOLINTNEXTLINE(readability-convert-member-functions-to-static): what numbers the others are members
  [[nodiscard]] int velocity(int node, int component) const { return 2 * node + component; }
  [[nodiscard]] int pressure(int index) const { return 2 * node_count() + index; }
  /// Unknowns of a cell: radial velocities, axial velocities, pressures.
  [[nodiscard]] std::array<int, cell_unknowns> unknowns(const Cell& cell) const;

 private:
  TaylorHood element_;
  std::vector<Cell> cells_;
  std::vector<Edge> edges_;
  std::vector<Point2> nodes_;
  int pressure_count_ = 0;
};

/// Values of a list of all unknowns in one cell.
struct CellUnknowns {
  std::array<std::array<double, velocity_nodes>, 2> velocity;
  std::array<double, pressure_nodes> pressure;
};
[[nodiscard]] CellUnknowns gather(const FlowSpace& space, const FlowSpace::Cell& cell, const std::vector<double>& all);

}  // namespace turgor
