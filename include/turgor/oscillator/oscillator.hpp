#pragma once
// The one concept at the heart of turgor: a hybrid oscillator
//
//     M_s(R) R'' = Q_s(R) R'^2 + a(R) P(T) - E(R),      s = sign of R'
//
// Eqs. (2.22), (2.23) and (2.25) are all of this form and differ only in M_s and Q_s.

#include <string_view>

#include "turgor/base/regime.hpp"
#include "turgor/oscillator/parameters.hpp"

namespace turgor {

/// Fidelity level of the equation of motion.
enum class Model {
  full,          ///< eq. (2.22)
  orifice,       ///< eq. (2.23): no channel, the wall's inertia only during inflation
  long_channel,  ///< eq. (2.25): the channel's inertia rules
};

/// "full", "orifice" or "long-channel".
[[nodiscard]] std::string_view name_of(Model model);
[[nodiscard]] std::string_view name_of(Closure closure);

/// The coefficient functions of the oscillator at one stretch, each with its derivative with respect to R.
template <class T>
struct Coefficients {
  T mass, mass_slope;                ///< M_s
  T centripetal, centripetal_slope;  ///< Q_s
  T area, area_slope;                ///< a
  T elastic, elastic_slope;          ///< E
};

/// Mass and centripetal coefficient of one regime: M = m0 + m4 R^4, Q = q3 R^3 + q6 R^6. All three models have this
/// form.
template <class T>
struct Inertia {
  T m0, m4, q3, q6;

  [[nodiscard]] T mass(const T& r3, const T& R) const { return m0 + m4 * r3 * R; }
  [[nodiscard]] T mass_slope(const T& r3) const { return 4 * m4 * r3; }
  [[nodiscard]] T centripetal(const T& r3) const { return (q3 + q6 * r3) * r3; }
  [[nodiscard]] T centripetal_slope(const T& r2, const T& r3) const { return (3 * q3 + 6 * q6 * r3) * r2; }
};

/// The dimensionless hybrid oscillator of one balloon, on one clock.
template <class T>
class Oscillator {
 public:
  using Scalar = T;

  /// @param parameters  SI units
  /// @param program     gauge pressure [Pa] against time [s]
  Oscillator(Model model, const Parameters<T>& parameters, const PressureProgram<T>& program, const Scales<T>& scales)
      : model_(model),
        parameters_(parameters),
        program_(program.in_units(scales.pressure, scales.time)),
        scales_(scales),
        groups_(groups(parameters, scales)) {
    const Groups<T>& g = groups_;
    const T a0 = g.a0 / g.K;
    const T b = g.b / g.K;
    const T m = g.m / g.K;
    const T n = g.n / g.K;
    switch (model) {
      case Model::full:  // (2.22)
        inflating_ = {a0, b, -2 * b, T(0)};
        deflating_ = {a0, b + m, -2 * b, n};
        break;
      case Model::orifice:  // (2.23)
        inflating_ = {a0, T(0), T(0), T(0)};
        deflating_ = {T(0), m, T(0), n};
        break;
      case Model::long_channel:  // (2.25)
        inflating_ = {T(0), b, -2 * b, T(0)};
        deflating_ = {T(0), b, T(0), n};
        break;
    }
  }

  /// M_s, Q_s, a and E at stretch R > 0 in the given regime (not `rest`).
  [[nodiscard]] Coefficients<T> coefficients(Regime regime, const T& R) const {
    const Inertia<T>& i = inertia(regime);
    const ElasticTerm<T> e = elastic_term(parameters_, scales_, R);
    const T r2 = R * R;
    const T r3 = r2 * R;
    return {i.mass(r3, R), i.mass_slope(r3), i.centripetal(r3), i.centripetal_slope(r2, r3), r2, 2 * R,
            e.value,       e.slope};
  }

  /// M_s and Q_s of a regime (not `rest`).
  [[nodiscard]] const Inertia<T>& inertia(Regime regime) const {
    return regime == Regime::deflating ? deflating_ : inflating_;
  }
  /// E = elastic_factor() dW/dR.
  [[nodiscard]] T elastic_factor() const { return turgor::elastic_factor(parameters_, scales_); }

  /// Force at rest, a(R) P - E(R): its sign chooses the regime in which the balloon leaves a state of rest.
  [[nodiscard]] T force_at_rest(const T& R, const T& P) const {
    return R * R * P - elastic_term(parameters_, scales_, R).value;
  }

  /// Dimensionless strain energy: integral of E from 1 to R.
  [[nodiscard]] T elastic_energy(const T& R) const {
    return strain_energy(parameters_.material, R).value * parameters_.thickness /
           (parameters_.radius * scales_.pressure);
  }

  /// P(T) = (p_ext - p_a)/p_typ against T = t/t_typ.
  [[nodiscard]] const PressureProgram<T>& pressure() const { return program_; }
  [[nodiscard]] Model model() const { return model_; }
  [[nodiscard]] const Parameters<T>& parameters() const { return parameters_; }
  [[nodiscard]] const Scales<T>& scales() const { return scales_; }
  [[nodiscard]] const Groups<T>& dimensionless_groups() const { return groups_; }

 private:
  Model model_;
  Parameters<T> parameters_;
  PressureProgram<T> program_;
  Scales<T> scales_;
  Groups<T> groups_;
  Inertia<T> inflating_{};
  Inertia<T> deflating_{};
};

}  // namespace turgor
