#include "turgor/run/flow_snapshot.hpp"

#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/force_coefficients.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

double acceleration_of(const Case& c, Model model, const FlowInstant& instant, double pressure) {
  const Regime regime = instant.rate < 0 ? Regime::deflating : Regime::inflating;
  const Oscillator<double> oscillator = make_oscillator(c, model);
  const Scales<double>& scales = oscillator.scales();
  const auto k = oscillator.coefficients(regime, instant.stretch);
  const double rate = instant.rate * scales.time;
  const double force = k.centripetal * rate * rate + k.area * pressure / scales.pressure - k.elastic;
  return force / k.mass / (scales.time * scales.time);
}

namespace {

constexpr double flow_tolerance = 1e-10;

void check_stretch(const Case& c, double stretch) {
  const Parameters<double>& p = c.parameters;
  const double least = p.orifice_radius / p.radius;
  if (!(stretch > least)) {
    throw InvalidInput("stretch", shortest(stretch), "the balloon is not larger than its orifice",
                       "must be more than orifice_radius/radius = " + shortest(least));
  }
  if (stretch > largest_stretch) {
    throw InvalidInput("stretch", shortest(stretch), "out of range", "allowed is up to " + shortest(largest_stretch));
  }
  if (!c.motion && !std::isfinite(strain_energy(p.material, stretch).first)) {
    throw InvalidInput("stretch", shortest(stretch), "beyond the stretch at which the material locks",
                       "this one locks at " + rounded(stretch_limit(p.material), 6) + ", and in compression likewise");
  }
}

FlowState<double> state_of(const Parameters<double>& p, const FlowInstant& instant) {
  return {p.radius * instant.stretch,
          p.radius * instant.rate,
          p.radius * instant.acceleration.value(),
          instant.pressure.value(),
          p.orifice_radius,
          p.channel_length,
          p.fluid_density};
}

InvalidInput no_potential_flow(const Parameters<double>& p, const FlowInstant& instant) {
  const std::string pressure = rounded(orifice_pressure(state_of(p, instant)), 6) + " Pa by (2.3)";
  if (instant.rate == 0) {
    return InvalidInput("rate", "0", "nothing flows: there is no velocity to show",
                        "the gauge pressure at the orifice is " + pressure + "; give a negative rate, for deflation");
  }
  return InvalidInput("rate", shortest(instant.rate) + " 1/s",
                      "the balloon inflates: a jet enters it, and there is no potential flow",
                      "its gauge pressure is uniform, " + pressure + "; give a negative rate, for deflation");
}

}  // namespace

FlowSnapshot::FlowSnapshot(const Case& c, const FlowInstant& instant, OutflowProfile profile)
    : instant_(instant), viscosity_(c.parameters.fluid_viscosity) {
  const Parameters<double>& p = c.parameters;
  check_stretch(c, instant.stretch);
  if (!std::isfinite(instant.rate)) throw InvalidInput("rate", shortest(instant.rate), "is not a finite number");
  if (!instant_.pressure) instant_.pressure = c.pressure(instant.time);
  if (!instant_.acceleration) {
    if (c.motion) {
      throw InvalidInput("acceleration", "", "the case dictates the radius, so that no equation of motion gives it",
                         "add acceleration=d2R/dt2 to --at");
    }
    equation_ = c.model.value_or(Model::full);
    instant_.acceleration = acceleration_of(c, *equation_, instant, *instant_.pressure);
  }
  state_ = state_of(p, instant_);
  if (!std::isfinite(at_orifice())) {
    throw InvalidInput("rate", shortest(instant.rate) + " 1/s", "the pressure is too large for a number");
  }
  if (instant.rate >= 0) throw no_potential_flow(p, instant_);
  flow_ = std::make_unique<const PotentialFlow>(p.orifice_radius / state_.radius, std::move(profile), flow_tolerance);
  pressure_ = std::make_unique<const PressureField>(*flow_, state_);
}

double FlowSnapshot::channel_velocity() const { return channel_speed(flow_->eps()) * state_.radial_rate; }

double FlowSnapshot::reynolds() const {
  return state_.fluid_density * std::abs(channel_velocity()) * 2 * state_.orifice_radius / viscosity_;
}

FlowForces FlowSnapshot::forces() const {
  const FlowState<double>& s = state_;
  const ForceCoefficients g = force_coefficients(*flow_);
  const double r2 = s.radius * s.radius;
  const double exact =
      g.g1 * r2 * s.inlet_pressure -
      s.fluid_density * (s.channel_length * g.g2 + g.g3 * s.radius) * r2 * s.radial_accel +
      s.fluid_density * (s.channel_length * g.g4 + g.g5 * s.radius) * s.radius * s.radial_rate * s.radial_rate;
  return {exact, generalized_force(Closure::theoretical, Regime::deflating, s),
          generalized_force(Closure::corrected, Regime::deflating, s)};
}

}  // namespace turgor
