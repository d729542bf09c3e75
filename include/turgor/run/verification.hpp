#pragma once
// The reduced model's force against that of finite elements, section 2.3 of the paper.

#include <optional>
#include <string>
#include <vector>

#include "turgor/closure/closure.hpp"
#include "turgor/run/deviation.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {

/// How the speed |dr/dt| goes in a phase of a motion.
enum class MotionCourse { accelerating, constant, decelerating };

/// Phases of a motion whose errors are looked at together.
struct MotionPart {
  Regime regime;
  std::optional<MotionCourse> course;  ///< nothing: all of them

  /// "inflating", "deflating, constant velocity", ...
  [[nodiscard]] std::string name() const;
};

/// A row of the finite elements beside the model. One at the end of a phase belongs to it: where the acceleration
/// jumps, steps have come from before.
struct VerifiedRow {
  PrescribedMotion<double>::State state;
  MotionCourse course;
  FemForces fem;
  std::vector<double> models;  ///< generalized force by each closure [N]
};

/// Errors over the rows of a part of the motion.
struct PartErrors {
  MotionPart part;
  std::size_t rows;
  double rms;                       ///< of the finite elements' force [N]
  bool relative_to_deflation;       ///< since rms is less than a tenth of that of the whole deflation
  double reference;                 ///< rms, or that of the deflation [N]; errors are relative to it
  std::vector<Deviation> closures;  ///< of each [N]
};

/// model/finite elements - 1 over the rows of deflation at constant velocity.
struct ForceRatio {
  double mean, least, greatest;
};

/// Errors against one of the two forces that finite elements give.
struct ForceComparison {
  std::vector<PartErrors> parts;           ///< those that have rows
  std::vector<ForceRatio> even_deflation;  ///< of each closure; empty without such rows, or where a force is 0
};

struct Verification {
  FemHistory fem;
  std::vector<Closure> closures;  ///< compared_closures()
  std::vector<VerifiedRow> rows;
  ForceComparison mode;   ///< against FemForces::force_mode
  ForceComparison whole;  ///< against FemForces::force
  std::vector<Warning> warnings;
};

/// @throws InvalidInput as read_fem_history() and force_history()
[[nodiscard]] Verification verify(const Case& c, FemHistory fem);

/// verify.csv: one row per row of the finite elements, units of [output], forces in N.
[[nodiscard]] std::string verification_csv(const Case& c, const Verification& verification);
/// verify.json: the run compared with, errors by force, part and closure, warnings.
[[nodiscard]] std::string verification_json(const Case& c, const Verification& verification);
/// Tables for the screen.
[[nodiscard]] std::string verification_summary(const Case& c, const Verification& verification);

}  // namespace turgor
