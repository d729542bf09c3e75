#pragma once
// The wall of a tube for the flow solver.

#include "tube_theory.hpp"
#include "turgor/fem/flow_solver.hpp"

namespace turgor {

/// Cells in straight rows, closed above, and below where it is not an inlet.
/// @param graded  the columns become narrow towards the wall, as sin x
[[nodiscard]] BalloonMesh tube_mesh(const Tube& tube, std::size_t columns, std::size_t rows, Side below, bool graded);

/// The rings of a Tube and the closed ends, along which the liquid slides and through which it does not pass; so it
/// does along the rings when it has no viscosity. All points of the mesh move in proportion to the ring at their
/// height. The first node does not move: the end of the wall at an inlet, or the middle of a closed end.
class TubeWall final : public FlexibleWall {
 public:
  /// @param space  must stay
  TubeWall(const FlowSpace& space, const Tube& tube);

  [[nodiscard]] const std::vector<int>& nodes() const override { return nodes_; }
  [[nodiscard]] std::vector<double> start() const override;
  [[nodiscard]] Resistance resistance(const Motion& motion) const override;
  [[nodiscard]] std::vector<double> mesh(const Eigen::VectorXd& places) const override;

  /// What a mesh's velocities or places are when the rings have radial ones.
  template <class Ring>
  [[nodiscard]] std::vector<double> followed(const Ring& of_height) const {
    std::vector<double> all;
    for (const Point2& X : space_.nodes()) {
      all.push_back(X[0] / tube_.radius * of_height(X[1]));
      all.push_back(0);
    }
    return all;
  }
  /// Displacements of the rings [m], equally spaced from z = 0 to the other end.
  [[nodiscard]] std::vector<double> displacements(const FlowSolver& solver) const;
  /// Kinetic and elastic [J].
  [[nodiscard]] double energy(const FlowSolver& solver) const;

 private:
  [[nodiscard]] const Point2& place(int node) const { return space_.nodes()[static_cast<std::size_t>(node)]; }
  [[nodiscard]] bool on_ring(int node) const;
  void integrate_rings();
  void hold_lengthways();

  const FlowSpace& space_;
  Tube tube_;
  std::vector<int> nodes_;
  Eigen::VectorXd rest_;
  Eigen::SparseMatrix<double> mass_;
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::SparseMatrix<double> hold_;  ///< force over velocity
};

}  // namespace turgor
