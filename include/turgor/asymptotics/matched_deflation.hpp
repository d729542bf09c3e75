#pragma once
// The paper's matched asymptotic expansion of deflation from rest: (3.9) to (3.17).

#include "turgor/asymptotics/slow_deflation.hpp"

namespace turgor {

/// Constants of (3.13) and (3.10c) at the start R_i. With g = C1 F/R^4 and u = g/R^2, so that sqrt(u/C2) is the slow
/// rate (3.21): gamma1 = g, gamma2 = -R g' - 2 g, gamma3 = u''/2, hence 4 gamma1 + gamma2 = -R^3 u'.
struct Gammas {
  double first;
  double second;
  double third;
};
/// @throws InvalidInput for model.name when the model is the full one
[[nodiscard]] Gammas gammas(const FreeMotion& motion, double start);

/// Li2(-e^(-2x)) for x >= 0, the dilogarithm of (3.12) and (3.16); relative error below 1e-15.
[[nodiscard]] double dilogarithm_of_layer(double x);

/// Deflation by (2.23) or (2.25) from rest at R_i, by powers of delta = 1/C2. Times T are those since the start, tau =
/// T/sqrt(delta).
///
/// Every function is defined for all T >= 0. Each error is the difference from the refined SlowDeflation: it
/// grows from O(delta^3) at fixed tau to O(delta^2) at fixed T and O(1) for T ~ 1/sqrt(delta), because for large T the
/// paper's solution is the cubic Taylor polynomial of the slow motion. Valid up to about a third of transition_time().
class MatchedDeflation {
 public:
  /// @throws InvalidInput as SlowDeflation
  MatchedDeflation(const FreeMotion& motion, double start);

  [[nodiscard]] const Gammas& constants() const { return gammas_; }
  [[nodiscard]] double delta() const { return delta_; }
  [[nodiscard]] Estimate outer(double T) const;      ///< (3.9) with (3.15)
  [[nodiscard]] Estimate inner(double T) const;      ///< (3.12), its brace without overflow
  [[nodiscard]] Estimate composite(double T) const;  ///< (3.16), likewise
  /// (3.17), in a form that also holds for gamma3 = 0.
  /// @throws InvalidInput for `start` when 4 gamma1 + gamma2 >= 0, where the slow motion does not slow down, and when
  /// the
  ///         square root is complex
  [[nodiscard]] Estimate transition_time() const;

  /// What the errors are measured by.
  [[nodiscard]] const SlowDeflation& uniform() const { return uniform_; }

 private:
  [[nodiscard]] Estimate judged(double value, double T) const;

  SlowDeflation uniform_;
  double start_;
  double delta_;
  Gammas gammas_;
};

}  // namespace turgor
