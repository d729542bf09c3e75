#include "turgor/run/response_verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parts.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/rest_energy.hpp"

namespace turgor {

namespace {

/// Each piece is monotone, but for harmonics.
PressureCourse course_of(const SmoothPressure<double>& pressure, double begin, double end) {
  if (pressure.is_constant()) return PressureCourse::holding;
  if (std::holds_alternative<HarmonicPressure<double>>(pressure.form())) return PressureCourse::oscillating;
  return pressure(end) > pressure(begin) ? PressureCourse::rising : PressureCourse::falling;
}

std::vector<Closure> closures_for(const Case& c, const StretchRange& range) {
  std::vector<Closure> closures{Closure::theoretical, Closure::corrected};
  Parameters<double> calibrated = c.parameters;
  calibrated.closure = Closure::calibrated;
  if (strained_orifice(calibrated, range).empty()) closures.push_back(Closure::calibrated);
  if (std::ranges::find(closures, c.parameters.closure) == closures.end()) closures.push_back(c.parameters.closure);
  return closures;
}

Landmarks landmarks_of(const std::vector<FemRadius>& rows, const std::vector<double>& radii) {
  const auto greatest = std::ranges::max_element(radii);
  return {radii.back(), *greatest, rows[static_cast<std::size_t>(greatest - radii.begin())].time};
}

ModelResponse respond(const Case& c, Model model, Closure closure, const std::vector<FemRadius>& rows) {
  Case question = c;
  question.model = model;
  question.parameters.closure = closure;
  question.solve.max_events = 0;  // a limit for runs; finite elements go on
  ModelResponse response{closure, run_motion(question), {}, {}};
  const Trajectory<double>& trajectory = *response.run.trajectory;
  const Scales<double>& scales = response.run.oscillator->scales();
  const double end =
      is_complete(trajectory.outcome) ? std::numeric_limits<double>::infinity() : trajectory.last.time * scales.time;
  for (const FemRadius& row : rows) {
    if (row.time > end) break;
    response.radii.push_back(trajectory.at(row.time / scales.time).stretch * scales.length);
  }
  if (response.radii.size() == rows.size()) response.landmarks = landmarks_of(rows, response.radii);
  return response;
}

/// Errors over rows first to last, the latter not included.
PhaseErrors errors_over(const std::vector<FemRadius>& rows, const std::vector<ModelResponse>& models, std::size_t first,
                        std::size_t last) {
  PhaseErrors errors{{}, last - first, {}};
  for (const ModelResponse& model : models) {
    std::vector<Difference> differences;
    for (std::size_t i = first; i < std::min(last, model.radii.size()); ++i) {
      differences.push_back({rows[i].time, model.radii[i] - rows[i].radius});
    }
    errors.models.push_back(differences.size() < errors.rows ? std::nullopt : std::optional(deviation_of(differences)));
  }
  return errors;
}

std::vector<PhaseErrors> errors_by_phase(const Case& c, const std::vector<FemRadius>& rows,
                                         const std::vector<ModelResponse>& models) {
  const double rounding = 1e-12 * c.solve.t_end;  // of times in other units
  std::vector<PhaseErrors> parts{errors_over(rows, models, 0, rows.size())};
  std::size_t first = 0;
  const std::vector<PressurePhase> phases = pressure_phases(c.pressure, c.solve.t_end);
  for (const PressurePhase& phase : phases) {
    std::size_t last = first;
    while (last < rows.size() && (&phase == &phases.back() || rows[last].time <= phase.end + rounding)) ++last;
    if (last > first) {
      parts.push_back(errors_over(rows, models, first, last));
      parts.back().phase = phase;
    }
    first = last;
  }
  return parts;
}

std::optional<ShapeEnergy> shape_energy(const Case& c, const std::vector<FemRadius>& rows,
                                        std::vector<Warning>& warnings) {
  ShapeEnergy shape{{}, 0, 0, std::ranges::max(rows, {}, &FemRadius::elastic).elastic};
  try {
    const RestEnergy rest(c, std::ranges::max(rows, {}, &FemRadius::volume).volume);
    for (const FemRadius& row : rows) shape.rows.push_back(row.elastic - rest(row.volume));
  } catch (const ComputationFailed& failure) {
    warnings.push_back({"no-shape-energy", std::string("no energy of the shape: ") + failure.what()});
    return std::nullopt;
  }
  const auto greatest = std::ranges::max_element(shape.rows);
  shape.greatest = *greatest;
  shape.time = rows[static_cast<std::size_t>(greatest - shape.rows.begin())].time;
  return shape;
}

void warn_of_ended(const ModelResponse& model, std::size_t rows, std::vector<Warning>& warnings) {
  if (model.radii.size() == rows) return;
  warnings.push_back({"model-ended", model.name() + " has values at " + std::to_string(model.radii.size()) + " of " +
                                         std::to_string(rows) + " rows: " + model.run.trajectory->message});
}

}  // namespace

std::string_view name_of(PressureCourse course) {
  switch (course) {
    case PressureCourse::rising: return "rising";
    case PressureCourse::holding: return "holding";
    case PressureCourse::falling: return "falling";
    case PressureCourse::oscillating: return "oscillating";
  }
  return "";
}

std::string PressurePhase::name() const {
  return std::string(name_of(course)) + ", " + rounded(begin) + " to " + rounded(end) + " s";
}

std::string ModelResponse::name() const {
  return std::string(equation_of(run.oscillator->model())) + " " + std::string(name_of(closure));
}

std::vector<PressurePhase> pressure_phases(const PressureProgram<double>& program, double t_end) {
  std::vector<PressurePhase> phases;
  double before = 0;  // pressure at the end of the last phase
  for (double begin = 0; begin < t_end;) {
    const double end = std::min(program.next_knot(begin), t_end);
    const SmoothPressure<double>& pressure = program.after(begin);
    const PressureCourse course = course_of(pressure, begin, end);
    const double rounding = 1e-9 * std::max(std::abs(before), std::abs(pressure(end)));
    const bool jumps = std::abs(pressure(begin) - before) > rounding;
    if (!phases.empty() && phases.back().course == course && !jumps) {
      phases.back().end = end;
    } else {
      phases.push_back({course, begin, end});
    }
    before = pressure(end);
    begin = end;
  }
  return phases;
}

ResponseVerification verify_response(const Case& c, FemResponse fem) {
  std::vector<double> radii;
  radii.reserve(fem.rows.size());
  for (const FemRadius& row : fem.rows) radii.push_back(row.radius);
  const auto [least, greatest] = std::ranges::minmax(radii);
  const StretchRange range{least / c.parameters.radius, greatest / c.parameters.radius};

  std::vector<ModelResponse> models;
  std::vector<Warning> warnings = fem.warnings;
  for (const Model model : {Model::full, c.parameters.channel_length > 0 ? Model::long_channel : Model::orifice}) {
    for (const Closure closure : closures_for(c, range)) {
      models.push_back(respond(c, model, closure, fem.rows));
      warn_of_ended(models.back(), fem.rows.size(), warnings);
    }
  }
  for (Warning& warning : strained_orifice(c.parameters, range)) warnings.push_back(std::move(warning));
  const Landmarks landmarks = landmarks_of(fem.rows, radii);
  std::vector<PhaseErrors> parts = errors_by_phase(c, fem.rows, models);
  std::optional<ShapeEnergy> shape = shape_energy(c, fem.rows, warnings);
  return {std::move(fem),    std::move(shape), landmarks,          greatest - least,
          std::move(models), std::move(parts), std::move(warnings)};
}

}  // namespace turgor
