#pragma once
// The balloon in SI units, and the scales that make it dimensionless.

#include <memory>

#include "turgor/closure/closure.hpp"
#include "turgor/material/material.hpp"
#include "turgor/pressure/program.hpp"

namespace turgor {

/// Everything that eq. (2.22) needs to know about one balloon, in SI units.
template <class T>
struct Parameters {
  T radius;           ///< unstretched radius r0 [m]
  T thickness;        ///< unstretched wall thickness d0 [m]
  T solid_density;    ///< rho_s [kg/m^3]
  T fluid_density;    ///< rho_f [kg/m^3]
  T fluid_viscosity;  ///< mu_f [Pa s]; the model is inviscid, this only serves to judge that
  T orifice_radius;   ///< r_ch [m]
  T channel_length;   ///< L_ch [m]; 0 without a channel
  Material<T> material;
  Closure closure = Closure::corrected;
  std::shared_ptr<const ForceTable> outflow{};  ///< of Closure::profile; empty for the others
};

/// kappa = r_ch/r at stretch R.
template <class T>
[[nodiscard]] T kappa_at(const Parameters<T>& p, const T& stretch) {
  return p.orifice_radius / p.radius / stretch;
}

/// Stretches between which the closure holds: those of ForceTable, r_ch/(0.75 r0) and 2^17 r_ch/r0, when it is exact.
template <class T>
struct StretchLimits {
  T least;
  T greatest;
};
template <class T>
[[nodiscard]] StretchLimits<T> closure_limits(const Parameters<T>& p) {
  if (!has_table(p.closure)) return {T(0), std::numeric_limits<T>::infinity()};
  return {kappa_at(p, T(ForceTable::greatest_kappa)), kappa_at(p, T(ForceTable::least_kappa))};
}

/// The table of the balloon's closure: a null pointer for the fits.
/// @throws InvalidInput for Closure::profile without an outflow, and when the closure does not hold at R = 1, where
/// scales are made
template <class T>
[[nodiscard]] const ForceTable* force_table(const Parameters<T>& p);

/// Refuses a start at a stretch beyond closure_limits().
/// @throws InvalidInput for initial.stretch
template <class T>
void require_closure(const Parameters<T>& p, const T& stretch);

/// h1 ... h5 at a stretch; for the fits 1 with slopes 0.
/// @param table  force_table(p)
template <class T>
[[nodiscard]] ExactFactors<T> closure_factors(const Parameters<T>& p, const ForceTable* table, const T& stretch) {
  if (table == nullptr) return {{T(1), T(0), T(1), T(0), T(1), T(0)}, {T(1), T(0), T(1), T(0)}};
  const T kappa = kappa_at(p, stretch);
  return {channel_factors(kappa), table->at(kappa)};
}

/// Scales of eq. (2.21). One clock for both regimes: eqs. (3.6a) and (3.6b) name two different ones, and a trajectory
/// that switches regime can only be written on one.
template <class T>
struct Scales {
  T length;    ///< r0 [m]
  T pressure;  ///< p_typ [Pa]
  T time;      ///< t_typ [s]

  /// Energy [J] of one unit of the dimensionless energy: the work of p_typ on 4 pi r0^3.
  [[nodiscard]] T energy() const { return 4 * std::numbers::pi_v<T> * length * length * length * pressure; }
};

/// Dimensionless groups of (2.22), (2.24) and (2.26); see docs/theory.md, section 2.4. With an exact closure m and n
/// are not constant: here, and in all that follows from them, they are those at R = 1.
template <class T>
struct Groups {
  T a0;       ///< (rho_s/rho_f) r_ch d0/r0^2, solid inertia in (2.22)
  T b;        ///< 2 L_ch/r_ch, channel inertia in (2.22)
  T m;        ///< balloon liquid's inertia during deflation in (2.22)
  T n;        ///< balloon liquid's centripetal coefficient during deflation in (2.22)
  T K;        ///< r_ch t_typ^2 p_typ/(2 rho_f r0^3), stiffness prefactor in (2.22)
  T C1;       ///< (2.24a)
  T C2;       ///< (2.24b)
  T C3;       ///< (2.24c)
  T C1_long;  ///< (2.26a); +infinity without a channel
  T C2_long;  ///< (2.26b); +infinity without a channel
};

template <class T>
[[nodiscard]] Groups<T> groups(const Parameters<T>& p, const Scales<T>& scales) {
  const ClosureConstants<T> closure = constants<T>(p.closure);
  const ForceFactors<T> liquid = closure_factors(p, force_table(p), T(1)).liquid;
  const T slenderness = p.radius / p.orifice_radius;
  Groups<T> g{};
  g.a0 = p.solid_density / p.fluid_density * p.orifice_radius * p.thickness / (p.radius * p.radius);
  g.b = 2 * p.channel_length / p.orifice_radius;
  g.m = closure.inertial * liquid.inertial;
  g.n = closure.centripetal * power<3>(slenderness) * liquid.centripetal;
  g.K = p.orifice_radius * scales.time * scales.time * scales.pressure / (2 * p.fluid_density * power<3>(p.radius));
  g.C1 = g.K / g.m;
  g.C2 = g.n / g.m;
  g.C3 = g.K / g.a0;
  const T infinite = std::numeric_limits<T>::infinity();
  g.C1_long = g.b > 0 ? g.K / g.b : infinite;
  g.C2_long = g.b > 0 ? g.n / g.b : infinite;
  return g;
}

/// Elastic restoring term E of the oscillator in units of p_typ: d0 W'(R)/(r0 p_typ), with dE/dR.
/// For Mooney-Rivlin it is S1 (R - R^-5) + S2 (R^3 - R^-3).
template <class T>
struct ElasticTerm {
  T value;
  T slope;
};
template <class T>
[[nodiscard]] T elastic_factor(const Parameters<T>& p, const Scales<T>& scales) {
  return p.thickness / (p.radius * scales.pressure);
}
template <class T>
[[nodiscard]] ElasticTerm<T> elastic_term(const Parameters<T>& p, const Scales<T>& scales, const T& stretch) {
  const Jet<T> w = strain_energy(p.material, stretch);
  const T factor = elastic_factor(p, scales);
  return {factor * w.first, factor * w.second};
}

/// Scales chosen when none are given: the greatest gauge pressure of the program up to t_end (or the wall's own
/// d0 W''(1)/r0 when there is none), and the inverse of the deflating balloon's natural frequency about R = 1, which is
/// stable for every material.
[[nodiscard]] Scales<double> natural_scales(const Parameters<double>& p, const PressureProgram<double>& program,
                                            double t_end);

extern template const ForceTable* force_table(const Parameters<double>&);
extern template const ForceTable* force_table(const Parameters<long double>&);
extern template void require_closure(const Parameters<double>&, const double&);
extern template void require_closure(const Parameters<long double>&, const long double&);

}  // namespace turgor
