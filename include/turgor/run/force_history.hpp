#pragma once
// The force of the liquid on a balloon whose radius is dictated, section 2.3 of the paper.

#include <optional>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/closure/closure.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// The closures that can say something about a dictated motion: an exact one must know every r_ch/r of it, and
/// Closure::profile is there only if it is the case's own.
/// @throws InvalidInput when the case's own is not among them, or the case has no dictated motion
[[nodiscard]] std::vector<Closure> compared_closures(const Case& c);

/// Generalized forces [N] at one state of a motion.
struct ClosureForces {
  std::vector<double> all;   ///< by each of the compared closures
  ForceParts<double> parts;  ///< of the case's own closure
};

/// Forces at a state of the dictated motion, with the inlet's gauge pressure as p_ext.
/// @param closures  such as compared_closures()
/// @param state     at time `time` [s], which only serves messages
/// @throws InvalidInput when they are not finite numbers
[[nodiscard]] ClosureForces forces_at(const Case& c, const std::vector<Closure>& closures, double time,
                                      const PrescribedMotion<double>::State& state);

/// The greatest force in size, with its sign.
struct ForcePeak {
  double force;  ///< [N]
  double time;   ///< [s]
};

/// What one closure says about a motion from 0 to t_end.
struct ForceSummary {
  Closure closure;
  ForcePeak peak;
  std::optional<ForcePeak> inflating;  ///< of the parts of the motion that inflate; nothing when there are none
  std::optional<ForcePeak> deflating;
  double impulse;  ///< integral of F dt [N s]
  double work;     ///< integral of F dr, work of the liquid on the wall [J]
};

struct ForceHistory {
  std::vector<ForceSummary> closures;  ///< of compared_closures()
  RadiusRange<double> radius;
  std::vector<Warning> warnings;
};

/// Peaks are sought on the motion itself, not on rows, to 1e-8 of a phase; integrals are exact but for
/// rounding.
/// @throws InvalidInput when the case has no dictated motion, or a force is not a finite number
[[nodiscard]] ForceHistory force_history(const Case& c);

/// force.csv: one row per requested time, units of [output], forces in N.
[[nodiscard]] std::string force_csv(const Case& c);
/// force.json: versions, motion, peaks, impulse and work by closure, warnings.
[[nodiscard]] std::string force_json(const Case& c, const ForceHistory& history);
/// A few lines for the screen.
[[nodiscard]] std::string force_summary(const Case& c, const ForceHistory& history);

}  // namespace turgor
