#pragma once
// How a mesh follows its wall where the wall is no sphere.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "turgor/fem/flow_space.hpp"

namespace turgor {

/// Displacements of the mesh's nodes that continue given ones of the wall: harmonic in the plane of the mesh as it was
/// made, with a stiffness of one over the cell's area, so that small cells keep their shape. The orifice's plane and
/// all below it stay, the axis stays the axis.
class MeshExtension {
 public:
  /// @param wall  nodes on the wall
  MeshExtension(const FlowSpace& space, std::vector<int> wall);

  /// Adds the continued displacements to places (r, z) of all nodes, interleaved.
  /// @param displacement  (r, z) of each node of the wall, interleaved [m]
  void add(const Eigen::VectorXd& displacement, std::vector<double>& positions) const;

 private:
  /// One component of the displacement.
  struct Component {
    std::vector<int> inner;               ///< nodes that are free
    Eigen::SparseMatrix<double> to_wall;  ///< stiffness between inner nodes and the wall's
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  };

  std::vector<int> wall_;
  std::array<Component, 2> components_;
};

}  // namespace turgor
