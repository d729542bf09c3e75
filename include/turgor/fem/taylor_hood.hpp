#pragma once
// The Taylor-Hood element Q2/Q1 on the unit square: nodes, shape functions and their values at quadrature points.

#include <array>
#include <cstddef>
#include <vector>

namespace turgor {

using Point2 = std::array<double, 2>;  ///< (distance from the axis, height) [m]

inline constexpr std::size_t velocity_nodes = 9;  ///< of a cell: corners, edges' middles, centre
inline constexpr std::size_t pressure_nodes = 4;  ///< of a cell: its corners
inline constexpr std::size_t cell_unknowns = 2 * velocity_nodes + pressure_nodes;

/// Shape functions at one point of the unit square, derivatives with respect to its coordinates.
struct ShapeValues {
  double weight;  ///< of the quadrature rule; they sum up to 1
  std::array<double, velocity_nodes> value;
  std::array<std::array<double, velocity_nodes>, 2> gradient;  ///< d/dxi, d/deta
  std::array<std::array<double, velocity_nodes>, 3> hessian;   ///< d2/dxi2, d2/dxi deta, d2/deta2
  std::array<double, pressure_nodes> pressure;
  std::array<std::array<double, pressure_nodes>, 2> pressure_gradient;
};

/// Shape functions of an edge of a cell: its two ends, then its middle.
struct EdgeValues {
  double weight;
  std::array<double, 3> value;
  std::array<double, 3> derivative;  ///< along the edge, from 0 to 1
  std::array<double, 2> pressure;    ///< of the two ends
};

/// The reference element, numbered as deal.II numbers FE_Q(2) and FE_Q(1).
class TaylorHood {
 public:
  /// Gauss points per direction. Three integrate the divergence of a velocity over a cell with Q2 geometry exactly, so
  /// that flux and rate of volume agree to rounding; but not the convection, whose aliases feed on a jet that the cells
  /// do not resolve until its energy has no bounds. Four do both.
  static constexpr unsigned points_per_direction = 4;

  TaylorHood();
  [[nodiscard]] const std::vector<ShapeValues>& points() const { return points_; }
  [[nodiscard]] const std::vector<EdgeValues>& edge_points() const { return edge_points_; }
  /// Place of a velocity node in the unit square.
  [[nodiscard]] const Point2& node(std::size_t i) const { return nodes_[i]; }

 private:
  std::vector<ShapeValues> points_;
  std::vector<EdgeValues> edge_points_;
  std::array<Point2, velocity_nodes> nodes_;
};

}  // namespace turgor
