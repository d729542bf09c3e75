#include "turgor/fem/step_control.hpp"

#include <algorithm>
#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr double growth = 1.25;          ///< of one step over the last
constexpr double steps_per_phase = 40;   ///< at least, so that a program is followed where nothing flows
constexpr double first_step_part = 0.1;  ///< of the step that would be taken otherwise
constexpr int many_iterations = 4;       ///< of Newton's method: shorter steps are cheaper
constexpr int most_halvings = 10;

double last_step(const FlowSolver& solver) {
  const auto& levels = solver.levels();
  return levels.back().time - levels[levels.size() - 2].time;
}

}  // namespace

double speed_on_axis(const FlowSolver& solver) {
  const FlowSpace& space = solver.space();
  double speed = 0;
  for (const int node : space.nodes_on(Side::axis)) {
    speed = std::max(speed, std::abs(solver.solution()[static_cast<std::size_t>(space.velocity(node, 1))]));
  }
  return speed;
}

FlowControls controls_of(const FemSettings& settings) {
  FlowControls controls;
  controls.scheme = settings.scheme;
  controls.update_tolerance = settings.tolerance;
  constexpr double solved = 10;  // over the local error: what Newton's method leaves must not be taken for it
  if (settings.error_tolerance > 0) {
    controls.update_tolerance = std::min(controls.update_tolerance, solved * settings.error_tolerance);
  }
  controls.max_newton = static_cast<int>(settings.max_iterations);
  return controls;
}

double StepControl::limit(const FlowSolver& solver, double t_stop) const {
  if (settings_.time_step > 0) return settings_.time_step;
  refuse_collapse(solver);
  const double longest = std::min(needs_.phase() / steps_per_phase, t_stop - solver.time());
  const double start = steps_ == 0 ? first_step_part * longest : longest;
  double dt = std::min(start, steps_ == 0 ? start : growth * last_step(solver));
  const double speed = needs_.speed(solver.time() + dt);
  if (speed > 0) dt = std::min(dt, settings_.cfl * needs_.length / speed);
  return dt;
}

/// @throws ComputationFailed when steps have become so short that the end is out of sight
void StepControl::refuse_collapse(const FlowSolver& solver) const {
  if (steps_ == 0) return;
  constexpr double collapsed = 1e-4;
  const double speed = needs_.speed(solver.time());
  double wanted = needs_.phase() / steps_per_phase;
  if (speed > 0) wanted = std::min(wanted, settings_.cfl * needs_.length / speed);
  if (last_step(solver) > collapsed * wanted) return;
  throw ComputationFailed("steps have shrunk to " + rounded(last_step(solver), 3) + " s, where fem.cfl allows " +
                          rounded(wanted, 3) + " s" +
                          (problem_.empty() ? "" : ", and the last longer one failed: " + problem_) + advice());
}

/// What to do about steps that cannot be taken.
std::string StepControl::advice() const {
  std::string text = ": " + needs_.program +
                     " may change faster there than mesh and steps can follow; try longer or smooth " +
                     "ramps, a finer mesh (fem.h_rim, fem.h_wall), a " +
                     (settings_.time_step > 0 ? "shorter fem.time_step or fem.cfl in place of it" : "smaller fem.cfl");
  if (settings_.error_tolerance > 0) text += ", a greater fem.error_tolerance";
  return text;
}

SolverRow StepControl::take(FlowSolver& solver, double t_stop) {
  double dt = limit(solver, t_stop) * reduced_;
  for (int attempt = 0;; ++attempt) {
    // equal steps to the stop, so that none is a sliver
    const double before = solver.time();
    const double parts = std::ceil((t_stop - before) / dt * (1 - 1e-9));
    const double t = parts <= 1 ? t_stop : before + (t_stop - before) / parts;
    try {
      const StepReport report = solver.step_to(t, needs_.error_limit);
      if (report.accepted) return accepted(solver, report, t - before);
      problem_ = "the local error of velocity is " + rounded(report.error, 3) + " m/s, above the " +
                 rounded(needs_.error_limit, 3) + " m/s of fem.error_tolerance";
    } catch (const ComputationFailed& failure) {
      problem_ = failure.what();
    }
    if (attempt == most_halvings || settings_.time_step > 0) {
      throw ComputationFailed(problem_ + ", with a step of " + rounded(t - before, 3) +
                              " s from t = " + rounded(before, 6) + " s" + advice());
    }
    dt = (t - before) / 2;
    reduced_ /= 2;
  }
}

/// Books a step, and what it says about the next one.
SolverRow StepControl::accepted(const FlowSolver& solver, const StepReport& report, double dt) {
  ++steps_;
  const bool slow = report.newton_iterations > many_iterations;
  constexpr double near = 0.5;  // of the tolerance: the next step would miss it
  const bool coarse = report.error > near * needs_.error_limit;
  if (settings_.time_step == 0) reduced_ = std::min(1.0, reduced_ * (slow || coarse ? 1 / growth : growth));
  return {.step = steps_,
          .time = solver.time(),
          .dt = dt,
          .cfl = needs_.speed(solver.time()) * dt / needs_.length,
          .nonlinear_iterations = report.newton_iterations,
          .linear_iterations = report.linear_iterations,
          .factorisations = report.factorizations,
          .residual = report.residual,
          .min_jacobian = 0,
          .volume_error = 0};
}

}  // namespace turgor
