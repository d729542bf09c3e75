#include "turgor/flow/potential_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../src/flow/gauss_legendre.hpp"
#include "../support/flow.hpp"
#include "../support/reference.hpp"
#include "../support/seed.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<OutflowProfile> profiles() {
  return {OutflowProfile::uniform(), OutflowProfile::polynomial({1.25, 0, -0.5}),
          OutflowProfile::table({0, 0.5, 0.8, 0.9, 0.95, 1}, {1.27, 1.19, 0.98, 0.80, 0.65, 0})};
}

TEST(CapDepth, ReproducesTheReferenceValues) {
  for (const auto& entry : test::reference().at("epsilon")) {
    EXPECT_NEAR(cap_depth(test::fraction(entry.text("kappa"))), entry.value, 4e-16 * entry.value);
  }
}

// Where the series converges quickly. Its terms reach the size of the sources' strength, 4/eps times the cap's area.
TEST(PotentialFlow, IsTheLegendreSeries) {
  for (const OutflowProfile& profile : profiles()) {
    for (const double kappa : {0.01, 0.1, 0.5, 0.9}) {
      const PotentialFlow flow(kappa, profile);
      const Harmonics a = profile_harmonics(kappa, profile, 1500);
      for (const double r : {0.0, 1e-9, 0.3, 0.7, 0.97}) {
        for (const double theta : {0.0, 1e-9, 0.5, 1.4, 2.6, pi}) {
          if (-r * std::cos(theta) > 1 - flow.eps()) continue;
          const FlowField field = flow.at({r, theta});
          const FlowField sum = test::series(a, r, theta);
          const double size = 1e-12 * (1 + std::abs(sum.radial) + std::abs(sum.tangential) + std::abs(sum.potential));
          EXPECT_NEAR(field.potential, sum.potential, size) << kappa << " " << r << " " << theta;
          EXPECT_NEAR(field.radial, sum.radial, size) << kappa << " " << r << " " << theta;
          EXPECT_NEAR(field.tangential, sum.tangential, size) << kappa << " " << r << " " << theta;
          EXPECT_NEAR(field.potential_change, sum.potential_change, size / flow.eps()) << kappa << " " << r;
        }
      }
    }
  }
}

// The kernel does not know that the wall's velocity is 1: that every point of it, up to the rim, comes out so tests the
// whole integral. Its error is of the size of the tangential velocity's.
TEST(PotentialFlow, FollowsTheWallUpToTheRim) {
  for (const OutflowProfile& profile : profiles()) {
    for (const double kappa : {1e-4, 0.1, 0.7}) {
      for (const double tolerance : {1e-14, 1e-10, 1e-6}) {
        const PotentialFlow flow(kappa, profile, tolerance);
        for (double offset = 1e-12 * kappa; offset < flow.wall_angle(); offset *= 7) {
          const FlowField field = flow.on_wall(offset);
          EXPECT_NEAR(field.radial, 1, 20 * tolerance * (1 + std::abs(field.tangential))) << kappa << " " << offset;
        }
      }
    }
  }
}

// At the rim the normal velocity jumps by u - 1, so that the flow along the wall grows like (u - 1)/pi ln(distance).
TEST(PotentialFlow, HasALogarithmAtTheRim) {
  const double kappa = 0.2;
  const PotentialFlow flow(kappa);
  const double jump = 2 * (flow.eps() - 1) / flow.eps() - 1;
  const double growth = flow.on_wall(1e-9).tangential - flow.on_wall(1e-10).tangential;
  EXPECT_NEAR(std::abs(growth), std::abs(jump) / pi * std::log(10.0), 1e-6 * std::abs(jump));
}

TEST(PotentialFlow, KeepsToItsTolerance) {
  std::mt19937_64 random(test::random_seed());
  for (const double kappa : {0.003, 0.1, 0.5}) {
    const PotentialFlow reference(kappa, OutflowProfile::uniform(), 1e-15);
    for (const double tolerance : {1e-12, 1e-9, 1e-6}) {
      const PotentialFlow flow(kappa, OutflowProfile::uniform(), tolerance);
      for (int i = 0; i < 300; ++i) {
        // Points at all distances from the rim, 1e-6 kappa to 1, in all directions into the balloon.
        const double distance = std::exp(test::between(random, std::log(1e-6 * kappa), 0));
        const double direction = test::between(random, 0, pi);
        const double x = kappa + distance * std::cos(direction);
        const double z = -(1 - flow.eps()) + distance * std::sin(direction);
        const double r = std::hypot(x, z);
        if (r > 1 || z < -(1 - flow.eps()) || x < 0) continue;
        const FlowPoint point{r, std::atan2(x, z)};
        const FlowField a = flow.at(point);
        const FlowField b = reference.at(point);
        const double speed = std::hypot(b.radial, b.tangential);
        // The sources' strength at hand: what cancels in the velocity near a wall.
        const double size = speed + 2 / flow.eps() * std::pow(kappa / (kappa + distance), 2);
        EXPECT_NEAR(a.radial, b.radial, 10 * tolerance * size) << kappa << " " << distance << " " << direction;
        EXPECT_NEAR(a.tangential, b.tangential, 10 * tolerance * size) << kappa << " " << distance;
        EXPECT_NEAR(a.potential, b.potential, 10 * tolerance * (1 + kappa * size)) << kappa << " " << distance;
      }
    }
  }
}

struct Cartesian {
  double x, y, z;
};

/// Velocity about the balloon's centre at a place, z along the axis.
Cartesian velocity(const PotentialFlow& flow, const Cartesian& at) {
  const double axial = std::hypot(at.x, at.y);
  const double r = std::hypot(axial, at.z);
  const FlowField v = flow.at({r, std::atan2(axial, at.z)});
  const double sine = axial / r;
  const double cosine = at.z / r;
  const double outward = v.radial * sine + v.tangential * cosine;
  return {outward * at.x / axial, outward * at.y / axial, v.radial * cosine - v.tangential * sine};
}

// Through any closed surface inside flows nothing: spheres anywhere, by a product Gauss rule.
TEST(PotentialFlow, ConservesMass) {
  const GaussLegendre& rule = gauss_legendre(40);
  std::mt19937_64 random(test::random_seed());
  for (const OutflowProfile& profile : profiles()) {
    const double kappa = 0.15;
    const PotentialFlow flow(kappa, profile);
    for (int i = 0; i < 20; ++i) {
      const double radius = test::between(random, 0.05, 0.3);
      const double distance = test::between(random, 0, 0.97 - radius);
      const double tilt = test::between(random, 0, pi);
      if (-distance * std::cos(tilt) + radius > 0.9 * (1 - flow.eps())) continue;
      double flux = 0;
      double size = 0;
      for (std::size_t a = 0; a < rule.node.size(); ++a) {
        for (int b = 0; b < 80; ++b) {
          const double nz = 2 * rule.node[a] - 1;
          const double nr = std::sqrt(1 - nz * nz);
          const double phi = 2 * pi * (b + 0.5) / 80;
          const Cartesian n{nr * std::cos(phi), nr * std::sin(phi), nz};
          const Cartesian v = velocity(
              flow, {distance * std::sin(tilt) + radius * n.x, radius * n.y, distance * std::cos(tilt) + radius * n.z});
          const double through = v.x * n.x + v.y * n.y + v.z * n.z;
          flux += rule.weight[a] * through / 80;
          size += rule.weight[a] * std::abs(through) / 80;
        }
      }
      EXPECT_NEAR(flux, 0, 1e-12 * size) << radius << " " << distance << " " << tilt;
    }
  }
}

// What the moving wall displaces leaves through the plane of the orifice: pi kappa^2 mean(v_z) = 2 pi (2 - eps) -
// pi kappa^2/(1-eps) less what the centre's motion contributes; about the centre the plane itself moves.
TEST(PotentialFlow, LeavesThroughTheOrificeWhatTheWallDisplaces) {
  const GaussLegendre& rule = gauss_legendre(60);
  for (const OutflowProfile& profile : profiles()) {
    const double kappa = 0.3;
    const PotentialFlow flow(kappa, profile);
    const double height = 1 - flow.eps();
    double flux = 0;  // int v_z 2 x dx over the plane; x = kappa (1 - s^3) crowds at the rim
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double s = rule.node[i];
      const double x = kappa * (1 - s * s * s);
      const FlowField v = flow.at({std::hypot(x, height), std::atan2(x, -height)});
      const double r = std::hypot(x, height);
      flux += rule.weight[i] * 3 * s * s * kappa * 2 * x * (-v.radial * height / r - v.tangential * x / r);
    }
    // Balance over the ball cut off at the plane: wall's flux 2 pi (2 - eps) = flux through the plane.
    EXPECT_NEAR(flux, 2 * (2 - flow.eps()), 1e-8);
  }
}

// Velocities integrated along a way give the difference of the potential, and around a loop nothing.
TEST(PotentialFlow, IsTheGradientOfThePotential) {
  const GaussLegendre& rule = gauss_legendre(60);
  std::mt19937_64 random(test::random_seed());
  for (const OutflowProfile& profile : profiles()) {
    const double kappa = 0.15;
    const PotentialFlow flow(kappa, profile);
    for (int i = 0; i < 50; ++i) {
      const auto inside = [&] {
        const double r = test::between(random, 0.1, 0.85);
        const double tilt = test::between(random, 0.02, pi - 0.02);
        return Cartesian{r * std::sin(tilt), 0, r * std::cos(tilt)};
      };
      const Cartesian a = inside();
      const Cartesian b = inside();
      double work = 0;
      for (std::size_t k = 0; k < rule.node.size(); ++k) {
        const double s = rule.node[k];
        const Cartesian v = velocity(flow, {a.x + s * (b.x - a.x), 0, a.z + s * (b.z - a.z)});
        work += rule.weight[k] * (v.x * (b.x - a.x) + v.z * (b.z - a.z));
      }
      const auto potential = [&](const Cartesian& at) {
        return flow.at({std::hypot(at.x, at.z), std::atan2(at.x, at.z)}).potential;
      };
      EXPECT_NEAR(work, potential(b) - potential(a), 1e-11 * (1 + std::abs(potential(a)) + std::abs(potential(b))));
    }
  }
}

// Rellich's identity for a harmonic function on a sphere of radius a: a int (v_theta^2 - v_r^2) = int phi v_r.
TEST(PotentialFlow, ObeysRellichsIdentity) {
  const GaussLegendre& rule = gauss_legendre(128);
  for (const OutflowProfile& profile : profiles()) {
    const PotentialFlow flow(0.4, profile);
    const double a = 0.9;
    double difference = 0;
    double product = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const FlowField v = flow.at({a, std::acos(1 - 2 * rule.node[i])});
      difference += rule.weight[i] * a * (v.tangential * v.tangential - v.radial * v.radial);
      product += rule.weight[i] * v.potential * v.radial;
    }
    EXPECT_NEAR(difference, product, 1e-11 * product);
  }
}

TEST(PotentialFlow, RefusesPlacesOutsideTheBalloon) {
  const PotentialFlow flow(0.1);
  EXPECT_THROW((void)flow.at({1.001, 1}), InvalidInput);
  EXPECT_THROW((void)flow.at({-0.1, 1}), InvalidInput);
  EXPECT_THROW((void)flow.at({0.5, 4}), InvalidInput);
  EXPECT_THROW((void)flow.at({std::nan(""), 1}), InvalidInput);
  EXPECT_THROW((void)flow.at({0.999, pi}), InvalidInput);                 // in the channel
  EXPECT_THROW((void)flow.at({1, pi - flow.cap_angle()}), InvalidInput);  // the rim
  EXPECT_THROW((void)flow.on_wall(0), InvalidInput);
  EXPECT_THROW((void)flow.on_wall(3.1), InvalidInput);
  for (const double kappa : {0.0, 1.0, 1.5, -0.1, std::nan("")}) EXPECT_THROW(PotentialFlow{kappa}, InvalidInput);
  EXPECT_THROW(PotentialFlow(0.1, OutflowProfile::uniform(), 1e-17), InvalidInput);
}

}  // namespace
}  // namespace turgor
