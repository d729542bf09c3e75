#pragma once
// Free motion under a constant pressure about a stable equilibrium, section 3.3: what all its approximations start
// from.

#include <optional>
#include <vector>

#include "turgor/oscillator/oscillator.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

/// An approximate value and an estimate of its error: an order of magnitude with a reason, not a bound.
struct Estimate {
  double value;
  double error;  ///< >= 0
};

/// F(R) = E(R) - R^2 P, which is zero in equilibrium: everything in section 3.3 follows from it and its derivatives, so
/// that no formula there needs the Mooney-Rivlin solid for which the paper writes it out.
class RestoringForce {
 public:
  /// @param pressure  P, in units of the oscillator's p_typ
  RestoringForce(const Oscillator<double>& oscillator, double pressure);

  [[nodiscard]] double pressure() const { return pressure_; }
  /// F, F' and F'' at R > 0. The third derivative of the strain energy comes from a complex step, to rounding.
  [[nodiscard]] Jet<double> at(double R) const;
  /// F''' at R > 0, from a difference of complex steps, to 1e-7 or so.
  [[nodiscard]] double third(double R) const;

 private:
  [[nodiscard]] double elastic_curvature(double R) const;

  Material<double> material_;
  double factor_;
  double pressure_;
};

/// Deflation by (2.23) or (2.25): R'' = C2 R^2 R'^2 - C1 F/R^4.
struct DeflationConstants {
  double C1;
  double C2;
};

/// The natural times of section 3.2, each regime on its own clock.
struct TimeScales {
  double deflation;  ///< t_- = t_typ sqrt(M_-/F') [s]: on it C1 is (3.6a), C1~ is (3.7)
  double inflation;  ///< t_+ = t_typ sqrt(M_+/F') [s]: on it C3 is (3.6b)
  double C1;         ///< (3.6a) and (3.7): R_eq^4/F'(R_eq), in the units of p_typ
  double C3;         ///< (3.6b): 1/F'(R_eq)
};

/// One stable equilibrium of a balloon under a constant pressure, and the motion about it. Times are in units of the
/// oscillator's t_typ.
class FreeMotion {
 public:
  /// About the stable equilibrium in whose well a stretch lies.
  /// @param pressure  P in units of p_typ; may be negative
  /// @throws InvalidInput for `pressure` unless finite; for `stretch` when the wall cannot have it, or when no stable
  ///         equilibrium holds it, with those that there are
  FreeMotion(const Oscillator<double>& oscillator, double pressure, double stretch);

  [[nodiscard]] Model model() const { return model_; }
  [[nodiscard]] const Scales<double>& scales() const { return scales_; }
  [[nodiscard]] double equilibrium() const { return equilibrium_; }
  /// The well: stretches of the neighbouring unstable equilibria; where there is none, 0 and the stretch at which the
  /// wall locks, or +infinity.
  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] double greatest() const { return greatest_; }
  [[nodiscard]] const RestoringForce& force() const { return force_; }
  [[nodiscard]] const Inertia<double>& inertia(Regime regime) const {
    return regime == Regime::deflating ? deflating_ : inflating_;
  }

  /// sqrt(F'/M_s) at the equilibrium [1/T]: alpha of (3.18), alpha1~ of (3.20a).
  [[nodiscard]] double frequency(Regime regime) const;
  /// beta = (M_-' + 2 Q_-)/(2 M_-) at the equilibrium: the e-folding of kinetic energy per stretch, halved. In (2.23)
  /// and (2.25) it is C2 R_eq^2 + 2/R_eq.
  [[nodiscard]] double beta() const;
  /// (3.6a), (3.6b), (3.7). No T satisfies the first two at once: a trajectory has one clock.
  [[nodiscard]] TimeScales time_scales() const;

  /// C1 and C2, or those with a tilde; nothing for the full model, whose deflation is not of that form.
  [[nodiscard]] const std::optional<DeflationConstants>& deflation() const { return deflation_; }
  /// The same.
  /// @throws InvalidInput for model.name when the model is the full one
  [[nodiscard]] const DeflationConstants& require_deflation() const;

 private:
  void find_well(const std::vector<Equilibrium>& states, double stretch);

  Model model_;
  Scales<double> scales_;
  RestoringForce force_;
  Inertia<double> inflating_;
  Inertia<double> deflating_;
  std::optional<DeflationConstants> deflation_;
  double equilibrium_ = 0;
  double least_ = 0;
  double greatest_ = 0;
};

/// Refuses a stretch from which the balloon does not deflate: outside (R_eq, the well's upper end).
/// @throws InvalidInput for `start`
void require_above_equilibrium(const FreeMotion& motion, double start);

/// Refuses times before the start, and those that are not a number.
/// @throws InvalidInput for `T`
void require_time(double T);

}  // namespace turgor
