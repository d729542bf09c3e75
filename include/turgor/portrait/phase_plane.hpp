#pragma once
// The plane of R and dR/dT under one constant pressure (section 3.4): every stroke by quadrature, no time stepping.

#include <cmath>
#include <optional>
#include <vector>

#include "turgor/integrate/trajectory.hpp"
#include "turgor/oscillator/oscillator.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

/// A state of the balloon, dimensionless on its oscillator's scales.
struct PhasePoint {
  double stretch;  ///< R
  double rate;     ///< dR/dT
};
using PhaseCurve = std::vector<PhasePoint>;

/// What of the plane is looked at, and how finely curves are drawn: chords are at most 1/60 of the window's width and
/// height long, and the curve is within 1e-4 of them at three places in between.
struct PhaseWindow {
  double least_stretch;
  double greatest_stretch;
  double deflation;  ///< greatest |dR/dT| < 0, written without sign
  double inflation;  ///< greatest dR/dT > 0

  /// Where a rate is drawn, from -1 to 1: by the square root of its share of its side, because rates of slow and fast
  /// motion, small and large balloons differ much.
  [[nodiscard]] double height(double rate) const {
    return rate < 0 ? -std::sqrt(-rate / deflation) : std::sqrt(rate / inflation);
  }
};

/// What becomes of a state in the end.
struct Fate {
  Outcome outcome;   ///< at_rest, runaway, burst or closure_end; max_events: undecided after a million half-cycles
  int well;          ///< counted from 1: unstable equilibria are the walls between wells; 0: comes to rest in none
  double stretch;    ///< the equilibrium, or where the motion leaves what is known
  long half_cycles;  ///< that had to be followed
};

/// Direction of time.
enum class Course : int { backward = -1, forward = 1 };

/// Follows strokes from equilibrium to equilibrium. Between two of them the force aP - E keeps its sign, so that the
/// kinetic energy k = M w, w = (dR/dT)^2, of the quadrature in src/integrate/stroke.hpp has at most one zero, a turning
/// point; its sign at the end tells. That holds for all models, materials and closures.
class PhasePlane {
 public:
  /// @param pressure     gauge [Pa]; the oscillator's own program plays no role
  /// @param max_stretch  stretch at which the wall bursts; 0: never
  /// @throws InvalidInput when the pressure is not finite
  PhasePlane(const Oscillator<double>& oscillator, double pressure, double max_stretch = 0);

  [[nodiscard]] const Oscillator<double>& oscillator() const { return oscillator_; }
  [[nodiscard]] double pressure() const { return pressure_; }  ///< gauge [Pa]
  /// In order of R, those up to the bursting stretch.
  [[nodiscard]] const std::vector<Equilibrium>& equilibria() const { return equilibria_; }
  /// Stretches at which states can be looked at.
  [[nodiscard]] double least_stretch() const { return least_; }
  [[nodiscard]] double greatest_stretch() const { return greatest_; }
  [[nodiscard]] double max_stretch() const { return max_stretch_; }

  /// aP - E, dimensionless.
  [[nodiscard]] double force(double R) const;
  /// The well that a stretch belongs to, counted from 1.
  [[nodiscard]] int well_of(double R) const;

  /// M_+ w + 2 int_1^R E - (2/3) R^3 P: during inflation the first integral of (2.22), (2.23), the latter being (3.22),
  /// and (2.25), each divided by its K. Nothing for exact closures, whose area is not R^2.
  [[nodiscard]] std::optional<double> first_integral(const PhasePoint& at) const;

  /// dR/dT < 0 of slow deflation, the acceleration neglected: w0 = (E - aP)/Q_-, (3.21) for every model. Nothing where
  /// that is negative: slow deflation is forbidden.
  [[nodiscard]] std::optional<double> slow_rate(double R) const;
  /// With the acceleration along that manifold, w = w0 + M_- w0'/(2 Q_-), for (2.23) w0 + w0'/(2 C2 R^2).
  [[nodiscard]] std::optional<double> corrected_slow_rate(double R) const;

  /// Where the motion from a state ends, by chaining half-cycles until a whole one stays in one well without growing.
  /// An unstable equilibrium itself ends at rest in well 0.
  /// @throws InvalidInput when R is not within [least_stretch(), greatest_stretch()] or the rate not within 1e100
  [[nodiscard]] Fate final_well(double R, double rate) const;

  /// The path through a state, in the order of the course: at most `strokes` of them, each up to a zero of the rate.
  /// Ends at stretches beyond which nothing is known, and going backward in deflation, where everything explodes, at
  /// the window's edge; otherwise the window only says how finely to draw.
  /// @param regime  which stroke to take from a state of rest
  /// @throws InvalidInput as final_well()
  [[nodiscard]] PhaseCurve path(const PhasePoint& from, Regime regime, Course course, const PhaseWindow& window,
                                int strokes) const;

  /// The boundaries between basins: what leads into unstable equilibria and what only just reaches the bursting
  /// stretch or the end of the closure; each followed back through at most 64 strokes.
  [[nodiscard]] std::vector<PhaseCurve> separatrices(const PhaseWindow& window) const;

 private:
  void require_state(double R, double rate) const;

  Oscillator<double> oscillator_;
  double pressure_;
  double drive_;  ///< pressure_ in the oscillator's unit
  double max_stretch_;
  double least_;
  double greatest_;
  std::vector<Equilibrium> equilibria_;
};

}  // namespace turgor
