#pragma once
// The wall of a balloon as an elastic membrane, on the flow mesh's nodes.

#include "turgor/case/case.hpp"
#include "turgor/fem/flexible_wall.hpp"
#include "turgor/fem/flow_space.hpp"
#include "turgor/membrane/membrane.hpp"
#include "turgor/mesh/toroidal_coordinates.hpp"

namespace turgor {

/// The membrane of a case. The mesh in it follows in toroidal coordinates about the rim: along a line of constant tau
/// of the stress-free balloon, pi - sigma is scaled as it is at the wall, and tau changes in proportion to it. So a
/// wall that turns about the rim turns the cells there with it, all by the same share, however small they are; a
/// balloon that stays a sphere has the mesh of ToroidalMotion.
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
  /// How a node of the mesh follows the wall.
  struct Follower {
    std::size_t node;
    ToroidalCoordinates reference;
    double share;        ///< of the wall's angle pi - sigma
    std::size_t behind;  ///< nodes_[behind] and the one after it are the nodes of the wall about its tau
    double weight;       ///< of the latter
  };
  [[nodiscard]] std::vector<Follower> followers() const;

  const FlowSpace& space_;
  double orifice_radius_;
  std::vector<int> nodes_;
  Membrane membrane_;
  std::vector<ToroidalCoordinates> reference_;  ///< of the wall's nodes
  std::vector<Follower> followers_;
  Eigen::VectorXd start_;
};

}  // namespace turgor
