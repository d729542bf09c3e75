#pragma once
// Small motion in one regime, from rest to rest: (3.18), (3.19), and one order more.

#include "turgor/asymptotics/free_motion.hpp"

namespace turgor {

/// Motion in one regime from rest at R_eq + e: R'' = Q/M R'^2 - F/M, by powers of e.
///
/// Inflation: first_order() is (3.18) and, with a channel, second_order() is (3.19). Deflation has the same form, and
/// its second order is the "more precise and simple" approximation near the equilibrium that the paper asks for.
/// Both regimes have an integral: with the factor mu = exp(-2 int Q/M dR) the force mu F/M and the mass mu are those of
/// a conservative oscillator, whose third order in e is classical. The estimated errors rest on the next
/// order; they are sharp while |e| stays well below reach().
class Oscillation {
 public:
  Oscillation(const FreeMotion& motion, Regime regime);

  [[nodiscard]] double frequency() const { return frequency_; }  ///< alpha [1/T]
  /// The amplitude at which the terms of the expansion become equally large.
  [[nodiscard]] double reach() const { return 1 / nonlinearity_; }

  /// R(T) from rest at R_eq + e; T from 0 to about half_period(e). Errors O(e^2), O(e^3) and O(e^4).
  /// @throws InvalidInput for `e` unless |e| <= reach(); for `T` before the start
  [[nodiscard]] Estimate first_order(double e, double T) const;
  [[nodiscard]] Estimate second_order(double e, double T) const;
  [[nodiscard]] Estimate third_order(double e, double T) const;

  /// Time to the next rest, pi/alpha, relative error O(e^2): T_i->d of section 3.3, the same in (3.18) and (3.19).
  [[nodiscard]] Estimate half_period(double e) const;
  /// With the term of order e^2; relative error O(e^3).
  [[nodiscard]] Estimate corrected_half_period(double e) const;

 private:
  void require(double e, double T) const;
  [[nodiscard]] double first(double e, double T) const;
  [[nodiscard]] double second(double e, double T) const;
  [[nodiscard]] double third(double e, double T) const;
  [[nodiscard]] double lengthening() const;  ///< half period = pi/alpha (1 + lengthening e^2)
  [[nodiscard]] double fourth_order_size(double e) const;

  double equilibrium_;
  double frequency_;
  double mass_slope_;      ///< nu = mu'/(2 mu) = -Q/M
  double mass_curvature_;  ///< (sqrt mu)''/sqrt mu
  double quadratic_;       ///< a in s'' + alpha^2 (s + a s^2 + b s^3) = 0, ds = sqrt(mu) dR
  double cubic_;           ///< b
  double nonlinearity_;
};

/// alpha2~ of (3.20b): 5 + R_eq F''/(2 F') at the equilibrium.
[[nodiscard]] double alpha2(const FreeMotion& motion);

}  // namespace turgor
