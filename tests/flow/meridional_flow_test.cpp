// The flow on a mesh of the meridional plane, its stream function and its streamlines.

#include "turgor/flow/meridional_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/flow/pressure.hpp"

namespace turgor {
namespace {

TEST(MeridionalMesh, NodesLieInTheBalloonButNotOnTheRim) {
  for (const double kappa : {1e-6, 0.01, 0.1, 0.7, 0.9999}) {
    const MeridionalMesh mesh(kappa, 40);
    const double centre = 1 - cap_depth(kappa);
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      for (std::size_t j = 0; j < mesh.size(); ++j) {
        const MeridionalPoint p = mesh.node(i, j);
        EXPECT_GE(p.height, 0);
        EXPECT_GE(p.distance, 0);
        // rounding of the coordinates, which are of order 1
        EXPECT_LE(std::hypot(p.distance, p.height - centre), 1 + 1e-14);
        // 0.1 % of r_ch, up to the rim's curvature
        EXPECT_GT(std::hypot(p.distance - kappa, p.height), 0.99 * MeridionalMesh::rim_gap * kappa);
      }
      const MeridionalPoint wall = mesh.node(0, i);
      EXPECT_NEAR(std::hypot(wall.distance, wall.height - centre), 1, 1e-14);
      EXPECT_EQ(mesh.node(mesh.cells(), i).height, 0);
      EXPECT_EQ(mesh.node(i, 0).distance, 0);
    }
  }
  EXPECT_THROW(MeridionalMesh(0, 40), InvalidInput);
  EXPECT_THROW(MeridionalMesh(1, 40), InvalidInput);
  EXPECT_THROW(MeridionalMesh(0.1, 3), InvalidInput);
}

TEST(MeridionalMesh, FindsPlacesBetweenNodes) {
  const MeridionalMesh mesh(0.1, 40);
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, std::size_t{39}}) {
    for (const std::size_t j : {std::size_t{0}, std::size_t{13}, std::size_t{40}}) {
      const auto [row, column] = mesh.place(mesh.node(i, j));
      EXPECT_NEAR(row, static_cast<double>(i), 1e-9);  // nodes near the rim have lost six digits
      EXPECT_NEAR(column, static_cast<double>(j), 1e-9);
    }
  }
  EXPECT_EQ(mesh.place({0, 3}).row, 0);  // beyond the pole
  EXPECT_EQ(mesh.place({0.1, 1e-9}).column, 40);
}

// What flows through the wall above a circle on it is the volume that the wall sweeps there, in closed form.
TEST(MeridionalFlow, StreamFunctionOnTheWallIsTheVolumeSwept) {
  for (const double kappa : {0.01, 0.1, 0.7}) {
    const PotentialFlow flow(kappa, OutflowProfile::uniform(), 1e-10);
    const MeridionalFlow field(flow, 100);
    for (std::size_t j = 0; j < field.mesh().size(); ++j) {
      const auto& node = field.node(0, j);
      const double sine = std::sin(node.polar.theta);
      const double swept = 1 - std::cos(node.polar.theta) + sine * sine * field.centre_speed() / 2;
      // fourth order: 1e-6 for 100 cells, 16 times less for 200
      EXPECT_NEAR(node.stream_function, swept, 3e-6 * field.total_stream()) << kappa << " " << j;
    }
  }
}

// Streamlines come from the stream function alone, the velocity at their middles from the flow.
TEST(MeridionalFlow, StreamLinesFollowTheVelocity) {
  const PotentialFlow flow(0.1, OutflowProfile::polynomial({2, 0, -2}), 1e-10);
  const MeridionalFlow field(flow, 200);
  for (const double share : {0.05, 0.5, 0.9}) {
    const auto line = field.stream_line(share);
    ASSERT_EQ(line.size(), 201U);
    EXPECT_EQ(line.back().height, 0);
    for (std::size_t i = 1; i + 2 < line.size(); i += 7) {
      const double across = line[i + 1].distance - line[i].distance;
      const double along = line[i + 1].height - line[i].height;
      const double distance = (line[i + 1].distance + line[i].distance) / 2;
      const double height = (line[i + 1].height + line[i].height) / 2 - (1 - flow.eps());
      const double theta = std::atan2(distance, height);
      const FlowField v = flow.at({std::hypot(distance, height), theta});
      const double v_across = v.radial * std::sin(theta) + v.tangential * std::cos(theta);
      const double v_along = v.radial * std::cos(theta) - v.tangential * std::sin(theta) + field.centre_speed();
      const double turn =
          (across * v_along - along * v_across) / std::hypot(across, along) / std::hypot(v_across, v_along);
      EXPECT_NEAR(turn, 0, 2e-3) << share << " " << i;  // of second order in the steps, up to 2 % of r
    }
  }
}

// The axis and the centre are no special places.
TEST(MeridionalFlow, TheFieldIsContinuousAtTheAxisAndTheCentre) {
  const PotentialFlow flow(0.1);
  const FlowState<double> state{0.3, -0.03, 0.1, 0, 0.03, 0, 1000};
  const PressureField pressure(flow, state);
  for (const double radius : {0.5, 0.9, 1 - flow.eps()}) {
    const FlowPoint on{radius, std::numbers::pi};
    const FlowPoint beside{radius - 1e-9, std::numbers::pi - 1e-9};
    const FlowField a = flow.at(on);
    const FlowField b = flow.at(beside);
    const double size = std::abs(a.radial);
    EXPECT_NEAR(a.tangential, 0, 1e-12 * size);
    EXPECT_NEAR(a.radial, b.radial, 1e-6 * size);  // 1e-9 times slopes of some 1/kappa
    EXPECT_NEAR(a.potential_change, b.potential_change, 1e-6 * std::abs(a.potential_change));
    const double dynamic = state.fluid_density * std::pow(state.radial_rate * size, 2);
    EXPECT_NEAR(pressure.at(on, a), pressure.at(beside, b), 1e-6 * dynamic);
  }
  EXPECT_NEAR(flow.at_orifice().tangential, 0, 1e-12 * std::abs(flow.at_orifice().radial));
  for (const double theta : {0.3, 1.5, 2.5}) {
    const FlowField centre = flow.at({0, theta});
    const FlowField beside = flow.at({1e-9, theta});
    EXPECT_NEAR(centre.radial, beside.radial, 1e-7);
    EXPECT_NEAR(centre.tangential, beside.tangential, 1e-7);
    EXPECT_NEAR(centre.potential, beside.potential, 1e-7);
  }
}

}  // namespace
}  // namespace turgor
