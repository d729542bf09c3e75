#include "rest_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fem/known_flows.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/flow/potential_flow.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

/// The potential flow for r = 1, dr/dt = 1, at places of the mesh and as seen from there: PotentialFlow's frame moves
/// with the balloon's centre, at 1/centre.
class Exact {
 public:
  explicit Exact(double kappa) : flow_(kappa, OutflowProfile::uniform(), 1e-9), centre_(std::sqrt(1 - kappa * kappa)) {}

  [[nodiscard]] Point2 velocity(const Point2& x) const {
    const auto [s, theta] = place(x);
    // infinite at the rim, which is held
    if (s > 1 - on_wall && theta > flow_.wall_angle() - on_wall) return {};
    const FlowField field = at(s, theta);
    return {field.radial * std::sin(theta) + field.tangential * std::cos(theta),
            field.radial * std::cos(theta) - field.tangential * std::sin(theta) + 1 / centre_};
  }

  /// phi, zero in the middle of the orifice's plane; the pressure is -rho r d2r/dt2 of it.
  [[nodiscard]] double potential(const Point2& x) const {
    const auto [s, theta] = place(x);
    return lab(at(s, theta).potential, s * std::cos(theta));
  }

  /// int phi dS over the wall, by the midpoint rule; its end at the rim is bounded.
  [[nodiscard]] double wall_integral() const {
    constexpr int points = 20000;
    const double width = flow_.wall_angle() / points;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double offset = (i + 0.5) * width;
      const double theta = flow_.wall_angle() - offset;
      sum += lab(flow_.on_wall(offset).potential, std::cos(theta)) * 2 * pi * std::sin(theta) * width;
    }
    return sum;
  }

 private:
  static constexpr double on_wall = 1e-9;

  /// Distance from the balloon's centre and angle from the axis; cells' edges are outside by a little.
  [[nodiscard]] FlowPoint place(const Point2& x) const {
    const double z = x[1] - centre_;
    return {std::min(std::hypot(x[0], z), 1.0), std::atan2(x[0], z)};
  }
  [[nodiscard]] FlowField at(double s, double theta) const {
    return s > 1 - on_wall ? flow_.on_wall(std::max(flow_.wall_angle() - theta, on_wall)) : flow_.at({s, theta});
  }
  [[nodiscard]] double lab(double potential, double height) const {
    return potential - flow_.at_orifice().potential + height / centre_ + 1;
  }

  PotentialFlow flow_;
  double centre_;
};

/// Of means over edges by Simpson's rule: without viscosity the nodes zigzag about them, at first order, as linear
/// pressures do about the parabolas of the traction.
double greatest_outflow_error(const FlowSolver& solver, const Exact& exact, double kappa, double rate) {
  const FlowSpace& space = solver.space();
  const double speed = channel_speed(cap_depth(kappa)) * std::abs(rate);
  constexpr std::array<double, 3> simpson{1 / 6.0, 1 / 6.0, 4 / 6.0};
  double greatest = 0;
  for (const auto& edge : space.edges()) {
    double off = 0;
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(edge.nodes[k]);
      const Point2& x = space.nodes()[i];
      farthest = std::max(farthest, x[0]);
      off += simpson[k] * (solver.solution()[2 * i + 1] - rate * exact.velocity(x)[1]);
    }
    if (edge.side == Side::inlet && farthest < 0.9 * kappa) greatest = std::max(greatest, std::abs(off) / speed);
  }
  return greatest;
}

}  // namespace

RestFlowErrors rest_flow_errors(double kappa, double fineness) {
  constexpr double acceleration = -1e-9;  // so that nothing is carried along
  const Exact exact(kappa);
  const BalloonMesh mesh = balloon_mesh({.orifice_radius = kappa,
                                         .channel_length = 0,
                                         .radius = 1,
                                         .rim = kappa / 60 / fineness,
                                         .orifice = kappa / 15 / fineness,
                                         .wall = 1 / 37.5 / fineness});
  const FlowSpace space(mesh);
  FlowDefinition flow = still(1e-15);
  flow.tangential_zero = false;
  const auto velocity = [&](const Point2& x, double t) {
    const Point2 u = exact.velocity(x);
    return Point2{acceleration * t * u[0], acceleration * t * u[1]};
  };
  const auto pressure = [&](const Point2& x, double) { return -acceleration * exact.potential(x); };
  flow.wall_velocity = velocity;
  flow.inlet_traction = [&](const Point2& x, double t) { return Point2{0, pressure(x, t)}; };
  FlowSolver solver(space, flow, tight(FemScheme::bdf1));  // exact for what grows evenly
  take_steps(solver, 1, 2);
  const FlowErrors off = errors_of(solver, velocity, pressure);
  const FlowErrors size =
      errors_of(solver, [](const Point2&, double) { return Point2{}; }, [](const Point2&, double) { return 0.0; });
  const double force = flow_balance(solver, [](const Point2&) { return Point2{}; }).force;
  return {.cell = 1 / 60.0 / fineness,
          .velocity = off.velocity / size.velocity,
          .pressure = off.pressure / size.pressure,
          .force = std::abs(force / (-acceleration * exact.wall_integral()) - 1),
          .outflow = greatest_outflow_error(solver, exact, kappa, acceleration * solver.time())};
}

}  // namespace turgor
