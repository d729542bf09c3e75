#pragma once
// The phase portrait of a case, as text and files; rates in 1/s.

#include <optional>
#include <string>

#include "turgor/case/case.hpp"
#include "turgor/portrait/portrait.hpp"

namespace turgor {

/// What is asked of a case.
struct PortraitQuestion {
  std::optional<double> pressure;  ///< gauge [Pa]; otherwise the case's at solve.t_end
  WindowWishes window;             ///< rates in 1/s
};

struct PortraitStudy {
  bool model_chosen;  ///< automatically, over the stretches of the window
  PhasePlane plane;
  Portrait portrait;

  /// What a dimensionless rate is multiplied with to be in 1/s.
  [[nodiscard]] double per_second() const { return 1 / plane.oscillator().scales().time; }
};

/// @throws InvalidInput when the case dictates the motion, when the window is out of range, and when the pressure has
/// no equilibrium: too high for a wall that locks, or too low for any wall to hold. With a wall that yields to every
/// pressure there may be none; then everything runs away and that is drawn.
[[nodiscard]] PortraitStudy study_portrait(const Case& c, const PortraitQuestion& question);

/// All curves. Columns: curve (counted from 1), kind, R [1], dR/dt [1/s].
[[nodiscard]] std::string portrait_csv(const PortraitStudy& study);
/// Model, pressure, equilibria, fates of balloons at rest, window, forbidden intervals, and the list of curves.
[[nodiscard]] std::string portrait_json(const Case& c, const PortraitStudy& study);
/// A few lines for the screen.
[[nodiscard]] std::string portrait_text(const Case& c, const PortraitStudy& study);

}  // namespace turgor
