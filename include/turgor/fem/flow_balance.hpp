#pragma once
// Force on the wall, fluxes and energies of a computed flow.

#include "turgor/fem/flow_solver.hpp"

namespace turgor {

/// Integrals over the balloon at the solver's present time, from the weak form itself: powers add up to rounding,
///   power_of_inertia = wall_power + inlet_power - viscous - upwind - grad_div - penalty losses.
struct FlowBalance {
  double force;             ///< integral of p dS over the wall, gauge [N]
  double force_mode;        ///< force of the liquid on the wall's motion with the radius: - int (sigma n).dx/dr dS [N]
  double inflow;            ///< through the inlet [m^3/s]
  double volume;            ///< of all liquid that is meshed [m^3]
  double area;              ///< of the wall [m^2]
  double kinetic_energy;    ///< [J]
  double power_of_inertia;  ///< int rho [du/dt + a.grad u + (div u) u/2].u [W]
  double wall_power;        ///< of the wall on the liquid [W]
  double inlet_power;       ///< of the traction at the inlet [W]
  double inlet_kinetic;     ///< kinetic energy carried in through the inlet [W]
  double viscous_loss;      ///< [W], as the next ones
  double upwind_loss;       ///< to the streamline-upwind term
  double grad_div_loss;
  double penalty_loss;  ///< at the inlet
};

/// @param mode  dx/dr of a place X of the mesh [1], at the present time
[[nodiscard]] FlowBalance flow_balance(const FlowSolver& solver, const std::function<Point2(const Point2& X)>& mode);

/// Least ratio of a volume element of the plane at present to what it was in the configuration that was meshed.
[[nodiscard]] double least_jacobian(const FlowSolver& solver);

}  // namespace turgor
