#include "turgor/pressure/program.hpp"

#include <gtest/gtest.h>

#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

PressureProgram<double> sample_program() {
  return SegmentList<double>(100)
      .hold(1)
      .step(500)
      .ramp(2000, 2, RampShape::smooth)
      .ramp(0, 4, RampShape::linear)
      .build();
}

TEST(PressureProgram, FollowsItsSegments) {
  const auto p = sample_program();
  EXPECT_EQ(p(0), 100);
  EXPECT_EQ(p(0.999), 100);
  EXPECT_EQ(p(1), 500);  // the value after the jump
  EXPECT_DOUBLE_EQ(p(2), 1250);
  EXPECT_DOUBLE_EQ(p(5), 1000);
  EXPECT_EQ(p(7), 0);
  EXPECT_EQ(p(1e9), 0);
  EXPECT_EQ(p.knots(), (std::vector<double>{1, 3, 7}));
}

// The smooth ramp of the paper's figures: s = x^3 (10 - 15 x + 6 x^2) has zero slope and curvature at both ends.
TEST(PressureProgram, SmoothRampStartsWithItsThirdDerivative) {
  const auto program = sample_program();
  const auto& ramp = program.after(1.0);
  EXPECT_EQ(ramp.derivative(1, 1.0), 0);
  EXPECT_EQ(ramp.derivative(2, 1.0), 0);
  EXPECT_DOUBLE_EQ(ramp.derivative(3, 1.0), 60 * 1500 / 8.0);
  EXPECT_NEAR(ramp.derivative(1, 3.0), 0, 1e-9);
  EXPECT_NEAR(ramp.derivative(2, 3.0), 0, 1e-9);
  const double x = 0.3;
  EXPECT_NEAR(ramp(1 + 2 * x), 500 + 1500 * x * x * x * (10 - 15 * x + 6 * x * x), 1e-9);
}

// Central differences of one derivative give the next, to their own O(h^2).
TEST(PressureProgram, DerivativesAgreeWithDifferences) {
  const HarmonicPressure<double> harmonic{100, 700, 0.8, 0.4};
  const auto linear = table_pressure({0, 1, 2, 4}, {0, 300, 300, -100}, TableInterpolation::linear);
  const auto cubic = table_pressure({0, 1, 2, 4}, {0, 300, 350, 900}, TableInterpolation::cubic);
  const auto segments = sample_program();
  const std::vector<SmoothPressure<double>> smooth{SmoothPressure<double>(harmonic), segments.after(1.5),
                                                   linear.after(2.5), cubic.after(2.5)};
  constexpr double h = 1e-4;
  for (const auto& p : smooth) {
    for (const double t : {2.1, 2.6}) {
      for (int k = 0; k < 4; ++k) {
        const double difference = (p.derivative(k, t + h) - p.derivative(k, t - h)) / (2 * h);
        const double bound = 1e-4 * (1 + std::abs(p.derivative(k + 1, t)) + std::abs(p.derivative(k + 3, t)));
        EXPECT_NEAR(difference, p.derivative(k + 1, t), bound) << "derivative " << k + 1;
      }
    }
  }
}

TEST(PressureProgram, TablesPassThroughTheirPointsAndDoNotOvershoot) {
  const std::vector<double> t{0.5, 1, 2, 4, 4.5};
  const std::vector<double> p{0, 100, 100, -400, -380};
  for (const auto interpolation : {TableInterpolation::linear, TableInterpolation::cubic}) {
    const auto program = table_pressure(t, p, interpolation);
    for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(program(t[i]), p[i], 1e-12 * 400);
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
      for (double x = 0.05; x < 1; x += 0.05) {
        const double value = program(t[i] + x * (t[i + 1] - t[i]));
        EXPECT_GE(value, std::min(p[i], p[i + 1]) - 1e-9);
        EXPECT_LE(value, std::max(p[i], p[i + 1]) + 1e-9);
      }
    }
    EXPECT_EQ(program(0), 0);       // constant before the first point
    EXPECT_EQ(program(100), -380);  // and after the last
  }
}

// Two and three points are fewer than the library's spline wants; a straight line must stay one.
TEST(PressureProgram, ShortTablesWork) {
  const auto two = table_pressure({0, 2}, {10, 30}, TableInterpolation::cubic);
  EXPECT_DOUBLE_EQ(two(1.5), 25);
  const auto three = table_pressure({0, 1, 3}, {0, 10, 30}, TableInterpolation::cubic);
  EXPECT_DOUBLE_EQ(three(0.5), 5);
  EXPECT_DOUBLE_EQ(three(2.5), 25);
}

TEST(PressureProgram, RefusesTablesThatAreNone) {
  const auto table = [](std::vector<double> t, std::vector<double> p) {
    return table_pressure(t, p, TableInterpolation::linear);
  };
  EXPECT_THROW((void)table({0, 1}, {1}), InvalidInput);
  EXPECT_THROW((void)table({0}, {1}), InvalidInput);
  EXPECT_THROW((void)table({}, {}), InvalidInput);
  EXPECT_THROW((void)table({1, 0}, {1, 2}), InvalidInput);
  EXPECT_THROW((void)table({0, 0}, {1, 2}), InvalidInput);
  EXPECT_THROW((void)table({-1, 1}, {1, 2}), InvalidInput);
  EXPECT_THROW((void)table({0, NAN}, {1, 2}), InvalidInput);
}

TEST(PressureProgram, OtherUnitsAreTheSameProgram) {
  for (const auto& program : {sample_program(), harmonic_pressure(HarmonicPressure<double>{100, 700, 0.8, 0.4})}) {
    const auto scaled = program.in_units(250.0, 0.5);
    for (const double t : {0.0, 0.7, 1.0, 2.2, 6.0}) EXPECT_NEAR(scaled(t / 0.5) * 250, program(t), 1e-10);
  }
}

TEST(PressureProgram, KnowsItsRange) {
  const auto range = range_of(sample_program(), 100);
  EXPECT_EQ(range.least, 0);
  EXPECT_DOUBLE_EQ(range.greatest, 2000);
  EXPECT_DOUBLE_EQ(range_of(sample_program(), 2).greatest, 1250);
  const auto harmonic = range_of(harmonic_pressure(HarmonicPressure<double>{100, 700, 0.8, 0.4}), 10);
  EXPECT_EQ(harmonic.least, -600);
  EXPECT_EQ(harmonic.greatest, 800);
}

}  // namespace
}  // namespace turgor
