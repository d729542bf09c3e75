#pragma once
// What a solver of the flow in a balloon of dictated motion looks like to the program around it.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/fem/checkpoint.hpp"
#include "turgor/run/run_case.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor {

/// The flow at one time, SI units. Powers are positive where the liquid gains energy from its boundary, or loses it
/// inside; works are their integrals from t = 0.
struct FlowRow {
  double time;            ///< t [s]
  double gauge_pressure;  ///< at the inlet [Pa]
  double radius;          ///< r [m]
  double rate;            ///< dr/dt [m/s]
  double acceleration;    ///< d2r/dt2 [m/s^2]
  double force;           ///< integral of the gauge pressure over the wall [N]
  double force_mode;      ///< traction on the wall times its velocity per dr/dt, integrated: the generalized force [N]
  double flow_rate;       ///< into the balloon through the orifice [m^3/s]
  double volume;          ///< of liquid in the balloon [m^3]
  double area;            ///< of the wall [m^2]
  double kinetic;         ///< energy of the liquid [J]
  double viscous_power, viscous_work;              ///< dissipated by viscosity [W], [J]
  double stabilisation_power, stabilisation_work;  ///< dissipated by the discretisation [W], [J]
  double inlet_power, inlet_work;                  ///< through the inlet, pressure and kinetic energy [W], [J]
  double wall_power, wall_work;                    ///< of the moving wall on the liquid [W], [J]
  // Where the wall is elastic; the radius is then that of a sphere with the area of wall and orifice, and neither
  // `acceleration` nor `force_mode` has a meaning.
  double top = 0;              ///< height of the pole over the orifice [m]
  double greatest_radius = 0;  ///< distance of the wall from the axis [m]
  double elastic = 0;          ///< energy of the wall [J]
  double wall_kinetic = 0;     ///< [J]
  double damping_power = 0;    ///< dissipated in the wall [W]
  double damping_work = 0;     ///< [J]
};

/// How one accepted step went.
struct SolverRow {
  long step;    ///< from 1
  double time;  ///< at its end [s]
  double dt;    ///< [s]
  double cfl;   ///< as in fem.cfl
  long nonlinear_iterations;
  long linear_iterations;
  long factorisations;
  double residual;          ///< of the nonlinear solve, relative
  double min_jacobian;      ///< least determinant of the mesh's motion from its reference
  double volume_error;      ///< of the liquid's balance over the step, relative to the volume
  double wall_seconds = 0;  ///< it took; filled in by run_flow()
};

/// Size of the discrete problem.
struct FlowSize {
  long cells;
  long unknowns;
};

/// A point of the profile of the outflow.
struct OutflowPoint {
  double upsilon;  ///< distance from the axis over the orifice's radius
  double f;        ///< velocity over its mean
};

/// A flow that can be advanced. Begins at t = 0.
class FlowProblem {
 public:
  FlowProblem() = default;
  virtual ~FlowProblem() = default;
  FlowProblem(const FlowProblem&) = delete;
  FlowProblem& operator=(const FlowProblem&) = delete;
  FlowProblem(FlowProblem&&) = delete;
  FlowProblem& operator=(FlowProblem&&) = delete;

  [[nodiscard]] virtual FlowSize size() const = 0;
  /// Time reached [s].
  [[nodiscard]] virtual double time() const = 0;
  /// One accepted step, never beyond t_stop > time() [s]; a step that ends there makes time() exactly t_stop.
  /// @throws ComputationFailed in words, when there is no such step; the state is then that of the last accepted one
  virtual SolverRow step(double t_stop) = 0;
  /// The flow at time().
  [[nodiscard]] virtual FlowRow row() const = 0;
  /// Nodes, cells and point data at time(), as in DIR/fields.
  [[nodiscard]] virtual VtuGrid fields() const = 0;
  /// Puts what the state consists of into `times` and `arrays`, so that load() goes on to the same bits.
  virtual void save(Checkpoint& checkpoint) = 0;
  /// @throws ComputationFailed when arrays are missing or of another size
  virtual void load(const Checkpoint& checkpoint) = 0;
  /// Profile over the orifice, averaged over the time in which the balloon deflated at a constant rate; empty when it
  /// did not.
  [[nodiscard]] virtual std::vector<OutflowPoint> outflow() const { return {}; }
  /// Assumptions that this flow has strained so far.
  [[nodiscard]] virtual std::vector<Warning> warnings() const { return {}; }
};

/// Makes the problem that a case describes.
using FlowProblemMaker = std::function<std::unique_ptr<FlowProblem>(const Case&)>;

}  // namespace turgor
