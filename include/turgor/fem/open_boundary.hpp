#pragma once
// The inlet: mean traction given, velocity free, and stable when liquid comes in.

#include <algorithm>
#include <vector>

#include "turgor/fem/flow_space.hpp"

namespace turgor {

/// The plane z = const through which liquid enters and leaves. The mean normal traction over the free nodes is the
/// given pressure to rounding; the deviation of the entering profile from its mean is penalised,
///   beta rho U (u_z - mean u_z) with U = max(mean u_z, 0), and beta rho max(u_z, 0) u_r.
/// U is the same all over the plane: a local |u_z| would shift the mean traction by rho Var(u_z)/2. Without the
/// penalty, entering liquid of small viscosity is unstable: nothing holds the profile.
class OpenBoundary {
 public:
  /// @param free  of each node of the space: the axial velocity is an unknown
  OpenBoundary(const FlowSpace& space, const std::vector<bool>& free);

  [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; }
  /// Flux into the balloon over 2 pi [m^3/s/rad].
  [[nodiscard]] double inflow(const std::vector<double>& solution) const;
  /// max(mean of u_z over all of the plane, 0) [m/s]
  [[nodiscard]] double mean_inflow(const std::vector<double>& solution) const {
    return std::max(inflow(solution) / area_, 0.0);
  }
  /// Area over 2 pi [m^2/rad].
  [[nodiscard]] double area() const { return area_; }
  /// Force of a unit pressure on the axial velocity of nodes()[i] [m^2/rad].
  [[nodiscard]] double weight(std::size_t i) const { return weight_[i]; }
  /// Penalty matrices over rho beta U and rho beta, between nodes() [m^2/rad], [m^3/s/rad].
  [[nodiscard]] double axial(std::size_t i, std::size_t j) const { return axial_[i * nodes_.size() + j]; }
  /// Over 2 pi and the density: kinetic energy carried in, and loss to the penalty over beta [m^5/s^3/rad].
  struct Powers {
    double kinetic;
    double penalty;
  };
  [[nodiscard]] Powers powers(const std::vector<double>& velocity, const std::vector<double>& frozen) const;
  /// integral max(u_z, 0) N_i N_j r dr
  [[nodiscard]] std::vector<double> tangential(const std::vector<double>& velocity) const;
  /// Greatest u_z of a node, at least its mean over the free nodes and at least 0 [m/s]: where the flow through the
  /// plane turns, liquid enters in places although the mean leaves, and the energy that it brings must be lost as well.
  [[nodiscard]] double entering_speed(const std::vector<double>& velocity) const;

 private:
  const FlowSpace& space_;
  std::vector<int> nodes_;
  std::vector<const FlowSpace::Edge*> edges_;
  std::vector<double> weight_;  ///< integral N_i r dr
  std::vector<double> free_weight_;
  std::vector<double> axial_;
  double area_ = 0;
};

}  // namespace turgor
