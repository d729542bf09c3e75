#pragma once
// The one concept at the heart of turgor: a hybrid oscillator
//
//     M_s(R) R'' = Q_s(R) R'^2 + a(R) P(T) - E(R),      s = sign of R'
//
// Eqs. (2.22), (2.23) and (2.25) are all of this form and differ only in M_s and Q_s; closures in these and in a.

#include <string_view>

#include "turgor/base/lanes.hpp"
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
/// "(2.22)", "(2.23)" or "(2.25)".
[[nodiscard]] std::string_view equation_of(Model model);
[[nodiscard]] std::string_view name_of(Closure closure);

/// The coefficient functions of the oscillator at one stretch, each with its derivative with respect to R.
template <class T>
struct Coefficients {
  T mass, mass_slope;                ///< M_s
  T centripetal, centripetal_slope;  ///< Q_s
  T area, area_slope;                ///< a
  T elastic, elastic_slope;          ///< E
};

/// Those of them that the closure decides on.
template <class T>
struct FlowCoefficients {
  T mass, mass_slope;
  T centripetal, centripetal_slope;
  T area, area_slope;
};

/// Mass and centripetal coefficient of one regime: M = m0 + m4 R^4, Q = q3 R^3 + q6 R^6. All three models have this
/// form. With an exact closure the factors h1 ... h5 multiply its terms, see exact().
template <class T>
struct Inertia {
  T m0, m4, q3, q6;
  T liquid;  ///< what m4 has from the liquid in the balloon; the rest is the channel's
  T kappa;   ///< r_ch/r0

  [[nodiscard]] T mass(const T& r3, const T& R) const { return m0 + m4 * r3 * R; }
  [[nodiscard]] T mass_slope(const T& r3) const { return 4 * m4 * r3; }
  [[nodiscard]] T centripetal(const T& r3) const { return (q3 + q6 * r3) * r3; }
  [[nodiscard]] T centripetal_slope(const T& r2, const T& r3) const { return (3 * q3 + 6 * q6 * r3) * r2; }

  /// M = m0 + ((m4 - liquid) h2 + liquid h3) R^4, Q = q3 h4 R^3 + q6 h5 R^6 and a = h1 R^2, the factors taken at
  /// kappa/R. While the balloon deflates, not a number where the table ends. Not inlined, so that the fits beside it
  /// stay as fast as they are without it.
  [[nodiscard, gnu::noinline]] FlowCoefficients<T> exact(const ForceTable& table, const T& R) const {
    const T here = kappa / R;
    const T turn = -here / R;  // d(kappa/R)/dR
    const ChannelFactors<T> c = channel_factors(here);
    const ForceFactors<T> l = liquid_factors(table, here);
    const T r2 = R * R;
    const T r3 = r2 * R;
    const T channel = m4 - liquid;
    const T inertial = channel * c.inertial + liquid * l.inertial;
    const T inertial_slope = (channel * c.inertial_slope + liquid * l.inertial_slope) * turn;
    const T through = q3 * c.centripetal;
    const T within = q6 * l.centripetal * r3;
    const T centripetal_turn = (q3 * c.centripetal_slope + q6 * l.centripetal_slope * r3) * turn;
    return {m0 + inertial * r3 * R,
            (T(4) * inertial + inertial_slope * R) * r3,
            (through + within) * r3,
            (T(3) * through + T(6) * within) * r2 + centripetal_turn * r3,
            c.area * r2,
            (T(2) * c.area + c.area_slope * turn * R) * R};
  }

 private:
  /// h3 and h5 in the lanes that have use for them.
  [[nodiscard]] ForceFactors<T> liquid_factors(const ForceTable& table, const T& here) const {
    ForceFactors<T> all{T(0), T(0), T(0), T(0)};
    for (int l = 0; l < Lanes<T>::width; ++l) {
      if (lane(q6, l) == 0) continue;
      const ForceFactors<ScalarOf<T>> one = table.at(lane(here, l));
      lane(all.inertial, l) = one.inertial;
      lane(all.inertial_slope, l) = one.inertial_slope;
      lane(all.centripetal, l) = one.centripetal;
      lane(all.centripetal_slope, l) = one.centripetal_slope;
    }
    return all;
  }
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
        groups_(groups(parameters, scales)),
        table_(turgor::force_table(parameters_)) {
    const Groups<T>& g = groups_;
    const ClosureConstants<T> closure = constants<T>(parameters.closure);
    const T kappa = parameters.orifice_radius / parameters.radius;
    const T a0 = g.a0 / g.K;
    const T b = g.b / g.K;
    const T m = closure.inertial / g.K;
    const T n = closure.centripetal * power<3>(parameters.radius / parameters.orifice_radius) / g.K;
    const T none(0);
    switch (model) {
      case Model::full:  // (2.22)
        inflating_ = {a0, b, -2 * b, none, none, kappa};
        deflating_ = {a0, b + m, -2 * b, n, m, kappa};
        break;
      case Model::orifice:  // (2.23)
        inflating_ = {a0, none, none, none, none, kappa};
        deflating_ = {none, m, none, n, m, kappa};
        break;
      case Model::long_channel:  // (2.25)
        inflating_ = {none, b, -2 * b, none, none, kappa};
        deflating_ = {none, b, none, n, none, kappa};
        break;
    }
  }

  /// M_s, Q_s, a and E at stretch R > 0 in the given regime (not `rest`). With an exact closure, in deflation, not a
  /// number beyond closure_limits().
  [[nodiscard]] Coefficients<T> coefficients(Regime regime, const T& R) const {
    const ElasticTerm<T> e = elastic_term(parameters_, scales_, R);
    const FlowCoefficients<T> f = flow_coefficients(regime, R);
    return {f.mass, f.mass_slope, f.centripetal, f.centripetal_slope, f.area, f.area_slope, e.value, e.slope};
  }
  /// The same without E.
  [[nodiscard]] FlowCoefficients<T> flow_coefficients(Regime regime, const T& R) const {
    const Inertia<T>& i = inertia(regime);
    if (table_ != nullptr) [[unlikely]]
      return i.exact(*table_, R);
    const T r2 = R * R;
    const T r3 = r2 * R;
    return {i.mass(r3, R), i.mass_slope(r3), i.centripetal(r3), i.centripetal_slope(r2, r3), r2, 2 * R};
  }

  /// Of a regime (not `rest`).
  [[nodiscard]] const Inertia<T>& inertia(Regime regime) const {
    return regime == Regime::deflating ? deflating_ : inflating_;
  }
  /// Of an exact closure; a null pointer for the fits.
  [[nodiscard]] const ForceTable* force_table() const { return table_; }
  /// Whether M_s' + 2 Q_s is zero at all stretches: the inlet's work is the only change of energy.
  [[nodiscard]] bool conserves_energy(Regime regime) const {
    return regime != Regime::deflating && (table_ == nullptr || inertia(regime).m4 == T(0));
  }
  /// E = elastic_factor() dW/dR.
  [[nodiscard]] T elastic_factor() const { return turgor::elastic_factor(parameters_, scales_); }

  /// a(R).
  [[nodiscard]] T area(const T& R) const {
    const T square = R * R;
    return table_ == nullptr ? square : channel_factors(inflating_.kappa / R).area * square;
  }

  /// Force at rest, a(R) P - E(R): its sign chooses the regime in which the balloon leaves a state of rest.
  [[nodiscard]] T force_at_rest(const T& R, const T& P) const {
    return area(R) * P - elastic_term(parameters_, scales_, R).value;
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
  const ForceTable* table_;  ///< parameters_ keeps it alive
  Inertia<T> inflating_{};
  Inertia<T> deflating_{};
};

}  // namespace turgor
