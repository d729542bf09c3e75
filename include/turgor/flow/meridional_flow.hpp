#pragma once
// The flow in the whole balloon at once: on a mesh of a meridional half plane, with its stream function.

#include <vector>

#include "turgor/flow/potential_flow.hpp"

namespace turgor {

/// A place in a meridional half plane, in units of the balloon's radius.
struct MeridionalPoint {
  double distance;  ///< from the axis
  double height;    ///< above the orifice's plane, into the balloon
};

/// Mesh of the balloon up to the orifice's plane, in toroidal coordinates whose foci are the rim: lines of constant
/// sigma are arcs from the axis to the rim, from the wall (sigma = asin kappa) to the orifice's plane (sigma = pi);
/// those of constant tau, from 0 on the axis, are arcs from wall to orifice around the rim and end before it, where
/// velocities are infinite.
class MeridionalMesh {
 public:
  /// Distance from the rim over r_ch within which there are no nodes.
  static constexpr double rim_gap = 1e-3;

  /// @param kappa  r_ch/r, 0 < kappa < 1
  /// @param cells  along each coordinate, at least 4
  /// @throws InvalidInput when these are out of range
  MeridionalMesh(double kappa, int cells);

  [[nodiscard]] std::size_t cells() const { return sigma_.size() - 1; }
  /// Nodes along each coordinate.
  [[nodiscard]] std::size_t size() const { return sigma_.size(); }
  /// From the wall to the orifice's plane.
  [[nodiscard]] const std::vector<double>& sigma() const { return sigma_; }
  /// From the axis towards the rim.
  [[nodiscard]] const std::vector<double>& tau() const { return tau_; }
  /// dtau/dj along the index of a node.
  [[nodiscard]] const std::vector<double>& tau_step() const { return tau_step_; }

  [[nodiscard]] MeridionalPoint point(double sigma, double tau) const;
  [[nodiscard]] MeridionalPoint node(std::size_t row, std::size_t column) const {
    return point(sigma_[row], tau_[column]);
  }

  /// Where a point lies between the nodes: row and column as real numbers, at the border when it is outside.
  struct Place {
    double row;
    double column;
  };
  [[nodiscard]] Place place(const MeridionalPoint& point) const;

 private:
  double kappa_;
  std::vector<double> sigma_;
  std::vector<double> tau_;
  std::vector<double> tau_step_;
};

/// Potential flow at the nodes of a mesh, for dr/dt = 1 and r = 1.
class MeridionalFlow {
 public:
  struct Node {
    MeridionalPoint point;
    FlowPoint polar;  ///< the same place about the balloon's centre
    FlowField field;
    double across;  ///< velocity away from the axis
    double along;   ///< velocity along the axis, into the balloon; seen from the balloon's centre
    double
        stream_function;  ///< of Stokes, seen from the channel: flux into the balloon over 2 pi, between here and axis
  };

  /// The stream function is within 1e-5 of total_stream() for meshes of 100 cells and smooth profiles.
  MeridionalFlow(const PotentialFlow& flow, int cells);

  [[nodiscard]] const MeridionalMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Node& node(std::size_t row, std::size_t column) const {
    return nodes_[row * mesh_.size() + column];
  }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Velocity of the balloon's centre along the axis: 1/(1-eps).
  [[nodiscard]] double centre_speed() const { return centre_speed_; }
  /// Stream function at the rim: the flux through the orifice over 2 pi.
  [[nodiscard]] double total_stream() const { return total_stream_; }

  /// The line from wall to orifice within which a share of the outflow runs, as a point for each row of the mesh.
  /// Seen from the channel.
  /// @param share  0 < share < 1
  [[nodiscard]] std::vector<MeridionalPoint> stream_line(double share) const;

 private:
  void integrate_row(std::size_t row);
  [[nodiscard]] double flux(std::size_t row, std::size_t column) const;

  MeridionalMesh mesh_;
  double centre_speed_;
  double total_stream_;
  std::vector<Node> nodes_;
};

}  // namespace turgor
