// The flow solver against made-up and known solutions.

#include "turgor/fem/flow_solver.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "../support/fem.hpp"
#include "cylinder.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

constexpr FlowControls tight(FemScheme scheme = FemScheme::bdf2) {
  return {.scheme = scheme, .update_tolerance = 1e-9, .linear_tolerance = 1e-8, .max_newton = 20};
}

// The step of 1e-30 has no difference to lose digits in, so that only rounding is left.
TEST(FlowCell, TangentIsTheDerivativeOfTheResidual) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const TaylorHood element;
  CellState cell{};
  NodalVector<std::complex<double>> u{};
  NodalVector<double> real_u{};
  std::array<std::complex<double>, pressure_nodes> p{};
  std::array<double, pressure_nodes> real_p{};
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      cell.position[c][i] = (c == 0 ? 0.3 : 0.0) + element.node(i)[c] + 0.05 * any(random);
      cell.mesh_velocity[c][i] = any(random);
      cell.history[c][i] = any(random);
      cell.frozen[c][i] = any(random);
      cell.body_force[c][i] = any(random);
      u[c][i] = real_u[c][i] = any(random);
    }
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) p[i] = real_p[i] = any(random);
  const CellSettings settings{
      .density = 1.3, .viscosity = 0.2, .rate_factor = 3, .time_step = 0.5, .supg = 1, .grad_div = 0.5};
  CellResidual<double> residual{};
  CellTangent tangent{};
  ASSERT_GT(integrate_cell(element, settings, cell, real_u, real_p, residual, &tangent), 0);
  constexpr std::complex<double> step(0, 1e-30);
  for (std::size_t j = 0; j < cell_unknowns; ++j) {
    auto u_off = u;
    auto p_off = p;
    if (j < 2 * velocity_nodes) {
      u_off[j / velocity_nodes][j % velocity_nodes] += step;
    } else {
      p_off[j - 2 * velocity_nodes] += step;
    }
    CellResidual<std::complex<double>> off{};
    integrate_cell(element, settings, cell, u_off, p_off, off, nullptr);
    for (std::size_t i = 0; i < cell_unknowns; ++i) {
      const std::complex<double> value = i < 2 * velocity_nodes ? off.momentum[i / velocity_nodes][i % velocity_nodes]
                                                                : off.continuity[i - 2 * velocity_nodes];
      EXPECT_NEAR(tangent[i][j], value.imag() / step.imag(), 1e-13) << "row " << i << ", column " << j;
    }
  }
}

FlowErrors made_up_errors(const MadeUpFlow& flow, std::size_t n, FemScheme scheme, double dt, double end) {
  const BalloonMesh mesh = cylinder(n);
  const FlowSpace space(mesh);
  FlowSolver solver(space, flow.definition(), tight(scheme));
  solver.start({MadeUpFlow::level(space, -dt), MadeUpFlow::level(space, 0)});
  const int steps = static_cast<int>(std::lround(end / dt));
  for (int k = 1; k <= steps; ++k) solver.step_to(k * dt);
  return errors_of(solver, MadeUpFlow::velocity, MadeUpFlow::pressure);
}

// Q2/Q1: third order in velocity, second in pressure; 0.2 for meshes that are not yet fine.
TEST(FlowSolver, HasItsOrdersInSpaceOnAMovingMeshAtTheAxis) {
  const MadeUpFlow flow{.density = 1.3, .viscosity = 0.1};
  FlowErrors coarse = made_up_errors(flow, 4, FemScheme::bdf2, 1e-3, 3e-3);
  for (const std::size_t n : {8U, 16U}) {
    const FlowErrors fine = made_up_errors(flow, n, FemScheme::bdf2, 1e-3, 3e-3);
    EXPECT_GT(std::log2(coarse.velocity / fine.velocity), 2.8) << n;
    EXPECT_GT(std::log2(coarse.pressure / fine.pressure), 1.8) << n;
    coarse = fine;
  }
}

class TimeOrder : public testing::TestWithParam<std::pair<FemScheme, double>> {};

// The mesh of 16 x 16 is good for 8e-6 in velocity, a tenth of the errors seen here.
TEST_P(TimeOrder, IsThatOfTheFormulaOnAMovingMesh) {
  const MadeUpFlow flow{.density = 1.3, .viscosity = 0.1};
  const auto [scheme, order] = GetParam();
  const FlowErrors coarse = made_up_errors(flow, 16, scheme, 0.05, 0.5);
  const FlowErrors fine = made_up_errors(flow, 16, scheme, 0.025, 0.5);
  EXPECT_GT(std::log2(coarse.velocity / fine.velocity), order - 0.15);
  EXPECT_GT(fine.velocity, 5e-5);
}

INSTANTIATE_TEST_SUITE_P(BackwardDifferences, TimeOrder,
                         testing::Values(std::pair{FemScheme::bdf1, 1.0}, std::pair{FemScheme::bdf2, 2.0}),
                         [](const auto& given) { return given.param.first == FemScheme::bdf1 ? "bdf1" : "bdf2"; });

// Geometric conservation: a mesh that moves through a uniform flow does not disturb it, nor does the penalty.
TEST(FlowSolver, KeepsAUniformFlowOnAMovingMesh) {
  const BalloonMesh mesh = cylinder(6, Side::channel);
  const FlowSpace space(mesh);
  FlowDefinition flow;
  flow.viscosity = 0.1;
  flow.slip = true;
  flow.position = MadeUpFlow::position;
  flow.mesh_velocity = MadeUpFlow::mesh_velocity;
  flow.wall_velocity = [](const Point2&, double) { return Point2{0, 0.7}; };
  FlowSolver solver(space, flow, tight());
  FlowLevel uniform{-0.1, std::vector<double>(static_cast<std::size_t>(space.size()), 0.0)};
  for (std::size_t i = 0; i < space.nodes().size(); ++i) uniform.unknowns[2 * i + 1] = 0.7;
  FlowLevel now = uniform;
  now.time = 0;
  solver.start({uniform, now});
  for (int k = 1; k <= 5; ++k) solver.step_to(0.1 * k);
  const auto exact = [](const Point2&, double) { return Point2{0, 0.7}; };
  const FlowErrors errors = errors_of(solver, exact, [](const Point2&, double) { return 0.0; });
  EXPECT_LT(errors.velocity, 1e-13);
  EXPECT_LT(errors.pressure, 1e-10);  // of rho u^2 = 490 Pa
}

FlowDefinition still(double viscosity) {
  FlowDefinition flow;
  flow.viscosity = viscosity;
  flow.density = 1;
  flow.position = [](const Point2& X, double) { return X; };
  flow.mesh_velocity = [](const Point2&, double) { return Point2{}; };
  flow.tangential_zero = true;
  flow.inflow_penalty = 0;  // these profiles come in uneven
  return flow;
}

// u_z = 2 (1 - r^2) and p = 8 mu (1 - z) are in the spaces.
TEST(FlowSolver, PoiseuilleIsExact) {
  const BalloonMesh mesh = cylinder(4, Side::channel);
  const FlowSpace space(mesh);
  FlowDefinition flow = still(0.3);
  const auto profile = [](const Point2& x, double) { return Point2{0, 2 * (1 - x[0] * x[0])}; };
  flow.wall_velocity = profile;
  flow.inlet_pressure = [](double) { return 8 * 0.3; };
  FlowSolver solver(space, flow, tight());
  for (int k = 1; k <= 4; ++k) solver.step_to(1e3 * k);
  const FlowErrors errors = errors_of(solver, profile, [](const Point2& x, double) { return 8 * 0.3 * (1 - x[1]); });
  EXPECT_LT(errors.velocity, 1e-8);  // the linear solver's tolerance
  EXPECT_LT(errors.pressure, 1e-8);
}

/// J0 by its series, which for |x| < 10 loses at most four digits.
std::complex<double> bessel_j0(std::complex<double> x) {
  std::complex<double> term = 1;
  std::complex<double> sum = 1;
  for (int k = 1; k < 60; ++k) {
    term *= -x * x / (4.0 * k * k);
    sum += term;
  }
  return sum;
}

/// Oscillating flow in a tube of radius 1 under a pressure gradient cos(omega t), density 1: Womersley, J. Physiol. 127
/// (1955) 553.
Point2 womersley(double r, double t, double omega, double viscosity) {
  using namespace std::complex_literals;
  const std::complex<double> wave = std::pow(1i, 1.5) * std::sqrt(omega / viscosity);
  return {0, (1.0 / (1i * omega) * (1.0 - bessel_j0(wave * r) / bessel_j0(wave)) * std::exp(1i * omega * t)).real()};
}

double womersley_error(double dt) {
  constexpr double omega = 2;
  constexpr double viscosity = 0.08;  // Womersley number 5
  const BalloonMesh mesh = cylinder(12, Side::channel);
  const FlowSpace space(mesh);
  FlowDefinition flow = still(viscosity);
  const auto profile = [](const Point2& x, double t) { return womersley(x[0], t, omega, viscosity); };
  flow.wall_velocity = [&](const Point2& x, double t) { return x[0] < 1 ? profile(x, t) : Point2{}; };
  flow.inlet_pressure = [](double t) { return std::cos(omega * t); };
  FlowSolver solver(space, flow, tight());
  std::vector<FlowLevel> levels;
  for (const double t : {-dt, 0.0}) {
    levels.push_back({t, std::vector<double>(static_cast<std::size_t>(space.size()), 0.0)});
    for (std::size_t i = 0; i < space.nodes().size(); ++i) {
      levels.back().unknowns[2 * i + 1] = profile(space.nodes()[i], t)[1];
    }
  }
  solver.start(std::move(levels));
  for (int k = 1; k <= static_cast<int>(std::lround(2 / dt)); ++k) solver.step_to(k * dt);
  return errors_of(solver, profile, [](const Point2& x, double t) { return std::cos(omega * t) * (1 - x[1]); })
      .velocity;
}

TEST(FlowSolver, WomersleyFlowConvergesWithSecondOrder) {
  const double coarse = womersley_error(0.1);
  const double fine = womersley_error(0.05);
  EXPECT_LT(fine, 1e-3);  // of an amplitude of 0.5
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

// What the penalty does to any profile adds up to nothing over the free nodes, and a uniform one it leaves alone.
TEST(OpenBoundary, PenaltyLeavesTheMeanTraction) {
  const BalloonMesh mesh = cylinder(9);
  const FlowSpace space(mesh);
  const auto inlet_nodes = space.nodes_on(Side::inlet);
  std::vector<bool> free(static_cast<std::size_t>(space.node_count()), true);
  for (const int node : space.nodes_on(Side::wall)) free[static_cast<std::size_t>(node)] = false;
  const OpenBoundary inlet(space, free);
  EXPECT_NEAR(inlet.area(), 0.5, 1e-15);
  for (std::size_t j = 0; j < inlet_nodes.size(); ++j) {
    double column = 0;
    for (std::size_t i = 0; i < inlet_nodes.size(); ++i) {
      if (free[static_cast<std::size_t>(inlet_nodes[i])]) column += inlet.axial(i, j);
      EXPECT_NEAR(inlet.axial(i, j), inlet.axial(j, i), 1e-16);
    }
    EXPECT_NEAR(column, 0, 1e-15) << j;
  }
}

// The weak form tested with the velocity itself: powers balance to the tolerance of Newton's method.
TEST(FlowBalance, PowersAddUp) {
  const BalloonMesh mesh = cylinder(6);
  const FlowSpace space(mesh);
  FlowDefinition flow;
  flow.density = 1;
  flow.viscosity = 0.01;
  flow.position = MadeUpFlow::position;
  flow.mesh_velocity = MadeUpFlow::mesh_velocity;
  flow.inlet_pressure = [](double t) { return std::sin(5 * t); };
  FlowSolver solver(space, flow, tight());
  for (int k = 1; k <= 12; ++k) {
    solver.step_to(0.05 * k);
    const FlowBalance b = flow_balance(solver, [](const Point2&) { return Point2{}; });
    const double fed = b.wall_power + b.inlet_power - b.viscous_loss - b.upwind_loss - b.grad_div_loss - b.penalty_loss;
    EXPECT_NEAR(b.power_of_inertia, fed, 1e-7 * (std::abs(b.wall_power) + std::abs(b.inlet_power))) << k;
  }
}

TEST(FlowSolver, AStepThatInvertsTheMeshLeavesTheStateAlone) {
  const BalloonMesh mesh = cylinder(3);
  const FlowSpace space(mesh);
  FlowDefinition flow = still(0.1);
  flow.position = [](const Point2& X, double t) { return Point2{X[0], X[1] * (1 - t)}; };
  flow.mesh_velocity = [](const Point2& X, double) { return Point2{0, -X[1]}; };
  FlowSolver solver(space, flow, tight());
  solver.step_to(0.5);
  const std::vector<double> before = solver.solution();
  EXPECT_THROW(solver.step_to(1.5), ComputationFailed);
  EXPECT_EQ(solver.time(), 0.5);
  EXPECT_EQ(solver.solution(), before);
  EXPECT_NO_THROW(solver.step_to(0.6));
}

}  // namespace
}  // namespace turgor
