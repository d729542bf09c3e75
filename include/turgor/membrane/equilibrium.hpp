#pragma once
// The membrane at rest under a uniform gauge pressure: by pressure, by volume, and along the whole curve past its limit
// points.

#include <vector>

#include "turgor/membrane/membrane.hpp"

namespace turgor {

/// A state of rest.
struct MembraneState {
  Eigen::VectorXd places;  ///< as in Membrane
  double pressure = 0;     ///< gauge pressure inside [Pa]
  double volume = 0;       ///< of all of it, 2 pi times Membrane::volume() [m^3]
  double radius = 0;       ///< sqrt(S/pi + a^2)/2 [m] with the wall's area S and the rim's radius a: that of a sphere
};

/// The stress-free state, without pressure.
[[nodiscard]] MembraneState slack_state(const Membrane& membrane);

/// The state at a pressure, reached from another one through stable states: by Newton's method with the exact tangent,
/// in steps of pressure as long as it allows.
/// @throws ComputationFailed with pressure and radius of the last state when there is none any more: the membrane
///         bursts, or jumps to another well, at the limit point; InvalidInput for a pressure that is not finite
[[nodiscard]] MembraneState hold_pressure(const Membrane& membrane, const MembraneState& start, double pressure);

/// The state at a volume [m^3], reached from another one in steps of volume; limit points of the pressure do not
/// matter.
/// @throws ComputationFailed with volume and pressure of the last state, where Newton's method fails in small steps;
///         InvalidInput for a volume that is not positive and finite
[[nodiscard]] MembraneState hold_volume(const Membrane& membrane, const MembraneState& start, double volume);

/// States along the curve of equilibria, as pseudo-arclength continuation finds them.
struct InflationCurve {
  std::vector<MembraneState> states;
  std::vector<std::size_t> limit_points;  ///< those of the states that are extrema of the pressure, to rounding
};
/// From a state on with rising pressure, up to a volume [m^3].
/// @throws ComputationFailed when the curve ends before; InvalidInput when the volume is not beyond that of the start
[[nodiscard]] InflationCurve inflation_curve(const Membrane& membrane, const MembraneState& start, double volume);

/// The first maximum of the pressure on the way from the slack state to a volume [m^3].
/// @throws ComputationFailed when the pressure has none up to there, or the curve ends before
[[nodiscard]] MembraneState limit_point(const Membrane& membrane, double volume);

/// Number of independent disturbances that a state gives way to.
struct UnstableModes {
  int at_pressure;  ///< negative eigenvalues of the tangent while the pressure is held
  int at_volume;    ///< the same among disturbances that keep the volume
};
/// @throws ComputationFailed when the tangent is singular, as it is at a limit point
[[nodiscard]] UnstableModes unstable_modes(const Membrane& membrane, const MembraneState& state);

/// Tangent at rest under a held pressure [N/m/rad]: Hessian of elastic energy - pressure times volume, all unknowns.
[[nodiscard]] Eigen::SparseMatrix<double> tangent_at_pressure(const Membrane& membrane, const MembraneState& state);

/// A small free oscillation about a state.
struct ShapeMode {
  double frequency_squared;  ///< angular, [1/s^2]; negative: it grows at the rate of its root
  Eigen::VectorXd shape;     ///< of all unknowns, with shape.M.shape = 1 kg/rad
};
/// The lowest of them under held pressure, in order: tangent against mass of the wall plus an added mass.
/// @param added_mass  of the liquid, 2n x 2n, symmetric, not negative [kg/rad]
/// @param count       as many as there are at most
/// @throws ComputationFailed when the eigenvalue solver fails
[[nodiscard]] std::vector<ShapeMode> shape_modes(const Membrane& membrane, const MembraneState& state,
                                                 const Eigen::MatrixXd& added_mass, std::size_t count);

}  // namespace turgor
