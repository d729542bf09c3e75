#pragma once
// The generalized force of the liquid in a deflating balloon (2.8): g1...g5 of appendix B, exact and as fitted.

#include "turgor/flow/potential_flow.hpp"

namespace turgor {

/// F = g1 r^2 p_ext - rho_f [L_ch g2 + g3 r] r^2 d2r/dt2 + rho_f [L_ch g4 + g5 r] r (dr/dt)^2, (2.8); all [1].
struct ForceCoefficients {
  double g1, g2, g3, g4, g5;
};

/// What g3 and g5 are made of: the flow at the middle of the orifice's plane and its means over the wall, for unit
/// speed and radius. Integrals over x = cos theta of the wall.
struct FlowIntegrals {
  double potential;              ///< U: potential in the orifice
  double potential_change;       ///< dU/deps at a fixed place
  double speed;                  ///< W: axial velocity in the orifice, along theta = 0
  double wall_potential;         ///< Psi: integral of the potential
  double wall_potential_change;  ///< integral of its derivative with respect to eps
  double wall_speed_squared;     ///< I_theta: integral of v_theta^2, which the paper drops
};

/// @return integrals whose errors change g3 and g5 by no more than the flow's tolerance times some units
[[nodiscard]] FlowIntegrals flow_integrals(const PotentialFlow& flow);

/// g1, g2 and g4 of appendix B, which do not depend on the flow in the balloon; g3 = g5 = 0.
/// @param eps  cap_depth(kappa)
[[nodiscard]] ForceCoefficients channel_coefficients(double eps);

/// All five, for any profile; complete, with the integral that the paper drops.
[[nodiscard]] ForceCoefficients force_coefficients(const PotentialFlow& flow);
[[nodiscard]] ForceCoefficients force_coefficients(double eps, const FlowIntegrals& flow);

/// The paper's approximations for uniform outflow: leading terms (2.9), fits (2.10) over kappa = 1/200...1/10.
[[nodiscard]] ForceCoefficients paper_fits(double eps);

/// Closer fits for uniform outflow over 1/200 <= kappa <= 1/10: g1, g2, g4 exact, g3 within 6e-7 and g5
/// within 3e-7 of their complete values, relatively.
[[nodiscard]] ForceCoefficients close_fits(double kappa);

}  // namespace turgor
