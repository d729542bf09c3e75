#pragma once
// What the pressure of the liquid depends on at one instant.

namespace turgor {

/// What the force of the liquid on the balloon depends on; SI units.
template <class T>
struct FlowState {
  T radius;          ///< r [m]
  T radial_rate;     ///< dr/dt [m/s]
  T radial_accel;    ///< d2r/dt2 [m/s^2]
  T inlet_pressure;  ///< p_ext [Pa]
  T orifice_radius;  ///< r_ch [m]
  T channel_length;  ///< L_ch [m]
  T fluid_density;   ///< rho_f [kg/m^3]
};

}  // namespace turgor
