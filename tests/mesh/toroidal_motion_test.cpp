// The motion of the mesh with the balloon's radius.

#include "turgor/mesh/toroidal_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "../support/seed.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using std::numbers::pi;

double centre(double radius, double a) { return std::sqrt((radius - a) * (radius + a)); }

/// A place on the wall at angle theta from the axis, at the sphere's centre.
std::array<double, 2> on_wall(double theta, double radius, double a) {
  return {radius * std::sin(theta), centre(radius, a) + radius * std::cos(theta)};
}

struct Setting {
  double a;
  double reference;
  double radius;
  std::array<double, 2> place;  ///< somewhere in the balloon
};

Setting random_setting(std::mt19937_64& random) {
  Setting s{};
  s.a = std::exp(test::between(random, -6, 0));
  s.reference = s.a * std::exp(test::between(random, std::log(1.1), std::log(100)));
  s.radius = s.reference * test::between(random, 0.95, 2.5);
  do {
    s.place = on_wall(test::between(random, 0, pi), s.reference * std::cbrt(test::between(random, 0, 1)), 0);
    s.place[1] += centre(s.reference, s.a) - std::abs(s.place[1]) / 2;
  } while (s.place[1] <= 0 || std::hypot(s.place[0], s.place[1] - centre(s.reference, s.a)) > s.reference);
  return s;
}

TEST(ToroidalMotion, IsTheIdentityAtTheReferenceRadius) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random);
    const auto [r, z] = ToroidalMotion(s.a, s.reference).position(s.place, s.reference);
    // far from the orifice an angle of some a/r has rounding relative to itself
    EXPECT_NEAR(r, s.place[0], 1e-13 * s.place[0]);
    EXPECT_NEAR(z, s.place[1], 1e-13 * s.place[1]);
  }
}

TEST(ToroidalMotion, LosesNoDigitsBesideTheAxis) {
  const ToroidalMotion motion(0.03, 0.3);
  for (const double r : {1e-3, 1e-9, 1e-15}) {
    for (const double z : {1e-3, 0.1, 0.5}) {
      EXPECT_NEAR(motion.position({r, z}, 0.3)[0] / r, 1, 1e-13);
      // odd in r: its slope at the axis, up to (r/a)^2
      const double slope = motion.position({1e-12, z}, 0.5)[0] / 1e-12;
      EXPECT_NEAR(motion.position({r, z}, 0.5)[0] / r, slope, slope * (1e-12 + std::pow(r / 0.03, 2)));
    }
  }
}

// A map by complex numbers that rotates (a - x)/(a + x); it loses digits at the rim and far away, not in the middle.
TEST(ToroidalMotion, AgreesWithComplexNumbers) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random);
    const std::complex<double> x{s.place[0], s.place[1]};
    const std::complex<double> ratio = (s.a - x) / (s.a + x);
    const double scale = (pi - std::asin(s.a / s.radius)) / (pi - std::asin(s.a / s.reference));
    const std::complex<double> moved = std::polar(std::abs(ratio), scale * std::arg(ratio));
    const std::complex<double> expected = s.a * (1.0 - moved) / (1.0 + moved);
    const auto [r, z] = ToroidalMotion(s.a, s.reference).position(s.place, s.radius);
    // rounding of 1 + moved, which is some a/r
    EXPECT_NEAR(std::abs(std::complex<double>{r, z} - expected) / std::abs(expected), 0, 1e-15 * 20 * s.radius / s.a);
  }
}

TEST(ToroidalMotion, KeepsTheWallASphereThroughTheRim) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random);
    const double theta = test::between(random, 0, pi - std::asin(s.a / s.reference));
    const auto [r, z] = ToroidalMotion(s.a, s.reference).position(on_wall(theta, s.reference, s.a), s.radius);
    EXPECT_NEAR(std::hypot(r, z - centre(s.radius, s.a)), s.radius, 1e-13 * s.radius);
  }
}

TEST(ToroidalMotion, KeepsTheAxisTheOrificeAndTheChannel) {
  const ToroidalMotion motion(0.03, 0.3);
  for (const double radius : {0.2, 0.31, 0.9}) {
    for (const double z : {1e-12, 0.01, 0.3, 0.598}) {
      EXPECT_EQ(motion.position({0, z}, radius)[0], 0);
      EXPECT_EQ(motion.rate({0, z}, radius)[0], 0);
    }
    for (const std::array<double, 2>& X :
         {std::array{0.0, 0.0}, {0.01, 0.0}, {0.03, 0.0}, {0.03, -0.1}, {0.0, -0.5}, {0.02, -1e-9}}) {
      EXPECT_EQ(motion.position(X, radius), X);
      EXPECT_EQ(motion.rate(X, radius), (std::array{0.0, 0.0}));
    }
    // the map is continuous there, with slopes of order 1
    const auto [r, z] = motion.position({0.02, 1e-9}, radius);
    EXPECT_NEAR(r, 0.02, 1e-9);
    EXPECT_NEAR(z, 1e-9, 1e-9);
  }
}

// The angle about the rim is scaled, and distances from it stay, where these are much less than the orifice's radius.
TEST(ToroidalMotion, TurnsPlacesAtTheRim) {
  const double a = 0.03;
  const ToroidalMotion motion(a, 0.3);
  const double scale = (pi - std::asin(a / 0.6)) / (pi - std::asin(a / 0.3));
  // 2^-n, so that the place a - r is exact; distances and angles change by the order of their ratio to a
  for (const double distance : {0x1p-20, 0x1p-30, 0x1p-40}) {
    const auto [r, z] = motion.position({a, distance}, 0.6);
    EXPECT_NEAR(std::hypot(r - a, z), distance, distance * (2 * distance / a + 1e-16 / distance));
    EXPECT_NEAR(std::atan2(z, a - r), scale * pi / 2, 2 * distance / a + 1e-16 / distance);
  }
}

TEST(ToroidalMotion, TheRateIsTheDerivative) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random);
    const ToroidalMotion motion(s.a, s.reference);
    const double step = 1e-4 * std::min(s.radius, s.radius - s.a);
    const auto at = [&](double n) { return motion.position(s.place, s.radius + n * step); };
    const auto rate = motion.rate(s.place, s.radius);
    for (std::size_t k = 0; k < 2; ++k) {
      const double difference = (8 * (at(1)[k] - at(-1)[k]) - at(2)[k] + at(-2)[k]) / (12 * step);
      // of fourth order, so 1e-16 and rounding over the step: 1e-12 of the place's size
      EXPECT_NEAR(rate[k], difference, 1e-9 * (s.radius + std::abs(at(0)[1])) / std::min(s.radius, s.radius - s.a));
    }
  }
}

// The liquid there moves with the wall, which glides nowhere along itself.
TEST(ToroidalMotion, TheWallMovesAlongItsNormal) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random);
    const double theta = test::between(random, 0, pi - std::asin(s.a / s.radius));
    const ToroidalMotion motion(s.a, s.radius);
    const auto [across, along] = motion.rate(on_wall(theta, s.radius, s.a), s.radius);
    const double expected = 1 + s.radius / centre(s.radius, s.a) * std::cos(theta);
    const double size = 1 + s.radius / centre(s.radius, s.a);
    EXPECT_NEAR(across * std::sin(theta) + along * std::cos(theta), expected, 1e-12 * size);
    EXPECT_NEAR(across * std::cos(theta) - along * std::sin(theta), 0, 1e-12 * size);
  }
}

TEST(ToroidalMotion, RefusesSpheresThatDoNotReachTheRim) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double a : {0.0, -1.0, nan, HUGE_VAL}) EXPECT_THROW(ToroidalMotion(a, 1), InvalidInput);
  for (const double radius : {0.03, 0.01, nan, HUGE_VAL}) {
    EXPECT_THROW(ToroidalMotion(0.03, radius), InvalidInput);
    const ToroidalMotion motion(0.03, 0.3);
    EXPECT_THROW((void)motion.position({0.1, 0.1}, radius), InvalidInput);
    EXPECT_THROW((void)motion.rate({0.1, 0.1}, radius), InvalidInput);
  }
}

}  // namespace
}  // namespace turgor
