#pragma once
// The reduced model's motion against that of an elastic balloon by finite elements, section 2.5 of the paper.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "turgor/closure/closure.hpp"
#include "turgor/run/deviation.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {

/// How a pressure goes; oscillating when it is harmonic.
enum class PressureCourse { rising, holding, falling, oscillating };
/// "rising", "holding", "falling" or "oscillating".
[[nodiscard]] std::string_view name_of(PressureCourse course);

/// A part of a pressure program.
struct PressurePhase {
  PressureCourse course;
  double begin, end;  ///< [s]

  /// "rising, 0 to 2 s"
  [[nodiscard]] std::string name() const;
};

/// The segments of a program up to t_end [s]. Neighbours that go on in the same direction without a jump are one.
[[nodiscard]] std::vector<PressurePhase> pressure_phases(const PressureProgram<double>& program, double t_end);

/// What does not depend on when the balloon is where, over the rows of the finite elements.
struct Landmarks {
  double final;          ///< [m]
  double greatest;       ///< [m]
  double greatest_time;  ///< of the first such row [s]
};

/// The motion by one equation with one closure.
struct ModelResponse {
  Closure closure;
  RunResult run;                       ///< run_motion() under the case's program to t_end
  std::vector<double> radii;           ///< r [m] at the rows of the finite elements, fewer when it ended before
  std::optional<Landmarks> landmarks;  ///< nothing when it ended before

  /// "(2.23) corrected"
  [[nodiscard]] std::string name() const;
};

/// r of each model - r_eff over the rows of a part of the pressure program. A row at the end of a phase belongs to it.
struct PhaseErrors {
  std::optional<PressurePhase> phase;  ///< nothing: the whole run
  std::size_t rows;
  std::vector<std::optional<Deviation>> models;  ///< [m]; nothing where a model ended before
};

/// Elastic energy beyond that of RestEnergy at the same volume: of the balloon's deviation from its shape at rest.
struct ShapeEnergy {
  std::vector<double> rows;  ///< of the finite elements [J]; not negative but for rounding
  double greatest;           ///< [J]
  double time;               ///< of the first such row [s]
  double elastic;            ///< the greatest elastic energy of the run [J]; shares are of it
};

struct ResponseVerification {
  FemResponse fem;
  std::optional<ShapeEnergy> shape;  ///< nothing where the wall has no curve of equilibria that far; a warning says so
  Landmarks landmarks;               ///< of the finite elements
  double stroke;                     ///< greatest - least r_eff [m]; shares are of it
  std::vector<ModelResponse> models;
  std::vector<PhaseErrors> parts;  ///< the whole run, then the phases that have rows
  std::vector<Warning> warnings;
};

/// Runs (2.22), and (2.23) or with a channel (2.25), under the pressure of the case from its initial state, each with
/// the closures (2.12), (2.15), the calibrated one where finite elements stayed in its range of r_ch/r, and the case's
/// own. r is set against r_eff as it is: of a sphere of radius r they differ by (r_ch/r)^4/32.
[[nodiscard]] ResponseVerification verify_response(const Case& c, FemResponse fem);

/// verify.csv: one row per row of the finite elements, units of [output].
[[nodiscard]] std::string verification_csv(const Case& c, const ResponseVerification& verification);
/// verify.json: the run compared with, landmarks, errors by part, equation and closure, warnings.
[[nodiscard]] std::string verification_json(const Case& c, const ResponseVerification& verification);
/// Tables for the screen.
[[nodiscard]] std::string verification_summary(const Case& c, const ResponseVerification& verification);

}  // namespace turgor
