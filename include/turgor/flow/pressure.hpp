#pragma once
// Pressure in the liquid: where the channel meets the balloon (2.3), and everywhere in a deflating balloon (A1).

#include "turgor/flow/flow_state.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/flow/potential_flow.hpp"

namespace turgor {

/// Pressure at the orifice [Pa] by unsteady Bernoulli along the channel, (2.3). During inflation the pressure of the
/// whole balloon, section 2.2.
/// @param s  radius > orifice_radius
template <class T>
[[nodiscard]] T orifice_pressure(const FlowState<T>& s) {
  const T eps = cap_depth(s.orifice_radius / s.radius);
  const T height = 1 - eps;
  return s.inlet_pressure - s.fluid_density * s.channel_length * channel_speed(eps) *
                                (s.radial_accel + (2 - 4 * eps + eps * eps) / (s.radius * height * height) *
                                                      s.radial_rate * s.radial_rate);
}

/// Pressure in a balloon that deflates with potential flow, (A1) for any profile.
class PressureField {
 public:
  /// @param flow   of kappa = orifice_radius/radius; must outlive this
  /// @param state  radial_rate < 0; at radial_rate >= 0 the formula can be evaluated, but there is a jet
  PressureField(const PotentialFlow& flow, const FlowState<double>& state);

  /// Pressure [Pa] on the scale of the inlet pressure.
  /// @param field  the flow's at that point
  [[nodiscard]] double at(const FlowPoint& point, const FlowField& field) const;

 private:
  /// Pressure less the uniform part, at (radius, height z = radius cos theta) in units of r.
  [[nodiscard]] double variable(double radius, double height, const FlowField& field) const;

  FlowState<double> state_;
  double eps_;
  double uniform_ = 0;
};

}  // namespace turgor
