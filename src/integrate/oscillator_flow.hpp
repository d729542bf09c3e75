#pragma once
// The oscillator in one regime under one smooth pressure, as a first-order system for the integrator.

#include <cmath>
#include <limits>

#include "turgor/integrate/rosenbrock.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

template <class T>
class OscillatorFlow {
 public:
  using Scalar = T;
  static constexpr int size = 2;
  using State = Eigen::Matrix<T, 2, 1>;  // (R, dR/dT)

  OscillatorFlow(const Oscillator<T>& oscillator, const SmoothPressure<T>& pressure, Regime regime)
      : oscillator_(oscillator), pressure_(pressure), regime_(regime) {}

  /// (dR/dT, d2R/dT2); not a number where R <= 0, so that a step that goes there is rejected.
  [[nodiscard]] State rate(const T& t, const State& y) const {
    if (!(y[0] > T(0))) return State::Constant(std::numeric_limits<T>::quiet_NaN());
    const Coefficients<T> c = oscillator_.coefficients(regime_, y[0]);
    return {y[1], (c.centripetal * y[1] * y[1] + c.area * pressure_(t) - c.elastic) / c.mass};
  }

  [[nodiscard]] Linearization<T, 2> linearize(const T& t, const State& y) const {
    const Coefficients<T> c = oscillator_.coefficients(regime_, y[0]);
    const T p = pressure_(t);
    const T acceleration = (c.centripetal * y[1] * y[1] + c.area * p - c.elastic) / c.mass;
    Linearization<T, 2> at;
    at.rate = {y[1], acceleration};
    at.jacobian << T(0), T(1),
        (c.centripetal_slope * y[1] * y[1] + c.area_slope * p - c.elastic_slope - c.mass_slope * acceleration) / c.mass,
        2 * c.centripetal * y[1] / c.mass;
    at.time_derivative = {T(0), c.area * pressure_.derivative(1, t) / c.mass};
    return at;
  }

  /// Size of the terms whose difference is the acceleration at rest: what rounding of it is relative to.
  [[nodiscard]] T largest_acceleration(const T& t, const T& R) const {
    const Coefficients<T> c = oscillator_.coefficients(regime_, R);
    return (std::abs(c.elastic) + std::abs(c.area * pressure_(t))) / c.mass;
  }

 private:
  const Oscillator<T>& oscillator_;
  const SmoothPressure<T>& pressure_;
  Regime regime_;
};

}  // namespace turgor
