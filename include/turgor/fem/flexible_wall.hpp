#pragma once
// A wall that the liquid moves, and that resists it.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace turgor {

/// The wall as the flow solver needs it. Places, velocities and accelerations of its nodes are vectors (r, z) of the
/// first node, of the second one, ...; all forces are per radian.
class FlexibleWall {
 public:
  /// Motion of the wall at the end of a time step, and what a change of its velocity changes.
  struct Motion {
    Eigen::VectorXd places;            ///< [m]
    Eigen::VectorXd velocity;          ///< [m/s]
    Eigen::VectorXd acceleration;      ///< [m/s^2]
    double place_per_velocity;         ///< [s]
    double acceleration_per_velocity;  ///< [1/s]
  };
  struct Resistance {
    Eigen::VectorXd force;                ///< of inertia, elasticity and damping against the motion [N/rad]
    Eigen::SparseMatrix<double> tangent;  ///< its derivative with respect to the velocity [N s/m/rad]
  };

  FlexibleWall() = default;
  virtual ~FlexibleWall() = default;
  FlexibleWall(const FlexibleWall&) = delete;
  FlexibleWall& operator=(const FlexibleWall&) = delete;
  FlexibleWall(FlexibleWall&&) = delete;
  FlexibleWall& operator=(FlexibleWall&&) = delete;

  /// Nodes of the flow's mesh on the wall, in order from the rim, which does not move, to the axis.
  [[nodiscard]] virtual const std::vector<int>& nodes() const = 0;
  /// Places of all nodes of the mesh at t = 0, at rest; (r, z) interleaved.
  [[nodiscard]] virtual std::vector<double> start() const = 0;
  /// @throws ComputationFailed when the wall cannot be like that
  [[nodiscard]] virtual Resistance resistance(const Motion& motion) const = 0;
  /// Places of all nodes of the mesh, (r, z) interleaved, for places of the wall's.
  /// @throws ComputationFailed when the wall cannot be like that
  [[nodiscard]] virtual std::vector<double> mesh(const Eigen::VectorXd& places) const = 0;
};

}  // namespace turgor
