#include "turgor/motion/prescribed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace turgor {
namespace {

/// Up and down again through zero, with a linear and a smooth turn, and a rest at the end.
SegmentList<double> sample_velocity() {
  return SegmentList<double>(0)
      .ramp(0.02, 0.5, RampShape::smooth)
      .hold(1)
      .ramp(-0.03, 0.4, RampShape::linear)
      .ramp(0.01, 0.7, RampShape::smooth)
      .ramp(0, 0.25, RampShape::smooth)
      .hold(2);
}

// The smooth velocity and its integral by hand, S = 10 x^3 - 15 x^4 + 6 x^5, to an ulp or two of the radius and of the
// largest terms of the velocity.
TEST(PrescribedMotion, IntegratesItsVelocity) {
  const PrescribedMotion<double> motion(0.3, sample_velocity());
  for (const double x : {0.0, 0.1, 0.37, 0.5, 0.99}) {
    const auto state = motion.at(0.5 * x);
    const double x3 = x * x * x;
    EXPECT_NEAR(state.radius, 0.3 + 0.02 * 0.5 * x3 * x * (2.5 - 3 * x + x * x), 1e-16);
    EXPECT_NEAR(state.rate, 0.02 * x3 * (10 - 15 * x + 6 * x * x), 1e-16);
    EXPECT_NEAR(state.acceleration, 0.02 / 0.5 * 30 * x * x * (1 - x) * (1 - x), 1e-15);
  }
  // every ramp covers half the sum of its velocities times its duration
  EXPECT_NEAR(motion.at(0.5).radius, 0.305, 1e-16);
  EXPECT_NEAR(motion.at(1.5).radius, 0.325, 1e-16);
  EXPECT_NEAR(motion.at(1.9).radius, 0.323, 1e-16);
  EXPECT_NEAR(motion.at(2.6).radius, 0.316, 1e-16);
  EXPECT_NEAR(motion.at(2.85).radius, 0.31725, 1e-16);
  EXPECT_NEAR(motion.at(1e6).radius, 0.31725, 1e-16);
  EXPECT_DOUBLE_EQ(motion.end(), 4.85);
}

// Central differences with h = 1e-4: their own error is h^2/6 times a third derivative, at most 25 m/s^4 here for the
// velocity (60 rise/duration^3) and 0.5 m/s^3 for the radius; rounding adds 1e-12.
TEST(PrescribedMotion, RateAndAccelerationAreDerivatives) {
  const PrescribedMotion<double> motion(0.3, sample_velocity());
  constexpr double h = 1e-4;
  for (const double t : {0.1, 0.25, 0.45, 1.0, 1.7, 2.0, 2.3, 2.55, 2.7, 3.0}) {
    const auto before = motion.at(t - h);
    const auto after = motion.at(t + h);
    EXPECT_NEAR((after.radius - before.radius) / (2 * h), motion.at(t).rate, 2e-9) << t;
    EXPECT_NEAR((after.rate - before.rate) / (2 * h), motion.at(t).acceleration, 5e-8) << t;
  }
}

TEST(PrescribedMotion, KnowsItsDirection) {
  const PrescribedMotion<double> motion(0.3, sample_velocity());
  EXPECT_EQ(motion.at(0).regime, Regime::inflating);  // still, but about to move
  EXPECT_EQ(motion.at(1.2).regime, Regime::inflating);
  const double turn = 1.5 + 0.4 * 0.02 / 0.05;  // the straight line from 0.02 to -0.03 m/s
  EXPECT_EQ(motion.at(turn - 1e-12).regime, Regime::inflating);
  EXPECT_EQ(motion.at(turn + 1e-12).regime, Regime::deflating);
  EXPECT_EQ(motion.at(2.85).regime, Regime::rest);
  EXPECT_EQ(motion.at(1e6).regime, Regime::rest);
  for (const auto& in : motion.intervals(6.0)) {
    const double sign = static_cast<int>(in.phase.regime);
    for (double x = 0.01; x < 1; x += 0.01) {
      const double rate = motion.within(in.phase, in.begin + x * (in.end - in.begin)).rate;
      EXPECT_TRUE(sign == 0 ? rate == 0 : sign * rate > 0) << in.begin << " + " << x;
    }
  }
}

// A velocity that ends at zero is a sum of coefficients that cancel to rounding only; the direction must not follow
// that.
TEST(PrescribedMotion, DirectionIsFreeOfRounding) {
  for (const double speed : {0.02, -0.02, 0.1 / 3, -0.7}) {
    const PrescribedMotion<double> motion(1, SegmentList<double>(speed).ramp(0, 0.3, RampShape::smooth).hold(1));
    for (double t = 0.3 - 1e-9; t < 0.3; t += 1e-12) {
      ASSERT_EQ(motion.at(t).regime, speed > 0 ? Regime::inflating : Regime::deflating);
    }
  }
}

// At a turn with an acceleration the regime is the one after it.
TEST(PrescribedMotion, ATurnBelongsToWhatFollows) {
  const PrescribedMotion<double> motion(
      1, SegmentList<double>(0.5).ramp(0, 1, RampShape::linear).ramp(-0.5, 1, RampShape::linear));
  EXPECT_EQ(motion.at(1).rate, 0);
  EXPECT_EQ(motion.at(1).acceleration, -0.5);
  EXPECT_EQ(motion.at(1).regime, Regime::deflating);
}

TEST(PrescribedMotion, KnowsItsRange) {
  const PrescribedMotion<double> motion(0.3, sample_velocity());
  const auto range = range_of(motion, 10.0);
  EXPECT_EQ(range.least, 0.3);
  EXPECT_EQ(range.least_time, 0);
  EXPECT_DOUBLE_EQ(range.greatest, 0.325 + 0.16 * 0.02 / 2);
  EXPECT_DOUBLE_EQ(range.greatest_time, 1.66);
  EXPECT_DOUBLE_EQ(range_of(motion, 1.0).greatest, 0.315);
  EXPECT_EQ(range_of(motion, 1.0).greatest_time, 1);
}

TEST(PrescribedMotion, KnowsWhenALevelIsReached) {
  const PrescribedMotion<double> falling(0.3, SegmentList<double>(-0.2).hold(1));
  EXPECT_NEAR(*first_time_not_above(falling, 0.03, 6.0), 1.35, 1e-15);
  EXPECT_EQ(first_time_not_above(falling, 0.03, 1.3), std::nullopt);
  EXPECT_EQ(first_time_not_above(falling, 0.4, 1.3), 0);
  const PrescribedMotion<double> touching(0.3, sample_velocity());
  EXPECT_EQ(first_time_not_above(touching, 0.3, 6.0), 0);
  EXPECT_EQ(first_time_not_above(touching, 0.299, 6.0), std::nullopt);
}

TEST(PrescribedMotion, RefusesAJumpOfVelocity) {
  EXPECT_THROW(PrescribedMotion<double>(0.3, SegmentList<double>(0).hold(1).step(0.1).hold(1)), InvalidInput);
  EXPECT_NO_THROW(PrescribedMotion<double>(0.3, SegmentList<double>(0.1).hold(1).step(0.1).hold(1)));
}

}  // namespace
}  // namespace turgor
