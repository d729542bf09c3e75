#pragma once
// How free oscillations die out: the analysis of small amplitudes that section 3.3 asks for.

#include "turgor/asymptotics/free_motion.hpp"

namespace turgor {

/// Amplitudes of successive turning points about one equilibrium; all models. Upper ones are R_eq + x, lower ones
/// R_eq - y.
class Decay {
 public:
  explicit Decay(const FreeMotion& motion);

  [[nodiscard]] double beta() const { return beta_; }

  /// How far below the equilibrium a deflation from rest at R_eq + x ends: y = [1 + W0(-z e^-z)]/(2 beta),
  /// z = 1 + 2 beta x. Exact for F linear and beta constant, whatever beta x; the error is the first effect of F'' and
  /// beta'.
  /// @throws InvalidInput for `x` unless x > 0 and finite
  [[nodiscard]] Estimate undershoot(double x) const;
  /// The same with that effect added.
  [[nodiscard]] Estimate corrected_undershoot(double x) const;
  /// 1/(2 beta): where undershoot() goes for beta x >> 1, however far the balloon comes from.
  [[nodiscard]] Estimate greatest_undershoot() const;

  /// Amplitude x after a number of full cycles: x -> 1/(1/first + 4 beta cycles/3), so that in the end
  /// x = 3/(4 beta cycles) whatever the start. The first thousand cycles use undershoot().
  /// @throws InvalidInput for `first` as undershoot(), for `cycles` when negative
  [[nodiscard]] Estimate amplitude(double first, long cycles) const;
  /// Cycles until the amplitude is below a value, by the same law; 0 when it is already.
  [[nodiscard]] double cycles_until(double first, double amplitude) const;
  /// Time of one full cycle of vanishing amplitude, pi/alpha_- + pi/alpha_+ [T].
  [[nodiscard]] double cycle_time() const { return cycle_time_; }

 private:
  [[nodiscard]] double after_cycle_corrected(double x) const;

  double beta_;
  double force_;    ///< f = F''/(4 beta F')
  double damping_;  ///< d = beta'/(2 beta^2)
  double cycle_time_;
};

}  // namespace turgor
