#pragma once
// Elastic energy of a balloon at rest, by its volume.

#include <vector>

#include "turgor/case/case.hpp"

namespace turgor {

/// The least elastic energy that the membrane of a case has at a volume, as far as its states of rest are stable at
/// held volume: what a moving balloon's wall has beyond it is in its shape. Energies of the states of
/// inflation_curve(), and between them by cubic polynomials that have the pressure, its exact derivative, for slope.
class RestEnergy {
 public:
  /// @param volume  up to which it is wanted [m^3]
  /// @throws ComputationFailed when the curve of equilibria ends before
  RestEnergy(const Case& c, double volume);

  /// [J] at a volume [m^3]; 0 below the slack balloon's, the energy of the last state beyond the end.
  [[nodiscard]] double operator()(double volume) const;

 private:
  std::vector<double> volumes_;
  std::vector<double> energies_;
  std::vector<double> pressures_;
};

}  // namespace turgor
