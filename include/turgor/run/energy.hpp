#pragma once
// Where the energy goes: the balance of eq. (2.22) along a trajectory.
//
// With the kinetic energy M_s v^2/2 (v = dR/dT), the equation of motion gives
//     d/dT (M_s v^2/2 + elastic) = a P v + (M_s'/2 + Q_s) v^3,
// and the last term vanishes during inflation and is negative during deflation: what the outflow carries off. With an
// exact closure and a channel it is next to zero and positive during inflation (docs/theory.md, section 2.4).

#include <vector>

#include "turgor/integrate/trajectory.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

/// Energies in J; work and dissipation are counted from the start of the trajectory.
struct Energies {
  double kinetic;
  double elastic;
  double inlet_work;
  double dissipated;
};

/// The energy balance of one trajectory. Work and dissipation are integrals over the dense output, independent of the
/// equation of motion that produced it, so that the balance measures the integration's error.
class EnergyLedger {
 public:
  /// Both arguments must outlive the ledger.
  EnergyLedger(const Oscillator<double>& oscillator, const Trajectory<double>& trajectory);

  /// Energies at dimensionless time T within the trajectory.
  [[nodiscard]] Energies at(double time) const;

  /// |kinetic + elastic - work + dissipated - initial| at the end, over the largest of these energies on the way [1].
  [[nodiscard]] double closure_error() const;

 private:
  struct Flux {
    double work;
    double dissipated;
  };
  [[nodiscard]] Flux over_step(const TrajectoryStep<double>& step, double theta) const;
  [[nodiscard]] double kinetic(const Point<double>& point) const;

  const Oscillator<double>& oscillator_;
  const Trajectory<double>& trajectory_;
  std::vector<Flux>
      before_step_;  ///< dimensionless, from the start to the beginning of each step; one more for the end
};

}  // namespace turgor
