#pragma once
// Time steps of a flow: how long they may be, and what to do about one that fails.

#include <functional>
#include <string>

#include "turgor/case/case.hpp"
#include "turgor/fem/flow_problem.hpp"
#include "turgor/fem/flow_solver.hpp"

namespace turgor {

/// What steps must follow.
struct StepNeeds {
  double length;                        ///< orifice radius [m]
  std::function<double(double)> speed;  ///< greatest of the flow at a time not long from now [m/s]
  std::function<double()> phase;        ///< duration of the present segment of the program [s]
  double error_limit;                   ///< of a step's velocity [m/s]
  std::string program;                  ///< the table of the case that drives the flow, such as [pressure]
};

/// Steps by the Courant number or of fixed length, halved where one fails.
class StepControl {
 public:
  StepControl(const FemSettings& settings, StepNeeds needs) : settings_(settings), needs_(std::move(needs)) {}

  /// One accepted step of the solver, never beyond t_stop [s]. Volume error and least Jacobian of the row are the
  /// caller's to fill in.
  /// @throws ComputationFailed when no step is short enough, or steps have become so short that the end is out of sight
  SolverRow take(FlowSolver& solver, double t_stop);

  [[nodiscard]] long steps() const { return steps_; }
  /// Length of the next step after failures, relative to what was wanted.
  [[nodiscard]] double reduction() const { return reduced_; }
  void restore(long steps, double reduction) {
    steps_ = steps;
    reduced_ = reduction;
  }

 private:
  [[nodiscard]] double limit(const FlowSolver& solver, double t_stop) const;
  void refuse_collapse(const FlowSolver& solver) const;
  [[nodiscard]] std::string advice() const;
  [[nodiscard]] SolverRow accepted(const FlowSolver& solver, const StepReport& report, double dt);

  const FemSettings& settings_;
  StepNeeds needs_;
  long steps_ = 0;
  double reduced_ = 1;
  std::string problem_;  ///< of the last step that was not accepted
};

/// Greatest speed of a node on the axis, where a jet goes [m/s].
[[nodiscard]] double speed_on_axis(const FlowSolver& solver);

/// What Newton's method leaves is to be a tenth of the local error that fem.error_tolerance asks for.
[[nodiscard]] FlowControls controls_of(const FemSettings& settings);

}  // namespace turgor
