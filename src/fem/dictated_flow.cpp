#include "turgor/fem/dictated_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "flow_parts.hpp"
#include "spherical_cap.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/fem/flow_checkpoint.hpp"
#include "turgor/fem/flow_fields.hpp"
#include "turgor/fem/flow_solver.hpp"
#include "turgor/fem/orifice_profile.hpp"
#include "turgor/fem/step_control.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;
class DictatedFlow final : public FlowProblem {
 public:
  explicit DictatedFlow(const Case& c)
      : case_(c),
        motion_(dictated_motion(case_)),
        mesh_(mesh_of(case_, motion_.at(0).radius)),
        mesh_motion_(case_.parameters.orifice_radius, motion_.at(0).radius),
        space_(mesh_),
        solver_(space_, definition(), controls_of(case_.fem)),
        control_(case_.fem, {.length = case_.parameters.orifice_radius,
                             .speed = [this](double t) { return courant_speed(t); },
                             .phase = [this] { return phase_duration(); },
                             .error_limit = error_limit(),
                             .program = "[motion]"}),
        profile_(space_, case_.parameters.orifice_radius),
        balance_(balance()) {}

  [[nodiscard]] FlowSize size() const override { return size_of(space_); }
  [[nodiscard]] double time() const override { return solver_.time(); }
  SolverRow step(double t_stop) override;
  [[nodiscard]] FlowRow row() const override;
  [[nodiscard]] VtuGrid fields() const override { return flow_fields(solver_); }
  void save(Checkpoint& checkpoint) override;
  void load(const Checkpoint& checkpoint) override;
  [[nodiscard]] std::vector<OutflowPoint> outflow() const override { return profile_.mean(); }
  [[nodiscard]] std::vector<Warning> warnings() const override { return factorisation_warnings(solver_); }

 private:
  [[nodiscard]] FlowDefinition definition() const;
  [[nodiscard]] double error_limit() const;
  [[nodiscard]] FlowBalance balance() const;
  [[nodiscard]] double courant_speed(double t) const;
  [[nodiscard]] double phase_duration() const;

  Case case_;
  PrescribedMotion<double> motion_;
  BalloonMesh mesh_;
  ToroidalMotion mesh_motion_;
  FlowSpace space_;
  FlowSolver solver_;
  StepControl control_;
  OrificeProfile profile_;
  FlowBalance balance_;  ///< at time()
  EnergyAccount energies_;
};

FlowDefinition DictatedFlow::definition() const {
  FlowDefinition flow = liquid_of(case_);
  flow.position = [this](const Point2& X, double t) { return mesh_motion_.position(X, motion_.at(t).radius); };
  flow.mesh_velocity = [this](const Point2& X, double t) {
    const auto state = motion_.at(t);
    const Point2 rate = mesh_motion_.rate(X, state.radius);
    return Point2{rate[0] * state.rate, rate[1] * state.rate};
  };
  return flow;
}

FlowBalance DictatedFlow::balance() const {
  const double radius = motion_.at(time()).radius;
  return flow_balance(solver_, [&](const Point2& X) { return mesh_motion_.rate(X, radius); });
}

/// fem.error_tolerance times the greatest mean speed in the orifice, at the ends of the motion's phases.
double DictatedFlow::error_limit() const {
  if (case_.fem.error_tolerance == 0) return std::numeric_limits<double>::infinity();
  const double a = case_.parameters.orifice_radius;
  double fastest = 0;
  for (const auto& part : motion_.intervals(case_.solve.t_end)) {
    for (const double t : {part.begin, part.end}) {
      const auto state = motion_.within(part.phase, t);
      fastest = std::max(fastest, std::abs(cap_volume_rate(state.radius, a) * state.rate) / (pi * a * a));
    }
  }
  return case_.fem.error_tolerance * fastest;
}

double DictatedFlow::phase_duration() const {
  double duration = case_.solve.t_end;
  for (const auto& part : motion_.intervals(case_.solve.t_end)) {
    if (part.begin <= time()) duration = part.end - part.begin;
  }
  return duration;
}

/// The greater of the orifice's mean speed at a time and the present speeds along the axis.
double DictatedFlow::courant_speed(double t) const {
  const double a = case_.parameters.orifice_radius;
  const auto state = motion_.at(t);
  const double mean = std::abs(cap_volume_rate(state.radius, a) * state.rate) / (pi * a * a);
  return std::max(mean, speed_on_axis(solver_));
}

SolverRow DictatedFlow::step(double t_stop) {
  const double before = time();
  SolverRow row = control_.take(solver_, t_stop);
  balance_ = balance();
  energies_.book(balance_, 0, time() - before);
  const auto motion = motion_.at(time());
  if (motion.rate < 0 && motion.acceleration == 0) profile_.add(solver_.solution(), time() - before);
  const double exact = cap_volume(motion.radius, case_.parameters.orifice_radius);
  row.min_jacobian = least_jacobian(solver_);
  row.volume_error = (balance_.volume - channel_volume(case_)) / exact - 1;
  return row;
}

FlowRow DictatedFlow::row() const {
  const auto state = motion_.at(time());
  FlowRow row = row_of(case_, time(), balance_, energies_);
  row.radius = state.radius;
  row.rate = state.rate;
  row.acceleration = state.acceleration;
  row.force_mode = balance_.force_mode;
  return row;
}

void DictatedFlow::save(Checkpoint& checkpoint) {
  save_flow(solver_, control_, energies_, checkpoint);
  checkpoint.arrays["profile"] = profile_.sums();
}

void DictatedFlow::load(const Checkpoint& checkpoint) {
  load_flow(checkpoint, solver_, control_, energies_);
  balance_ = balance();
  profile_.restore(array_of(checkpoint, "profile", profile_.sums().size()));
}

}  // namespace

std::unique_ptr<FlowProblem> make_dictated_flow(const Case& c) { return std::make_unique<DictatedFlow>(c); }

}  // namespace turgor
