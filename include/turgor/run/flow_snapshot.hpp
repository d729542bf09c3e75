#pragma once
// The flow inside a deflating balloon at one instant: state, orifice, forces, and where it is written to.

#include <memory>
#include <optional>
#include <string>

#include "turgor/case/case.hpp"
#include "turgor/flow/meridional_flow.hpp"
#include "turgor/flow/pressure.hpp"

namespace turgor {

/// The instant at which the flow is wanted.
struct FlowInstant {
  double stretch;                      ///< R
  double rate;                         ///< dR/dt [1/s]
  double time = 0;                     ///< [s], for the pressure program
  std::optional<double> acceleration;  ///< d2R/dt2 [1/s^2]; by the case's equation of motion when not given
  std::optional<double> pressure;      ///< gauge, at the inlet [Pa]; the program's at `time` when not given
};

/// d2R/dt2 [1/s^2] by a model's equation of motion; a balloon at rest is taken as inflating.
/// @param pressure  gauge, at the inlet [Pa]
[[nodiscard]] double acceleration_of(const Case& c, Model model, const FlowInstant& instant, double pressure);

/// Force of the liquid on the extensional mode [N], p_ext taken as the gauge pressure.
struct FlowForces {
  double exact;        ///< (2.8) with the complete g1...g5 of appendix B, for the snapshot's profile
  double theoretical;  ///< (2.12)
  double corrected;    ///< (2.15)
};

/// One instant of a deflating balloon.
class FlowSnapshot {
 public:
  /// @throws InvalidInput when the balloon does not deflate there, is not larger than its orifice or beyond what its
  ///   material bears, or a value is not finite
  FlowSnapshot(const Case& c, const FlowInstant& instant, OutflowProfile profile = OutflowProfile::uniform());

  [[nodiscard]] const FlowInstant& instant() const { return instant_; }
  /// Inlet pressure: gauge.
  [[nodiscard]] const FlowState<double>& state() const { return state_; }
  /// The equation that gave the acceleration; nothing when it was given.
  [[nodiscard]] std::optional<Model> equation() const { return equation_; }

  [[nodiscard]] const PotentialFlow& flow() const { return *flow_; }
  /// Gauge pressure [Pa] at a point, and in the middle of the orifice's plane by (2.3).
  [[nodiscard]] double pressure(const FlowPoint& point, const FlowField& field) const {
    return pressure_->at(point, field);
  }
  [[nodiscard]] double at_orifice() const { return orifice_pressure(state_); }

  /// Speed in the channel [m/s], negative out of the balloon, (2.1).
  [[nodiscard]] double channel_velocity() const;
  /// Out of the balloon, by the diameter of the orifice.
  [[nodiscard]] double reynolds() const;
  [[nodiscard]] FlowForces forces() const;

 private:
  FlowInstant instant_;
  FlowState<double> state_;
  double viscosity_;
  std::optional<Model> equation_;
  std::unique_ptr<const PotentialFlow> flow_;
  std::unique_ptr<const PressureField> pressure_;  ///< refers to flow_
};

}  // namespace turgor
