#pragma once
// The wall of a balloon as an elastic membrane, on the flow mesh's nodes.

#include "turgor/case/case.hpp"
#include "turgor/fem/flexible_wall.hpp"
#include "turgor/fem/mesh_extension.hpp"
#include "turgor/membrane/membrane.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace turgor {

/// The membrane of a case. The mesh in it follows by toroidal coordinates, as that of a sphere of the same volume, and
/// harmonically from there to the wall.
class ElasticWall final : public FlexibleWall {
 public:
  /// @param space  on a mesh of the stress-free balloon
  /// @throws ComputationFailed when there is no state of rest at the initial volume
  ElasticWall(const FlowSpace& space, const Case& c);

  [[nodiscard]] const std::vector<int>& nodes() const override { return nodes_; }
  [[nodiscard]] std::vector<double> start() const override { return mesh(start_); }
  [[nodiscard]] Resistance resistance(const Motion& motion) const override;
  [[nodiscard]] std::vector<double> mesh(const Eigen::VectorXd& places) const override;

  [[nodiscard]] const Membrane& membrane() const { return membrane_; }
  /// Places of the wall's nodes among (r, z) of all nodes, interleaved; velocities likewise.
  [[nodiscard]] Eigen::VectorXd of_wall(const std::vector<double>& all) const;

 private:
  [[nodiscard]] double equivalent_radius(const Eigen::VectorXd& places) const;

  const FlowSpace& space_;
  double orifice_radius_;
  double radius_;  ///< stress-free
  std::vector<int> nodes_;
  Membrane membrane_;
  ToroidalMotion sphere_;
  MeshExtension extension_;
  Eigen::VectorXd start_;
};

}  // namespace turgor
