#include "turgor/fem/flow_solver.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<bool> fixed_unknowns(const FlowSpace& space, const FlowDefinition& flow) {
  std::vector<bool> fixed(index(space.size()), false);
  const auto fix = [&](Side side, bool radial, bool axial) {
    for (const int node : space.nodes_on(side)) {
      if (radial) fixed[index(space.velocity(node, 0))] = true;
      if (axial) fixed[index(space.velocity(node, 1))] = true;
    }
  };
  fix(Side::axis, true, false);
  fix(Side::inlet, flow.tangential_zero, false);
  fix(Side::channel, true, !flow.slip);
  if (!flow.wall) {
    fix(Side::wall, true, true);
    return fixed;
  }
  const int rim = flow.wall->nodes().front();
  for (int c = 0; c < 2; ++c) fixed[index(space.velocity(rim, c))] = true;
  return fixed;
}

std::vector<bool> free_axial(const FlowSpace& space, const std::vector<bool>& fixed) {
  std::vector<bool> free(index(space.node_count()));
  for (int i = 0; i < space.node_count(); ++i) free[index(i)] = !fixed[index(space.velocity(i, 1))];
  return free;
}

void add_to_matrix(const CellTangent& tangent, const std::array<int, cell_unknowns * cell_unknowns>& places,
                   std::vector<double>& matrix) {
  for (std::size_t i = 0; i < cell_unknowns; ++i) {
    for (std::size_t j = 0; j < cell_unknowns; ++j) {
      const int at = places[i * cell_unknowns + j];
      if (at >= 0) matrix[index(at)] += tangent[i][j];
    }
  }
}

}  // namespace

FlowSolver::FlowSolver(const FlowSpace& space, FlowDefinition flow, FlowControls controls)
    : space_(space),
      flow_(std::move(flow)),
      controls_(controls),
      fixed_(fixed_unknowns(space, flow_)),
      inlet_(space, free_axial(space, fixed_)) {
  prepare_matrix();
  std::vector<double> rest(index(space.size()), 0.0);
  if (flow_.inlet_pressure) std::fill(rest.begin() + space.pressure(0), rest.end(), flow_.inlet_pressure(0));
  FlowLevel now{0.0, std::move(rest)};
  if (flow_.wall) {
    now.positions = flow_.wall->start();
    now.mesh_velocities.assign(now.positions.size(), 0.0);
  }
  FlowLevel before = now;
  before.time = -1;
  start({std::move(before), std::move(now)});
}

void FlowSolver::start(std::vector<FlowLevel> levels) {
  levels_ = std::move(levels);
  step_time_ = time();
  if (flow_.wall) {
    positions_ = levels_.back().positions;
    mesh_velocities_ = levels_.back().mesh_velocities;
  } else {
    move_mesh(step_time_);
  }
  // as if the present velocities stayed
  settings_ = {.density = flow_.density,
               .viscosity = flow_.viscosity,
               .rate_factor = 0,
               .time_step = std::numeric_limits<double>::infinity(),
               .supg = flow_.supg,
               .grad_div = flow_.grad_div};
  history_.assign(positions_.size(), 0.0);
  frozen_ = levels_.back().unknowns;
  assemble(frozen_, reactions_, false);
  linear_->discard_factors();
}

SparsePattern FlowSolver::coupled_unknowns() const {
  const std::size_t n = index(space_.size());
  std::vector<std::set<int>> rows(n);
  const auto couple = [&](int i, int j) {
    if (!fixed_[index(i)] && !fixed_[index(j)]) rows[index(i)].insert(j);
  };
  for (std::size_t i = 0; i < n; ++i) rows[i].insert(static_cast<int>(i));
  for (const auto& cell : space_.cells()) {
    const auto unknowns = space_.unknowns(cell);
    for (const int i : unknowns) {
      for (const int j : unknowns) couple(i, j);
    }
  }
  for (const int a : inlet_.nodes()) {
    for (const int b : inlet_.nodes()) {
      for (int c = 0; c < 2; ++c) couple(space_.velocity(a, c), space_.velocity(b, c));
    }
  }
  if (flow_.wall) couple_wall(rows);
  SparsePattern pattern;
  pattern.row_start.push_back(0);
  for (const auto& row : rows) {
    pattern.columns.insert(pattern.columns.end(), row.begin(), row.end());
    pattern.row_start.push_back(static_cast<int>(pattern.columns.size()));
  }
  return pattern;
}

/// Bending couples the nodes of two elements.
void FlowSolver::couple_wall(std::vector<std::set<int>>& rows) const {
  constexpr std::size_t reach = 4;
  const std::vector<int>& wall = flow_.wall->nodes();
  for (std::size_t i = 0; i < wall.size(); ++i) {
    for (std::size_t j = i < reach ? 0 : i - reach; j < std::min(wall.size(), i + reach + 1); ++j) {
      for (const int a : {space_.velocity(wall[i], 0), space_.velocity(wall[i], 1)}) {
        for (const int b : {space_.velocity(wall[j], 0), space_.velocity(wall[j], 1)}) {
          if (!fixed_[index(a)] && !fixed_[index(b)]) rows[index(a)].insert(b);
        }
      }
    }
  }
}

void FlowSolver::prepare_matrix() {
  SparsePattern pattern = coupled_unknowns();
  const auto place = [&](int i, int j) { return fixed_[index(i)] || fixed_[index(j)] ? -1 : pattern.find(i, j); };
  for (const auto& cell : space_.cells()) {
    const auto unknowns = space_.unknowns(cell);
    auto& list = places_.emplace_back();
    for (std::size_t i = 0; i < cell_unknowns; ++i) {
      for (std::size_t j = 0; j < cell_unknowns; ++j) list[i * cell_unknowns + j] = place(unknowns[i], unknowns[j]);
    }
  }
  for (const int a : inlet_.nodes()) {
    for (const int b : inlet_.nodes()) {
      for (int c = 0; c < 2; ++c) inlet_places_.push_back(place(space_.velocity(a, c), space_.velocity(b, c)));
    }
  }
  for (int i = 0; i < space_.size(); ++i) {
    if (fixed_[index(i)]) fixed_places_.push_back(pattern.find(i, i));
  }
  linear_ = std::make_unique<LinearSolver>(std::move(pattern));
}

void FlowSolver::move_mesh(double t) {
  positions_.resize(2 * space_.nodes().size());
  mesh_velocities_.resize(positions_.size());
  for (std::size_t i = 0; i < space_.nodes().size(); ++i) {
    const Point2 x = flow_.position(space_.nodes()[i], t);
    const Point2 w = flow_.mesh_velocity(space_.nodes()[i], t);
    for (std::size_t c = 0; c < 2; ++c) {
      positions_[2 * i + c] = x[c];
      mesh_velocities_[2 * i + c] = w[c];
    }
  }
}

FlexibleWall::Motion FlowSolver::wall_motion(const std::vector<double>& unknowns) const {
  const std::vector<int>& wall = flow_.wall->nodes();
  const auto size = static_cast<Eigen::Index>(2 * wall.size());
  FlexibleWall::Motion motion{Eigen::VectorXd(size), Eigen::VectorXd(size), Eigen::VectorXd(size),
                              1 / settings_.rate_factor, settings_.rate_factor};
  for (std::size_t k = 0; k < wall.size(); ++k) {
    for (std::size_t c = 0; c < 2; ++c) {
      const std::size_t from = 2 * index(wall[k]) + c;
      const auto to = static_cast<Eigen::Index>(2 * k + c);
      motion.velocity[to] = unknowns[from];
      motion.places[to] = (unknowns[from] - trail_[from]) / settings_.rate_factor;
      motion.acceleration[to] = settings_.rate_factor * unknowns[from] + history_[from];
    }
  }
  return motion;
}

void FlowSolver::follow_wall(const std::vector<double>& unknowns) {
  positions_ = flow_.wall->mesh(wall_motion(unknowns).places);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    mesh_velocities_[i] = settings_.rate_factor * positions_[i] + trail_[i];
  }
}

/// The wall's momentum is that of its nodes' liquid too.
void FlowSolver::add_wall(const std::vector<double>& unknowns, std::vector<double>& residual) {
  const FlexibleWall::Resistance wall = flow_.wall->resistance(wall_motion(unknowns));
  const std::vector<int>& nodes = flow_.wall->nodes();
  const auto unknown = [&](Eigen::Index i) {
    return space_.velocity(nodes[static_cast<std::size_t>(i / 2)], static_cast<int>(i % 2));
  };
  for (Eigen::Index i = 0; i < wall.force.size(); ++i) residual[index(unknown(i))] += wall.force[i];
  std::vector<double>& matrix = linear_->values();
  for (Eigen::Index k = 0; k < wall.tangent.outerSize(); ++k) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(wall.tangent, k); entry; ++entry) {
      const int i = unknown(entry.row());
      const int j = unknown(entry.col());
      if (!fixed_[index(i)] && !fixed_[index(j)]) matrix[index(linear_->pattern().find(i, j))] += entry.value();
    }
  }
}

void FlowSolver::impose_velocities(double t, std::vector<double>& unknowns) const {
  const auto impose = [&](int node, int component, double value) {
    const std::size_t i = index(space_.velocity(node, component));
    if (fixed_[i]) unknowns[i] = value;
  };
  const auto place = [&](int node) { return Point2{positions_[2 * index(node)], positions_[2 * index(node) + 1]}; };
  for (const int node : space_.nodes_on(Side::inlet)) impose(node, 0, 0.0);
  for (const int node : space_.nodes_on(Side::channel)) {
    const Point2 u = flow_.wall_velocity ? flow_.wall_velocity(place(node), t) : Point2{};
    for (int c = 0; c < 2; ++c) impose(node, c, u[index(c)]);
  }
  for (const int node : space_.nodes_on(Side::wall)) {
    if (flow_.wall) continue;
    const Point2 mesh{mesh_velocities_[2 * index(node)], mesh_velocities_[2 * index(node) + 1]};
    const Point2 u = flow_.wall_velocity ? flow_.wall_velocity(place(node), t) : mesh;
    for (int c = 0; c < 2; ++c) impose(node, c, u[index(c)]);
  }
  for (const int node : space_.nodes_on(Side::axis)) impose(node, 0, 0.0);
}

std::vector<double> FlowSolver::extrapolated(double t) const {
  const FlowLevel& last = levels_.back();
  std::vector<double> guess = last.unknowns;
  if (levels_.size() < 2) return guess;
  const FlowLevel& before = levels_[levels_.size() - 2];
  const double w = (t - last.time) / (last.time - before.time);
  for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += w * (last.unknowns[i] - before.unknowns[i]);
  return guess;
}

CellState FlowSolver::state_of(const FlowSpace::Cell& cell) const {
  CellState state{};
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      const std::size_t at = 2 * index(cell.nodes[i]) + c;
      state.position[c][i] = positions_[at];
      state.mesh_velocity[c][i] = mesh_velocities_[at];
      state.history[c][i] = history_[at];
      state.frozen[c][i] = frozen_[at];
    }
    if (flow_.body_force) {
      const Point2 f = flow_.body_force({state.position[0][i], state.position[1][i]}, step_time_);
      for (std::size_t c = 0; c < 2; ++c) state.body_force[c][i] = f[c];
    }
  }
  return state;
}

double FlowSolver::assemble(const std::vector<double>& unknowns, std::vector<double>& residual, bool tangent) {
  residual.assign(unknowns.size(), 0.0);
  std::vector<double>& matrix = linear_->values();
  if (tangent) std::ranges::fill(matrix, 0.0);
  double least = std::numeric_limits<double>::infinity();
  CellResidual<double> cell_residual{};
  CellTangent cell_tangent{};
  for (std::size_t k = 0; k < space_.cells().size(); ++k) {
    const auto& cell = space_.cells()[k];
    const CellUnknowns u = gather(space_, cell, unknowns);
    least = std::min(least, integrate_cell(space_.element(), settings_, state_of(cell), u.velocity, u.pressure,
                                           cell_residual, tangent ? &cell_tangent : nullptr));
    if (!(least > 0)) return least;
    const auto list = space_.unknowns(cell);
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      for (std::size_t c = 0; c < 2; ++c) residual[index(list[c * velocity_nodes + i])] += cell_residual.momentum[c][i];
    }
    for (std::size_t i = 0; i < pressure_nodes; ++i) {
      residual[index(list[2 * velocity_nodes + i])] += cell_residual.continuity[i];
    }
    if (tangent) add_to_matrix(cell_tangent, places_[k], matrix);
  }
  assemble_inlet(unknowns, residual, tangent);
  if (tangent) {
    for (const int place : fixed_places_) matrix[index(place)] = 1;
  }
  return least;
}

void FlowSolver::refuse_inverted_cell() const {
  for (const auto& cell : space_.cells()) {
    const NodalVector<double> position = state_of(cell).position;
    const auto inverted = [&](const ShapeValues& shape) { return cell_point(shape, position).jacobian <= 0; };
    if (std::ranges::none_of(space_.element().points(), inverted)) continue;
    throw ComputationFailed("a cell of the mesh is inverted at r = " + rounded(position[0].back(), 3) +
                            " m, z = " + rounded(position[1].back(), 3) + " m");
  }
  throw ComputationFailed("the mesh is not finite");
}

double FlowSolver::inlet_pressure(const std::vector<double>& unknowns) const {
  const double given = flow_.inlet_pressure ? flow_.inlet_pressure(step_time_) : 0;
  if (!flow_.total_pressure) return given;
  const double speed = inlet_.mean_inflow(unknowns);
  return given - flow_.density / 2 * speed * speed;
}

void FlowSolver::assemble_inlet(const std::vector<double>& unknowns, std::vector<double>& residual, bool tangent) {
  const std::vector<int>& nodes = inlet_.nodes();
  const double rho = flow_.density * flow_.inflow_penalty;
  const double speed = inlet_.entering_speed(frozen_);
  const std::vector<double> sideways = inlet_.tangential(frozen_);
  const double dynamic_rate =
      flow_.total_pressure ? flow_.density * inlet_.mean_inflow(unknowns) : 0;  // d(rho U^2/2)/dU
  std::vector<double>& matrix = linear_->values();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int radial = space_.velocity(nodes[i], 0);
    const int axial = space_.velocity(nodes[i], 1);
    Point2 traction{0.0, inlet_pressure(unknowns)};  // the normal points down
    if (flow_.inlet_traction) {
      traction =
          flow_.inlet_traction({positions_[2 * index(nodes[i])], positions_[2 * index(nodes[i]) + 1]}, step_time_);
    }
    residual[index(radial)] -= inlet_.weight(i) * traction[0];
    residual[index(axial)] -= inlet_.weight(i) * traction[1];
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const double along = rho * speed * inlet_.axial(i, j);
      const double across = rho * sideways[i * nodes.size() + j];
      residual[index(axial)] += along * unknowns[index(space_.velocity(nodes[j], 1))];
      residual[index(radial)] += across * unknowns[index(space_.velocity(nodes[j], 0))];
      if (!tangent) continue;
      const std::size_t at = 2 * (i * nodes.size() + j);
      if (inlet_places_[at] >= 0) matrix[index(inlet_places_[at])] += across;
      const double dynamic = dynamic_rate * inlet_.weight(i) * inlet_.weight(j) / inlet_.area();
      if (inlet_places_[at + 1] >= 0) matrix[index(inlet_places_[at + 1])] += along + dynamic;
    }
  }
}

void FlowSolver::prepare_step(double t) {
  step_time_ = t;
  const double dt = t - time();
  const FlowLevel& last = levels_.back();
  const bool two = levels_.size() > 1;
  const FlowLevel& before = two ? levels_[levels_.size() - 2] : last;
  const DifferenceFormula formula =
      difference_formula(two ? controls_.scheme : FemScheme::bdf1, dt, last.time - before.time);
  settings_ = {.density = flow_.density,
               .viscosity = flow_.viscosity,
               .rate_factor = formula.rate[0],
               .time_step = dt,
               .supg = flow_.supg,
               .grad_div = flow_.grad_div};
  history_.resize(positions_.size());
  for (std::size_t i = 0; i < history_.size(); ++i) {
    history_[i] = formula.rate[1] * last.unknowns[i] + formula.rate[2] * before.unknowns[i];
  }
  frozen_ = extrapolated(step_time_);
  if (flow_.wall) {
    trail_.resize(positions_.size());
    for (std::size_t i = 0; i < trail_.size(); ++i) {
      trail_[i] = formula.rate[1] * last.positions[i] + formula.rate[2] * before.positions[i];
    }
    follow_wall(frozen_);
  } else {
    move_mesh(step_time_);
  }
  impose_velocities(step_time_, frozen_);
}

// Convergence is judged as stiff integrators do (Hairer & Wanner, Solving ODEs II, IV.8): changes that shrink by a rate
// leave an error of rate/(1 - rate) times the last one, and those that hardly shrink will not arrive.
void FlowSolver::solve_step(std::vector<double>& unknowns, StepReport& report) {
  constexpr double hopeless = 0.8;
  std::vector<double> residual;
  std::vector<double> update;
  while (report.newton_iterations < controls_.max_newton) {
    const double before = report.last_update;
    iterate(unknowns, residual, update, report);
    if (report.last_update <= controls_.update_tolerance) return;
    if (report.newton_iterations == 1) continue;
    const double rate = report.last_update / before;
    if (rate < 0.5 && rate / (1 - rate) * report.last_update <= controls_.update_tolerance) return;
    if (rate > hopeless) break;
  }
  throw ComputationFailed("Newton's method did not converge: change " + std::to_string(report.newton_iterations) +
                          " of the velocity was still " + std::to_string(report.last_update) + " of it");
}

/// One change of the unknowns by Newton's method.
void FlowSolver::iterate(std::vector<double>& unknowns, std::vector<double>& residual, std::vector<double>& update,
                         StepReport& report) {
  report.least_jacobian = assemble(unknowns, residual, true);
  if (!(report.least_jacobian > 0)) refuse_inverted_cell();
  if (flow_.wall) add_wall(unknowns, residual);
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = fixed_[i] ? 0.0 : -residual[i];
  const LinearReport linear = linear_->solve(residual, update, controls_.linear_tolerance);
  report.linear_iterations += linear.iterations;
  report.factorizations += linear.factorizations;
  report.residual = linear.residual;
  const auto velocities = index(2 * space_.node_count());
  double change = 0;
  double size = 1e-300 + space_.node_count() * controls_.least_velocity * controls_.least_velocity;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    unknowns[i] += update[i];
    if (i >= velocities) continue;
    change += update[i] * update[i];
    size += unknowns[i] * unknowns[i];
  }
  if (!std::isfinite(change)) throw ComputationFailed("velocities are not finite");
  if (flow_.wall) follow_wall(unknowns);
  report.newton_iterations += 1;
  report.last_update = std::sqrt(change / size);
}

// With the levels before it, the new one gives the third divided difference (bdf1: the second), which multiplies the
// formula's error constant: du/dt by bdf2 with steps h, h1 is off by h (h + h1) u'''/6, which the step integrates.
double FlowSolver::local_error(const std::vector<double>& unknowns) const {
  const bool second = controls_.scheme == FemScheme::bdf2;
  const std::size_t needed = second ? 3 : 2;
  if (levels_.size() < needed) return 0;
  const std::array<const FlowLevel*, 3> before{&levels_.back(), &levels_[levels_.size() - 2],
                                               second ? &levels_[levels_.size() - 3] : nullptr};
  const double h = step_time_ - before[0]->time;
  const double h1 = before[0]->time - before[1]->time;
  const double h2 = second ? before[1]->time - before[2]->time : 0;
  double sum = 0;
  for (std::size_t i = 0; i < history_.size(); ++i) {
    const double slope = (unknowns[i] - before[0]->unknowns[i]) / h;
    const double slope1 = (before[0]->unknowns[i] - before[1]->unknowns[i]) / h1;
    double error = h * h * (slope - slope1) / (h + h1);
    if (second) {
      const double slope2 = (before[1]->unknowns[i] - before[2]->unknowns[i]) / h2;
      const double third = ((slope - slope1) / (h + h1) - (slope1 - slope2) / (h1 + h2)) / (h + h1 + h2);
      error = third * h * (h + h1) / settings_.rate_factor;
    }
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(space_.node_count()));
}

StepReport FlowSolver::step_to(double t, double error_limit) {
  StepReport report;
  const std::vector<double> places = positions_;
  const std::vector<double> velocities = mesh_velocities_;
  const auto go_back = [&] {
    positions_ = places;
    mesh_velocities_ = velocities;
  };
  std::vector<double> unknowns;
  std::vector<double> reactions;
  try {
    prepare_step(t);
    unknowns = frozen_;
    solve_step(unknowns, report);
    if (!(assemble(unknowns, reactions, false) > 0)) refuse_inverted_cell();
  } catch (const ComputationFailed&) {
    linear_->discard_factors();
    go_back();
    throw;
  }
  report.error = local_error(unknowns);
  report.accepted = report.error <= error_limit;
  if (!report.accepted) {
    go_back();
    return report;
  }
  reactions_ = std::move(reactions);
  if (levels_.size() > 2) levels_.erase(levels_.begin());
  levels_.push_back({step_time_, std::move(unknowns)});
  if (flow_.wall) {
    levels_.back().positions = positions_;
    levels_.back().mesh_velocities = mesh_velocities_;
  }
  return report;
}

}  // namespace turgor
