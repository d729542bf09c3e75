#pragma once
// The oscillator in one regime under one smooth pressure, as a first-order system for the integrator.

#include "turgor/integrate/step.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

/// One smooth pressure as numbers, so that lanes can differ in theirs: a polynomial plus a sine.
template <class V>
struct Forcing {
  V start;  ///< x = (t - start) per_duration
  V per_duration;
  std::array<V, 6> polynomial;  ///< coefficients of 1, x, ..., x^5
  V amplitude, omega, phase;    ///< amplitude sin(omega t + phase)

  [[nodiscard]] V value(const V& t, bool harmonic) const {
    const std::array<V, 6>& p = polynomial;
    const V x = (t - start) * per_duration;
    const V sum = ((((p[5] * x + p[4]) * x + p[3]) * x + p[2]) * x + p[1]) * x + p[0];
    return harmonic ? sum + amplitude * lane_by_lane(omega * t + phase, [](auto a) { return std::sin(a); }) : sum;
  }
  [[nodiscard]] V slope(const V& t, bool harmonic) const {
    const std::array<V, 6>& p = polynomial;
    const V x = (t - start) * per_duration;
    const V sum = ((((V(5) * p[5] * x + V(4) * p[4]) * x + V(3) * p[3]) * x + V(2) * p[2]) * x + p[1]) * per_duration;
    if (!harmonic) return sum;
    return sum + amplitude * omega * lane_by_lane(omega * t + phase, [](auto a) { return std::cos(a); });
  }
};

/// The same numbers from a pressure.
template <class T>
[[nodiscard]] Forcing<T> forcing(const SmoothPressure<T>& pressure) {
  if (const auto* p = std::get_if<PolynomialPressure<T>>(&pressure.form())) {
    return {p->start, 1 / p->duration, p->coefficients, T(0), T(0), T(0)};
  }
  const auto& h = std::get<HarmonicPressure<T>>(pressure.form());
  return {T(0), T(1), {h.mean}, h.amplitude, 2 * std::numbers::pi_v<T> * h.frequency, h.phase};
}

/// All that the right-hand side needs besides the material; V is a number or a batch of them, one per lane.
template <class V>
struct FlowNumbers {
  Inertia<V> inertia;
  V elastic_factor;  ///< E = elastic_factor dW/dR
  Forcing<V> forcing;
};

template <class T>
[[nodiscard]] FlowNumbers<T> flow_numbers(const Oscillator<T>& oscillator, const SmoothPressure<T>& pressure,
                                          Regime regime) {
  return {oscillator.inertia(regime), oscillator.elastic_factor(), forcing(pressure)};
}

/// Of the Jacobian of a system y = (R, dR/dT), but for a factor of at most sqrt 2 where it oscillates.
template <class V>
[[nodiscard]] V spectral_radius(const Eigen::Matrix<V, 2, 2>& jacobian) {
  using std::abs;
  using std::sqrt;
  const V half = V(ScalarOf<V>(0.5)) * jacobian(1, 1);
  return abs(half) + sqrt(abs(half * half + jacobian(1, 0)));
}

/// y = (R, dR/dT) with the closure's constants; refers to the numbers and the material it is made from.
template <class V, class Solid>
class OscillatorFlow {
 public:
  using Value = V;
  static constexpr int size = 2;
  using State = Eigen::Matrix<V, 2, 1>;

  /// @param harmonic  whether any lane's pressure has a sine
  OscillatorFlow(const FlowNumbers<V>& numbers, const Solid& solid, bool harmonic)
      : numbers_(numbers), solid_(solid), harmonic_(harmonic) {}

  /// (dR/dT, d2R/dT2); not a number where R <= 0, so that a step that goes there is rejected.
  [[nodiscard]] State rate(const V& t, const State& y) const {
    const V& R = y[0];
    const V& v = y[1];
    const V r2 = R * R;
    const V r3 = r2 * R;
    const V driving = numbers_.inertia.centripetal(r3) * (v * v) + r2 * numbers_.forcing.value(t, harmonic_);
    const V mass = numbers_.inertia.mass(r3, R);
    V acceleration;
    if constexpr (requires { solid_.tension(R); }) {
      const auto tension = solid_.tension(R);
      acceleration =
          (driving * tension.denominator - numbers_.elastic_factor * tension.numerator) / (mass * tension.denominator);
    } else {
      acceleration = (driving - numbers_.elastic_factor * solid_.energy(R).first) / mass;
    }
    return {v, select(R > V(0), acceleration, V(std::numeric_limits<ScalarOf<V>>::quiet_NaN()))};
  }

  [[nodiscard]] Linearization<V, 2> linearize(const V& t, const State& y) const {
    const V& R = y[0];
    const V& v = y[1];
    const V r2 = R * R;
    const V r3 = r2 * R;
    const Inertia<V>& inertia = numbers_.inertia;
    const auto energy = solid_.energy(R);
    const V p = numbers_.forcing.value(t, harmonic_);
    const V per_mass = V(1) / inertia.mass(r3, R);
    const V q = inertia.centripetal(r3);
    const V acceleration = (q * v * v + r2 * p - numbers_.elastic_factor * energy.first) * per_mass;
    const V stiffness = inertia.centripetal_slope(r2, r3) * v * v + V(2) * R * p -
                        numbers_.elastic_factor * energy.second - inertia.mass_slope(r3) * acceleration;
    Linearization<V, 2> at;
    at.rate = {v, acceleration};
    at.jacobian << V(0), V(1), stiffness * per_mass, V(2) * q * v * per_mass;
    at.time_derivative = {V(0), r2 * numbers_.forcing.slope(t, harmonic_) * per_mass};
    return at;
  }

  /// Spectral radius of the Jacobian.
  [[nodiscard]] V stiffness(const V& t, const State& y) const { return spectral_radius<V>(linearize(t, y).jacobian); }

 private:
  const FlowNumbers<V>& numbers_;
  const Solid& solid_;
  bool harmonic_;
};

}  // namespace turgor
