#include "turgor/flow/pressure.hpp"

#include <cmath>

namespace turgor {

PressureField::PressureField(const PotentialFlow& flow, const FlowState<double>& state)
    : state_(state), eps_(flow.eps()) {
  const double height = 1 - eps_;
  uniform_ = orifice_pressure(state) - variable(height, -height, flow.at_orifice());
}

double PressureField::at(const FlowPoint& point, const FlowField& field) const {
  return uniform_ + variable(point.radius, point.radius * std::cos(point.theta), field);
}

/// -rho_f (dphi/dt + |v|^2/2) in the frame of the channel, written in the coordinates about the moving centre.
double PressureField::variable(double radius, double height, const FlowField& field) const {
  const double centre = height / (1 - eps_);           // potential of the centre's motion, dr_c/dt = 1/(1-eps)
  const double rate = eps_ * (2 - eps_) / (1 - eps_);  // -deps/dt r/(dr/dt)
  const double inertial = centre + field.potential;
  const double centripetal = rate / (1 - eps_) * centre + rate * field.potential_change + radius * field.radial -
                             field.potential - (field.radial * field.radial + field.tangential * field.tangential) / 2;
  return state_.fluid_density *
         (centripetal * state_.radial_rate * state_.radial_rate - inertial * state_.radius * state_.radial_accel);
}

}  // namespace turgor
