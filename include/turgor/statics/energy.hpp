#pragma once
// Potential energy of the balloon under a constant pressure, its wells and the barriers between them.

#include <optional>
#include <vector>

#include "turgor/oscillator/parameters.hpp"

namespace turgor {

/// Volume [m^3] that the pressure works on, V with dV/dR = 4 pi r0^3 a(R): (4 pi/3) r0^3 R^3, the balloon's own, and
/// with an exact closure (2 pi/3) r^3 (1 + (1 - kappa^2)^(3/2)), kappa = r_ch/r, since nothing works on the opening.
/// @param R  > 0; with an exact closure >= r_ch/r0
[[nodiscard]] double working_volume(const Parameters<double>& p, double R);

/// Strain energy of the wall [J], eq. (2.19): 4 pi r0^2 d0 W(R).
[[nodiscard]] double strain_energy_of(const Parameters<double>& p, double R);

/// Potential energy [J] at gauge pressure [Pa], eq. (3.2) for any material: strain_energy_of - pressure working_volume.
/// Stationary at equilibria, least at stable ones.
[[nodiscard]] double potential_energy(const Parameters<double>& p, double R, double pressure);

/// A stable equilibrium and what it takes to leave it.
struct Well {
  double stretch;
  double energy;                        ///< potential_energy [J]
  std::optional<double> barrier_below;  ///< to the unstable equilibrium below [J]; nothing when there is none
  std::optional<double> barrier_above;  ///< to the unstable equilibrium above [J]; nothing when there is none
};

/// All stable equilibria at gauge pressure [Pa], in order of R; none when the pressure is out of reach.
[[nodiscard]] std::vector<Well> wells(const Parameters<double>& p, double pressure);

}  // namespace turgor
