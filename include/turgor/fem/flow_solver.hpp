#pragma once
// Incompressible flow in a domain that moves as told: time steps of the arbitrary Lagrangian-Eulerian equations.

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <vector>

#include "turgor/fem/flexible_wall.hpp"
#include "turgor/fem/flow_cell.hpp"
#include "turgor/fem/flow_space.hpp"
#include "turgor/fem/linear_solver.hpp"
#include "turgor/fem/open_boundary.hpp"
#include "turgor/fem/time_scheme.hpp"

namespace turgor {

/// A flow to compute. Places are (r, z) [m], X in the configuration that was meshed, x at present.
struct FlowDefinition {
  double density = 1000;      ///< [kg/m^3]
  double viscosity = 8.9e-4;  ///< dynamic [Pa s]
  /// Given: the wall moves with the liquid, and position and mesh_velocity mean nothing.
  std::shared_ptr<const FlexibleWall> wall;
  std::function<Point2(const Point2& X, double t)> position;
  std::function<Point2(const Point2& X, double t)> mesh_velocity;  ///< [m/s]; on the wall also the liquid's
  std::function<double(double t)> inlet_pressure;                  ///< gauge [Pa]
  bool total_pressure = false;   ///< while liquid enters, inlet_pressure is its static plus mean dynamic pressure
  bool slip = false;             ///< along the channel's wall
  bool tangential_zero = false;  ///< u_r = 0 at the inlet
  double inflow_penalty = 0.5;
  double supg = 1;
  double grad_div = 0.5;
  // for verification against made-up solutions; absent: none, that of the mesh, -inlet_pressure n
  std::function<Point2(const Point2& x, double t)> body_force;      ///< [N/m^3]
  std::function<Point2(const Point2& x, double t)> wall_velocity;   ///< [m/s], on wall and channel
  std::function<Point2(const Point2& x, double t)> inlet_traction;  ///< [Pa]
};

struct FlowControls {
  FemScheme scheme = FemScheme::bdf2;
  /// Of Newton's method: error of velocity that it leaves by the rate of its changes, relative, as root mean squares
  /// over the nodes.
  double update_tolerance = 1e-5;
  double least_velocity = 0;  ///< [m/s], root mean square: changes relative to less would be of rounding
  double linear_tolerance =
      1e-4;  ///< of a linear system's residual; with 1e-3 the flux through the inlet is 1e-6 off at times
  int max_newton = 12;
};

/// Work of one step.
struct StepReport {
  int newton_iterations = 0;
  int linear_iterations = 0;
  int factorizations = 0;
  double residual = 0;        ///< of the last linear system, relative
  double last_update = 0;     ///< Newton's, relative
  double least_jacobian = 0;  ///< determinant at quadrature points [m^2]
  /// Estimate of the step's own error of velocity, root mean square over the nodes [m/s]; 0 before there are enough
  /// earlier levels.
  double error = 0;
  bool accepted = true;
};

/// Solution at an instant.
struct FlowLevel {
  double time = 0;               ///< [s]
  std::vector<double> unknowns;  ///< as FlowSpace numbers them
  // Of the mesh's nodes, (r, z) interleaved; only where the wall is flexible.
  std::vector<double> positions{};        ///< [m]
  std::vector<double> mesh_velocities{};  ///< [m/s]
};

class FlowSolver {
 public:
  /// Liquid that is at rest at t = 0 and has been before.
  FlowSolver(const FlowSpace& space, FlowDefinition flow, FlowControls controls);

  /// Takes the flow as known at some instants, newest last; two of them for bdf2, three for its error.
  void start(std::vector<FlowLevel> levels);

  /// Makes the next step begin with new factors, as a solver does that was started from the same levels.
  void forget_factors() { linear_->discard_factors(); }

  /// One step to a later time [s], which becomes time() exactly.
  /// @param error_limit  [m/s]; a step with a greater error is reported as not accepted, and the solver is as before
  /// @throws ComputationFailed when Newton's method or the linear solver fails, or a cell is inverted; the solver is
  ///         as before then, and a smaller step can be tried
  StepReport step_to(double t, double error_limit = std::numeric_limits<double>::infinity());

  [[nodiscard]] const LinearSolver& linear_solver() const { return *linear_; }
  [[nodiscard]] double time() const { return levels_.back().time; }
  [[nodiscard]] const std::vector<double>& solution() const { return levels_.back().unknowns; }
  [[nodiscard]] const std::vector<FlowLevel>& levels() const { return levels_; }
  [[nodiscard]] const FlowSpace& space() const { return space_; }
  [[nodiscard]] const FlowDefinition& definition() const { return flow_; }
  [[nodiscard]] const OpenBoundary& inlet() const { return inlet_; }
  /// Present place and velocity of every node of the mesh, (r, z) interleaved.
  [[nodiscard]] const std::vector<double>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<double>& mesh_velocities() const { return mesh_velocities_; }
  /// What the unknowns' equations lack at the present solution, boundary nodes included: there it is the force of the
  /// liquid on what holds it, per radian [N/rad].
  [[nodiscard]] const std::vector<double>& reactions() const { return reactions_; }
  /// Of the last step: the velocities that sized the stabilisation, what the cells were integrated with.
  [[nodiscard]] const std::vector<double>& frozen() const { return frozen_; }
  [[nodiscard]] const CellSettings& settings() const { return settings_; }
  [[nodiscard]] CellState state_of(const FlowSpace::Cell& cell) const;
  /// Mean normal traction at the inlet, at the present time [Pa].
  [[nodiscard]] double inlet_pressure(const std::vector<double>& unknowns) const;

 private:
  void move_mesh(double t);
  /// The mesh where wall velocities among the unknowns take it at the end of the step.
  void follow_wall(const std::vector<double>& unknowns);
  void add_wall(const std::vector<double>& unknowns, std::vector<double>& residual);
  void couple_wall(std::vector<std::set<int>>& rows) const;
  [[nodiscard]] FlexibleWall::Motion wall_motion(const std::vector<double>& unknowns) const;
  void impose_velocities(double t, std::vector<double>& unknowns) const;
  [[nodiscard]] std::vector<double> extrapolated(double t) const;
  [[nodiscard]] double local_error(const std::vector<double>& unknowns) const;
  /// Residual at unknowns, and the tangent's entries when wanted.
  /// @return the least Jacobian determinant
  double assemble(const std::vector<double>& unknowns, std::vector<double>& residual, bool tangent);
  /// @throws ComputationFailed with the place of the first cell that is inverted
  [[noreturn]] void refuse_inverted_cell() const;
  void assemble_inlet(const std::vector<double>& unknowns, std::vector<double>& residual, bool tangent);
  void prepare_step(double t);
  void solve_step(std::vector<double>& unknowns, StepReport& report);
  void iterate(std::vector<double>& unknowns, std::vector<double>& residual, std::vector<double>& update,
               StepReport& report);
  [[nodiscard]] SparsePattern coupled_unknowns() const;
  void prepare_matrix();

  const FlowSpace& space_;
  FlowDefinition flow_;
  FlowControls controls_;
  std::vector<bool> fixed_;  ///< of each unknown
  OpenBoundary inlet_;
  std::unique_ptr<LinearSolver> linear_;
  std::vector<std::array<int, cell_unknowns * cell_unknowns>> places_;  ///< of a cell's tangent in the matrix, or -1
  std::vector<int> inlet_places_;                                       ///< (i, j, axial or radial)
  std::vector<int> fixed_places_;                                       ///< their diagonal entries
  std::vector<FlowLevel> levels_;
  std::vector<double> positions_;
  std::vector<double> mesh_velocities_;
  std::vector<double> reactions_;
  double step_time_ = 0;         ///< end of the step [s]
  CellSettings settings_{};      ///< of the step
  std::vector<double> history_;  ///< du/dt = settings_.rate_factor u + history_, of each velocity
  std::vector<double> trail_;    ///< the same of the mesh's places, where the wall is flexible
  std::vector<double> frozen_;
};

}  // namespace turgor
