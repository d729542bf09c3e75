#include "turgor/fem/coupled_flow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "flow_parts.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/fem/elastic_wall.hpp"
#include "turgor/fem/flow_checkpoint.hpp"
#include "turgor/fem/flow_fields.hpp"
#include "turgor/run/membrane_study.hpp"

namespace turgor {

namespace {

constexpr double turn = 2 * std::numbers::pi;

Case checked(const Case& c) {
  require_free_motion(c);
  if (c.stretch_rate == 0) return c;
  throw InvalidInput(
      {{"initial", "", "a coupled balloon starts at rest", "leave out the initial velocity", c.file.string(), 0}});
}

FlowControls controls_of(const Case& c) {
  FlowControls controls = controls_of(c.fem);
  controls.least_velocity = 1e-8;  // below, rounding of the membrane's forces moves a balloon at rest
  return controls;
}

class CoupledFlow final : public FlowProblem {
 public:
  explicit CoupledFlow(const Case& c)
      : case_(checked(c)),
        mesh_(mesh_of(case_, case_.parameters.radius)),
        space_(mesh_),
        wall_(std::make_shared<ElasticWall>(space_, case_)),
        solver_(space_, definition(), controls_of(case_)),
        control_(case_.fem, {.length = case_.parameters.orifice_radius,
                             .speed = [this](double) { return speed(); },
                             .phase = [this] { return segment_duration(); },
                             .error_limit = error_limit(),
                             .program = "[pressure]"}),
        balance_(flow_balance(solver_, no_mode)),
        start_volume_(balance_.volume) {}

  [[nodiscard]] FlowSize size() const override { return size_of(space_); }
  [[nodiscard]] double time() const override { return solver_.time(); }
  SolverRow step(double t_stop) override;
  [[nodiscard]] FlowRow row() const override;
  [[nodiscard]] VtuGrid fields() const override { return flow_fields(solver_); }
  void save(Checkpoint& checkpoint) override;
  void load(const Checkpoint& checkpoint) override;
  [[nodiscard]] std::vector<Warning> warnings() const override;

 private:
  static Point2 no_mode(const Point2& /*X*/) { return {}; }
  [[nodiscard]] FlowDefinition definition() const;
  [[nodiscard]] double speed() const;
  [[nodiscard]] double segment_duration() const;
  [[nodiscard]] double error_limit() const;
  [[nodiscard]] double radius_of(const Eigen::VectorXd& places) const;

  Case case_;
  std::vector<Warning> static_warnings_ = membrane_warnings(case_);
  BalloonMesh mesh_;
  FlowSpace space_;
  std::shared_ptr<ElasticWall> wall_;
  FlowSolver solver_;
  StepControl control_;
  FlowBalance balance_;  ///< at time()
  EnergyAccount energies_;
  double start_volume_;  ///< of all liquid
  double entered_ = 0;   ///< volume since t = 0
};

FlowDefinition CoupledFlow::definition() const {
  FlowDefinition flow = liquid_of(case_);
  flow.wall = wall_;
  return flow;
}

/// The greater of the orifice's mean speed and the speeds along the axis.
double CoupledFlow::speed() const {
  const double a = case_.parameters.orifice_radius;
  const double mean = turn * std::abs(solver_.inlet().inflow(solver_.solution())) / (std::numbers::pi * a * a);
  return std::max(mean, speed_on_axis(solver_));
}

/// Of the present segment of the pressure, at most a period where it oscillates.
double CoupledFlow::segment_duration() const {
  double begin = 0;
  double end = case_.solve.t_end;
  for (const double knot : case_.pressure.knots()) {
    if (knot > time()) end = std::min(end, knot);
    if (knot <= time()) begin = std::max(begin, knot);
  }
  const auto* harmonic = std::get_if<HarmonicPressure<double>>(&case_.pressure.after(time()).form());
  const bool swings = harmonic != nullptr && !harmonic->is_constant();
  return swings ? std::min(end - begin, 1 / std::abs(harmonic->frequency)) : end - begin;
}

/// fem.error_tolerance times the speed that the greatest pressure of the program would drive through the orifice.
double CoupledFlow::error_limit() const {
  if (case_.fem.error_tolerance == 0) return std::numeric_limits<double>::infinity();
  const PressureRange<double> range = range_of(case_.pressure, case_.solve.t_end);
  const double greatest = std::max(std::abs(range.least), std::abs(range.greatest));
  return case_.fem.error_tolerance * std::sqrt(2 * greatest / case_.parameters.fluid_density);
}

SolverRow CoupledFlow::step(double t_stop) {
  const double before = time();
  const double inflow = balance_.inflow;
  SolverRow row = control_.take(solver_, t_stop);
  const double dt = time() - before;
  balance_ = flow_balance(solver_, no_mode);
  const Eigen::VectorXd places = wall_->of_wall(solver_.positions());
  const Eigen::VectorXd velocity = wall_->of_wall(solver_.mesh_velocities());
  const double damping =
      case_.wall.damping_time > 0 ? turn * velocity.dot(wall_->membrane().damping(places, velocity).force) : 0.0;
  energies_.book(balance_, damping, dt);
  entered_ += dt / 2 * (inflow + balance_.inflow);
  row.min_jacobian = least_jacobian(solver_);
  row.volume_error = (balance_.volume - start_volume_ - entered_) / start_volume_;
  return row;
}

/// Of the sphere with the wall's and the orifice's area together.
double CoupledFlow::radius_of(const Eigen::VectorXd& places) const {
  const double a = case_.parameters.orifice_radius;
  return std::sqrt(turn * wall_->membrane().area(places) / std::numbers::pi + a * a) / 2;
}

FlowRow CoupledFlow::row() const {
  const Membrane& membrane = wall_->membrane();
  const Eigen::VectorXd places = wall_->of_wall(solver_.positions());
  const Eigen::VectorXd velocity = wall_->of_wall(solver_.mesh_velocities());
  constexpr double apart = 1e-6;  // [s]
  FlowRow row = row_of(case_, time(), balance_, energies_);
  row.radius = radius_of(places);
  row.rate = (radius_of(places + apart * velocity) - radius_of(places - apart * velocity)) / (2 * apart);
  row.top = places[places.size() - 1];
  for (Eigen::Index i = 0; i < places.size(); i += 2) row.greatest_radius = std::max(row.greatest_radius, places[i]);
  row.elastic = turn * membrane.elastic(places).value;
  row.wall_kinetic = turn / 2 * velocity.dot(membrane.mass() * velocity);
  return row;
}

std::vector<Warning> CoupledFlow::warnings() const {
  std::vector<Warning> all = static_warnings_;
  std::ranges::copy(factorisation_warnings(solver_), std::back_inserter(all));
  return all;
}

void CoupledFlow::save(Checkpoint& checkpoint) {
  save_flow(solver_, control_, energies_, checkpoint);
  checkpoint.arrays["entered volume"] = {entered_};
}

void CoupledFlow::load(const Checkpoint& checkpoint) {
  load_flow(checkpoint, solver_, control_, energies_);
  entered_ = array_of(checkpoint, "entered volume", 1)[0];
  balance_ = flow_balance(solver_, no_mode);
}

}  // namespace

std::unique_ptr<FlowProblem> make_coupled_flow(const Case& c) { return std::make_unique<CoupledFlow>(c); }

}  // namespace turgor
