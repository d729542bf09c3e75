#include "turgor/fem/dictated_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/fem/flow_balance.hpp"
#include "turgor/fem/flow_fields.hpp"
#include "turgor/fem/flow_solver.hpp"
#include "turgor/fem/orifice_profile.hpp"
#include "turgor/mesh/balloon_mesh.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double growth = 1.25;          ///< of one step over the last
constexpr double steps_per_phase = 40;   ///< at least, so that a motion is followed where nothing flows
constexpr double first_step_part = 0.1;  ///< of the step that would be taken otherwise
constexpr int many_iterations = 4;       ///< of Newton's method: shorter steps are cheaper
constexpr int most_halvings = 10;

/// Balloon of radius r as a sphere through its rim, per unit length: volume [m^3] and its derivative [m^2].
double cap_volume(double r, double a) {
  const double height = r + std::sqrt((r - a) * (r + a));
  return pi * height * height * (3 * r - height) / 3;
}
double cap_volume_rate(double r, double a) {
  const double centre = std::sqrt((r - a) * (r + a));
  const double height = r + centre;
  const double height_rate = 1 + r / centre;
  return pi * (2 * height * height_rate * (3 * r - height) + height * height * (3 - height_rate)) / 3;
}

MeshRequest mesh_request(const Case& c) {
  return {.orifice_radius = c.parameters.orifice_radius,
          .channel_length = c.parameters.channel_length,
          .radius = dictated_motion(c).at(0).radius,
          .rim = c.fem.h_rim,
          .orifice = c.fem.h_orifice,
          .wall = c.fem.h_wall};
}

FlowControls controls_of(const Case& c) {
  FlowControls controls;
  controls.scheme = c.fem.scheme;
  controls.update_tolerance = c.fem.tolerance;
  constexpr double solved = 10;  // over the local error: what Newton's method leaves must not be taken for it
  if (c.fem.error_tolerance > 0) {
    controls.update_tolerance = std::min(controls.update_tolerance, solved * c.fem.error_tolerance);
  }
  controls.max_newton = static_cast<int>(c.fem.max_iterations);
  return controls;
}

class DictatedFlow final : public FlowProblem {
 public:
  explicit DictatedFlow(const Case& c)
      : case_(c),
        motion_(dictated_motion(case_)),
        mesh_(balloon_mesh(mesh_request(case_))),
        mesh_motion_(case_.parameters.orifice_radius, motion_.at(0).radius),
        space_(mesh_),
        solver_(space_, definition(), controls_of(case_)),
        error_limit_(error_limit()),
        profile_(space_, case_.parameters.orifice_radius),
        balance_(balance()) {}

  [[nodiscard]] FlowSize size() const override {
    return {static_cast<long>(space_.cells().size()), static_cast<long>(space_.size())};
  }
  [[nodiscard]] double time() const override { return solver_.time(); }
  SolverRow step(double t_stop) override;
  [[nodiscard]] FlowRow row() const override;
  [[nodiscard]] VtuGrid fields() const override { return flow_fields(solver_); }
  void save(Checkpoint& checkpoint) override;
  void load(const Checkpoint& checkpoint) override;
  [[nodiscard]] std::vector<OutflowPoint> outflow() const override { return profile_.mean(); }
  [[nodiscard]] std::vector<Warning> warnings() const override;

 private:
  /// Losses and gains [W], or their integrals [J], by Power.
  using Powers = std::array<double, 4>;
  enum Power : std::size_t { viscous, stabilisation, inlet, wall };

  [[nodiscard]] FlowDefinition definition() const;
  [[nodiscard]] double error_limit() const;
  [[nodiscard]] FlowBalance balance() const;
  [[nodiscard]] double step_limit(double t_stop) const;
  void refuse_collapsed_steps() const;
  [[nodiscard]] double courant_speed(double t) const;
  [[nodiscard]] double last_step() const;
  [[nodiscard]] double phase_duration() const;
  [[nodiscard]] SolverRow accepted(const StepReport& report, double dt);
  void add_work(double dt);
  [[nodiscard]] static Powers powers_of(const FlowBalance& b);

  Case case_;
  PrescribedMotion<double> motion_;
  BalloonMesh mesh_;
  ToroidalMotion mesh_motion_;
  FlowSpace space_;
  FlowSolver solver_;
  double error_limit_;  ///< of a step [m/s]
  OrificeProfile profile_;
  FlowBalance balance_;  ///< at time()
  long steps_ = 0;
  Powers powers_{};
  Powers works_{};
  double reduced_ = 1;  ///< of the step after failures, relative to what was wanted
};

FlowDefinition DictatedFlow::definition() const {
  FlowDefinition flow;
  flow.density = case_.parameters.fluid_density;
  flow.viscosity = case_.parameters.fluid_viscosity;
  flow.slip = case_.inlet.slip;
  flow.tangential_zero = !case_.inlet.tangential_free;
  flow.inflow_penalty = case_.inlet.inflow_penalty;
  flow.position = [this](const Point2& X, double t) { return mesh_motion_.position(X, motion_.at(t).radius); };
  flow.mesh_velocity = [this](const Point2& X, double t) {
    const auto state = motion_.at(t);
    const Point2 rate = mesh_motion_.rate(X, state.radius);
    return Point2{rate[0] * state.rate, rate[1] * state.rate};
  };
  flow.inlet_pressure = [this](double t) { return case_.pressure(t); };
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

double DictatedFlow::last_step() const {
  const auto& levels = solver_.levels();
  return levels.back().time - levels[levels.size() - 2].time;
}

double DictatedFlow::phase_duration() const {
  double duration = case_.solve.t_end;
  for (const auto& part : motion_.intervals(case_.solve.t_end)) {
    if (part.begin <= time()) duration = part.end - part.begin;
  }
  return duration;
}

/// The greater of the orifice's mean speed at a time and the present speeds along the axis, where a jet goes.
double DictatedFlow::courant_speed(double t) const {
  const double a = case_.parameters.orifice_radius;
  const auto state = motion_.at(t);
  double speed = std::abs(cap_volume_rate(state.radius, a) * state.rate) / (pi * a * a);
  for (const int node : space_.nodes_on(Side::axis)) {
    speed = std::max(speed, std::abs(solver_.solution()[static_cast<std::size_t>(space_.velocity(node, 1))]));
  }
  return speed;
}

double DictatedFlow::step_limit(double t_stop) const {
  if (case_.fem.time_step > 0) return case_.fem.time_step;
  refuse_collapsed_steps();
  const double longest = std::min(phase_duration() / steps_per_phase, t_stop - time());
  const double start = steps_ == 0 ? first_step_part * longest : longest;
  double dt = std::min(start, steps_ == 0 ? start : growth * last_step());
  const double speed = courant_speed(time() + dt);
  if (speed > 0) dt = std::min(dt, case_.fem.cfl * case_.parameters.orifice_radius / speed);
  return dt;
}

/// @throws ComputationFailed when steps have become so short that the end is out of sight
void DictatedFlow::refuse_collapsed_steps() const {
  if (steps_ == 0) return;
  constexpr double collapsed = 1e-4;
  const double speed = courant_speed(time());
  double wanted = phase_duration() / steps_per_phase;
  if (speed > 0) wanted = std::min(wanted, case_.fem.cfl * case_.parameters.orifice_radius / speed);
  if (last_step() > collapsed * wanted) return;
  throw ComputationFailed("steps have shrunk to " + rounded(last_step(), 3) + " s, where fem.cfl allows " +
                          rounded(wanted, 3) + " s; try a finer mesh, a smaller fem.cfl" +
                          (case_.fem.error_tolerance > 0 ? ", or a greater fem.error_tolerance" : ""));
}

SolverRow DictatedFlow::step(double t_stop) {
  double dt = step_limit(t_stop) * reduced_;
  for (int attempt = 0;; ++attempt) {
    // equal steps to the stop, so that none is a sliver
    const double parts = std::ceil((t_stop - time()) / dt * (1 - 1e-9));
    const double before = time();
    const double t = parts <= 1 ? t_stop : before + (t_stop - before) / parts;
    std::string problem;
    try {
      const StepReport report = solver_.step_to(t, error_limit_);
      if (report.accepted) return accepted(report, t - before);
      problem = "the local error of velocity is " + rounded(report.error, 3) + " m/s, above the " +
                rounded(error_limit_, 3) + " m/s of fem.error_tolerance";
    } catch (const ComputationFailed& failure) {
      problem = failure.what();
    }
    if (attempt == most_halvings || case_.fem.time_step > 0) {
      throw ComputationFailed(problem + ", with a step of " + rounded(t - before, 3) + " s");
    }
    dt = (t - before) / 2;
    reduced_ /= 2;
  }
}

/// Books a step, and what it says about the next one.
SolverRow DictatedFlow::accepted(const StepReport& report, double dt) {
  ++steps_;
  const bool slow = report.newton_iterations > many_iterations;
  constexpr double near = 0.5;  // of the tolerance: the next step would miss it
  const bool coarse = report.error > near * error_limit_;
  if (case_.fem.time_step == 0) reduced_ = std::min(1.0, reduced_ * (slow || coarse ? 1 / growth : growth));
  add_work(dt);
  const auto motion = motion_.at(time());
  if (motion.rate < 0 && motion.acceleration == 0) profile_.add(solver_.solution(), dt);
  const double a = case_.parameters.orifice_radius;
  const double channel = pi * a * a * case_.parameters.channel_length;
  return {.step = steps_,
          .time = time(),
          .dt = dt,
          .cfl = courant_speed(time()) * dt / a,
          .nonlinear_iterations = report.newton_iterations,
          .linear_iterations = report.linear_iterations,
          .factorisations = report.factorizations,
          .residual = report.residual,
          .min_jacobian = least_jacobian(solver_),
          .volume_error = (balance_.volume - channel) / cap_volume(motion.radius, a) - 1};
}

DictatedFlow::Powers DictatedFlow::powers_of(const FlowBalance& b) {
  return {b.viscous_loss, b.upwind_loss + b.grad_div_loss + b.penalty_loss, b.inlet_power + b.inlet_kinetic,
          b.wall_power};
}

/// By the trapezoidal rule, as accurate as the steps.
void DictatedFlow::add_work(double dt) {
  balance_ = balance();
  const Powers now = powers_of(balance_);
  for (std::size_t i = 0; i < now.size(); ++i) works_[i] += dt / 2 * (powers_[i] + now[i]);
  powers_ = now;
}

FlowRow DictatedFlow::row() const {
  const auto state = motion_.at(time());
  const FlowBalance& b = balance_;
  const double a = case_.parameters.orifice_radius;
  return {.time = time(),
          .gauge_pressure = case_.pressure(time()),
          .radius = state.radius,
          .rate = state.rate,
          .acceleration = state.acceleration,
          .force = b.force,
          .force_mode = b.force_mode,
          .flow_rate = b.inflow,
          .volume = b.volume - pi * a * a * case_.parameters.channel_length,
          .area = b.area,
          .kinetic = b.kinetic_energy,
          .viscous_power = powers_[viscous],
          .viscous_work = works_[viscous],
          .stabilisation_power = powers_[stabilisation],
          .stabilisation_work = works_[stabilisation],
          .inlet_power = powers_[inlet],
          .inlet_work = works_[inlet],
          .wall_power = powers_[wall],
          .wall_work = works_[wall]};
}

std::vector<Warning> DictatedFlow::warnings() const {
  const long failures = solver_.linear_solver().failures();
  if (failures == 0) return {};
  return {{"factorisation", "MUMPS failed to factorise " + std::to_string(failures) + " times; UMFPACK took over"}};
}

void DictatedFlow::save(Checkpoint& checkpoint) {
  solver_.forget_factors();  // so that going on and starting again give the same bits
  checkpoint.times.clear();
  for (std::size_t i = 0; i < solver_.levels().size(); ++i) {
    checkpoint.times.push_back(solver_.levels()[i].time);
    checkpoint.arrays["level " + std::to_string(i)] = solver_.levels()[i].unknowns;
  }
  checkpoint.arrays["powers"] = {powers_.begin(), powers_.end()};
  checkpoint.arrays["works"] = {works_.begin(), works_.end()};
  checkpoint.arrays["profile"] = profile_.sums();
  checkpoint.arrays["reduced step"] = {reduced_};
}

void DictatedFlow::load(const Checkpoint& checkpoint) {
  const auto array = [&](const std::string& name, std::size_t size) {
    const auto found = checkpoint.arrays.find(name);
    if (found == checkpoint.arrays.end() || found->second.size() != size) {
      throw ComputationFailed("the checkpoint has no array \"" + name + "\" of " + std::to_string(size) +
                              " numbers: it is of another version of turgor");
    }
    return found->second;
  };
  std::vector<FlowLevel> levels;
  levels.reserve(checkpoint.times.size());
  for (std::size_t i = 0; i < checkpoint.times.size(); ++i) {
    levels.push_back(
        {checkpoint.times[i], array("level " + std::to_string(i), static_cast<std::size_t>(space_.size()))});
  }
  if (levels.size() < 2) throw ComputationFailed("the checkpoint has too few time levels");
  solver_.start(std::move(levels));
  balance_ = balance();
  std::ranges::copy(array("powers", powers_.size()), powers_.begin());
  std::ranges::copy(array("works", works_.size()), works_.begin());
  profile_.restore(array("profile", profile_.sums().size()));
  reduced_ = array("reduced step", 1)[0];
  steps_ = checkpoint.step;
}

}  // namespace

std::unique_ptr<FlowProblem> make_dictated_flow(const Case& c) { return std::make_unique<DictatedFlow>(c); }

}  // namespace turgor
