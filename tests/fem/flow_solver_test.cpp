// The flow solver against made-up and known solutions.

#include "turgor/fem/flow_solver.hpp"

#include <gtest/gtest.h>

#include "../support/fem.hpp"
#include "known_flows.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

TEST(FlowCell, TangentIsTheDerivativeOfTheResidual) { EXPECT_LT(tangent_error(7), 1e-13); }

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
  const FlowErrors errors = uniform_flow_errors(6, 0.1);
  EXPECT_LT(errors.velocity, 1e-13);
  EXPECT_LT(errors.pressure, 1e-10);  // of rho u^2 = 490 Pa
}

// The profile and the pressure are in the spaces.
TEST(FlowSolver, PoiseuilleIsExact) {
  const FlowErrors errors = poiseuille_errors(4, false);
  EXPECT_LT(errors.velocity, 1e-8);  // the linear solver's tolerance
  EXPECT_LT(errors.pressure, 1e-8);
}

TEST(FlowSolver, WomersleyFlowConvergesWithSecondOrder) {
  const double coarse = womersley_errors({}, 12, FemScheme::bdf2, 0.1, 2).velocity;
  const double fine = womersley_errors({}, 12, FemScheme::bdf2, 0.05, 2).velocity;
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

// Liquid that leaves in the mean and enters at the axis alone, with 2 m/s: it is that which must not bring in energy.
TEST(OpenBoundary, LiquidThatEntersInPlacesIsPenalizedWhereTheMeanLeaves) {
  const BalloonMesh mesh = cylinder(4);
  const FlowSpace space(mesh);
  const OpenBoundary inlet(space, std::vector<bool>(static_cast<std::size_t>(space.node_count()), true));
  std::vector<double> velocity(static_cast<std::size_t>(space.size()), 0.0);
  for (const int node : space.nodes_on(Side::inlet)) {
    const bool axis = space.nodes()[static_cast<std::size_t>(node)][0] == 0;
    velocity[static_cast<std::size_t>(space.velocity(node, 1))] = axis ? 2 : -1;
  }
  EXPECT_LT(inlet.inflow(velocity), 0);
  EXPECT_EQ(inlet.entering_speed(velocity), 2);
  EXPECT_GT(inlet.powers(velocity, velocity).penalty, 0);
  for (double& u : velocity) u = -std::abs(u);
  EXPECT_EQ(inlet.entering_speed(velocity), 0);  // pure outflow needs no penalty
}

// The weak form tested with the velocity itself: powers balance to the tolerance of Newton's method.
class Powers : public testing::TestWithParam<bool> {};
TEST_P(Powers, AddUp) {
  const BalloonMesh mesh = cylinder(6);
  const FlowSpace space(mesh);
  FlowDefinition flow;
  flow.density = 1;
  flow.viscosity = 0.01;
  flow.position = MadeUpFlow::position;
  flow.mesh_velocity = MadeUpFlow::mesh_velocity;
  flow.inlet_pressure = [](double t) { return std::sin(5 * t); };
  flow.total_pressure = GetParam();
  FlowSolver solver(space, flow, tight());
  for (int k = 1; k <= 12; ++k) {
    solver.step_to(0.05 * k);
    const FlowBalance b = flow_balance(solver, [](const Point2&) { return Point2{}; });
    const double fed = b.wall_power + b.inlet_power - b.viscous_loss - b.upwind_loss - b.grad_div_loss - b.penalty_loss;
    EXPECT_NEAR(b.power_of_inertia, fed, 1e-7 * (std::abs(b.wall_power) + std::abs(b.inlet_power))) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Inlet, Powers, testing::Bool(),
                         [](const auto& given) { return given.param ? "total" : "fixed"; });

// Walls that all move as z/(1 + z_top) does draw liquid in and push it out. A pressure more at the inlet is one more
// everywhere, so total pressure lowers it by rho U^2/2 while liquid comes in, and changes no velocity.
TEST(FlowSolver, TotalPressureLacksTheMeanDynamicPressureOfInflow) {
  const BalloonMesh mesh = cylinder(4);
  const FlowSpace space(mesh);
  FlowDefinition flow = still(0.1);
  flow.density = 3;
  flow.position = [](const Point2& X, double t) { return Point2{X[0], X[1] * (1 + 0.2 * std::sin(t))}; };
  flow.mesh_velocity = [](const Point2& X, double t) { return Point2{0, X[1] * 0.2 * std::cos(t)}; };
  flow.inlet_pressure = [](double t) { return t; };
  FlowDefinition fed = flow;
  fed.total_pressure = true;
  FlowSolver fixed(space, flow, tight());
  FlowSolver total(space, fed, tight());
  for (int k = 1; k <= 30; ++k) {
    const double t = 0.1 * k;
    fixed.step_to(t);
    total.step_to(t);
    const double speed = 0.2 * std::cos(t);  // of the top, and of the mean over the inlet
    const double lacks = speed > 0 ? 1.5 * speed * speed : 0;
    for (int i = space.pressure(0); i < space.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_NEAR(total.solution()[at], fixed.solution()[at] - lacks, 2e-4 * 0.06)
          << t;  // the volume's difference formula
    }
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
  try {
    solver.step_to(1.5);
    ADD_FAILURE() << "the step was taken";
  } catch (const ComputationFailed& failure) {
    // the middle of the first of three cells each way, upside down
    EXPECT_STREQ(failure.what(), "a cell of the mesh is inverted at r = 0.167 m, z = -0.0833 m");
  }
  EXPECT_EQ(solver.time(), 0.5);
  EXPECT_EQ(solver.solution(), before);
  EXPECT_NO_THROW(solver.step_to(0.6));
}

}  // namespace
}  // namespace turgor
