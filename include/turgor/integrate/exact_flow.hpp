#pragma once
// The oscillator with an exact closure as a first-order system for the integrator. Its own type, so that the fits'
// right hand side, which is a fraction of the work, stays as short as it is.

#include "turgor/integrate/oscillator_flow.hpp"

namespace turgor {

/// As OscillatorFlow; the factors of the closure are looked up in every lane by itself.
template <class V>
class ExactFlow {
 public:
  using Value = V;
  static constexpr int size = 2;
  using State = Eigen::Matrix<V, 2, 1>;

  ExactFlow(const FlowNumbers<V>& numbers, const Material<V>& material, const ForceTable& table, bool harmonic)
      : numbers_(numbers), material_(material), table_(table), harmonic_(harmonic) {}

  /// (dR/dT, d2R/dT2); not a number where R <= 0 or beyond the table, so that a step that goes there is rejected.
  [[nodiscard]] State rate(const V& t, const State& y) const {
    const V& R = y[0];
    const V& v = y[1];
    const FlowCoefficients<V> c = numbers_.inertia.exact(table_, R);
    const V elastic = numbers_.elastic_factor * strain_energy(material_, R).first;
    const V force = c.centripetal * (v * v) + c.area * numbers_.forcing.value(t, harmonic_) - elastic;
    return {v, select(R > V(0), force / c.mass, V(std::numeric_limits<ScalarOf<V>>::quiet_NaN()))};
  }

  [[nodiscard]] Linearization<V, 2> linearize(const V& t, const State& y) const {
    const V& R = y[0];
    const V& v = y[1];
    const FlowCoefficients<V> c = numbers_.inertia.exact(table_, R);
    const auto energy = strain_energy(material_, R);
    const V p = numbers_.forcing.value(t, harmonic_);
    const V per_mass = V(1) / c.mass;
    const V acceleration = (c.centripetal * v * v + c.area * p - numbers_.elastic_factor * energy.first) * per_mass;
    const V stiffness = c.centripetal_slope * v * v + c.area_slope * p - numbers_.elastic_factor * energy.second -
                        c.mass_slope * acceleration;
    Linearization<V, 2> at;
    at.rate = {v, acceleration};
    at.jacobian << V(0), V(1), stiffness * per_mass, V(2) * c.centripetal * v * per_mass;
    at.time_derivative = {V(0), c.area * numbers_.forcing.slope(t, harmonic_) * per_mass};
    return at;
  }

  /// Spectral radius of the Jacobian.
  [[nodiscard]] V stiffness(const V& t, const State& y) const { return spectral_radius<V>(linearize(t, y).jacobian); }

 private:
  const FlowNumbers<V>& numbers_;
  const Material<V>& material_;
  const ForceTable& table_;
  bool harmonic_;
};

}  // namespace turgor
