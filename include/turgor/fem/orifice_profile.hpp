#pragma once
// The profile of the outflow over the orifice, averaged over time: f(Upsilon) of (2.13) as the flow itself makes it.

#include <vector>

#include "turgor/fem/flow_problem.hpp"
#include "turgor/fem/flow_solver.hpp"

namespace turgor {

/// Mean of u_z over its mean in the plane of the orifice, z = 0, in which nodes lie.
class OrificeProfile {
 public:
  /// @param orifice_radius  [m]
  OrificeProfile(const FlowSpace& space, double orifice_radius);

  /// @param solution  while liquid leaves the balloon
  /// @param weight    how long [s]
  void add(const std::vector<double>& solution, double weight);

  /// From the axis to the rim; empty when nothing was added.
  [[nodiscard]] std::vector<OutflowPoint> mean() const;

  /// What add() has built up: sums, then the weight.
  [[nodiscard]] std::vector<double> sums() const;
  void restore(const std::vector<double>& sums);

 private:
  std::vector<std::size_t> axial_;  ///< unknowns, by distance from the axis
  std::vector<double> upsilon_;
  std::vector<double> sums_;
  double weight_ = 0;
};

}  // namespace turgor
