// Lambert's map and the algebraic decay, against exact half-cycles.

#include "turgor/asymptotics/decay.hpp"

#include <gtest/gtest.h>

#include "motions.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using Long = long double;
using test::middle_pressure;

FreeMotion motion(double C2) { return {test::orifice_balloon(0.2233, C2), middle_pressure, 1.3}; }

/// Below the equilibrium after deflation from x above it, exactly.
double exact_undershoot(double C2, double x) {
  const auto oscillator = test::orifice_balloon<Long>(0.2233, C2, middle_pressure);
  const Long R_eq = motion(C2).equilibrium();
  return static_cast<double>(R_eq - test::exact_turn<Long>(oscillator, R_eq + static_cast<Long>(x)).stretch);
}

// Lambert's map solves (1 - Y) e^Y = (1 + X) e^-X; near X = 0, where W0 has its branch point, Y = X - 2/3 X^2 + 4/9
// X^3.
TEST(Decay, MapSolvesItsEquationForEveryAmplitude) {
  const Decay decay(motion(500));
  const double unit = 1 / (2 * decay.beta());
  for (const double X : {1e-3, 0.5, 0.999, 1.001, 3.0, 10.0}) {
    const double Y = decay.undershoot(X * unit).value / unit;
    EXPECT_NEAR(std::log1p(-Y) + Y, std::log1p(X) - X, 1e-14 + 1e-15 / (1 - Y)) << X;  // rounding of Y
  }
  for (const double X : {1e-12, 1e-8, 1e-5, 0.99e-3, 1.01e-3}) {
    const double Y = decay.undershoot(X * unit).value / unit;
    const double series = 2.0 / 3 - X * (4.0 / 9 - X * 44 / 135);
    EXPECT_NEAR((X - Y) / (X * X), series, X * X * X + 1e-15 / X) << X;  // next term, rounding of X
  }
  EXPECT_EQ(decay.undershoot(1e300).value, unit);
  EXPECT_EQ(decay.greatest_undershoot().value, unit);
}

// At fixed X = 2 beta x only F'' and beta' are left out: an error falling like 1/beta, and its square once corrected.
TEST(Decay, MapIsExactAsAmplitudesVanish) {
  for (const double X : {0.05, 0.7, 4.0, 20.0}) {
    const auto errors = [&](double C2) {
      const Decay decay(motion(C2));
      const double x = X / (2 * decay.beta());
      const double exact = exact_undershoot(C2, x);
      const Estimate y = decay.undershoot(x);
      EXPECT_NEAR(y.error / std::abs(y.value - exact), 1, 0.05) << X;
      return std::array{std::abs(y.value / exact - 1), std::abs(decay.corrected_undershoot(x).value / exact - 1)};
    };
    const auto coarse = errors(500);
    const auto fine = errors(2000);
    EXPECT_NEAR(test::order(coarse[0], fine[0], 4), 1, 0.05) << X;
    // At X = 0.05 the amplitude is 5e-7, and the rounding of R_eq as great as what the correction leaves.
    if (X > 0.1) {
      EXPECT_NEAR(test::order(coarse[1], fine[1], 4), 2, 0.1) << X;
    }
  }
}

// For X << 1 only F'' is left: x loses F''/(3 F') x^2 more than the map says.
TEST(Decay, SmallAmplitudesFeelOnlyTheCurvatureOfTheForce) {
  const Decay decay(motion(500));
  for (const double X : {5e-4, 2e-3}) {
    const double x = X / (2 * decay.beta());
    const double exact = exact_undershoot(500, x);
    EXPECT_NEAR(decay.undershoot(x).error / std::abs(decay.undershoot(x).value - exact), 1, 0.01) << X;
  }
}

TEST(Decay, LargeAmplitudesAllEndAlike) {
  const double C2 = 2000;
  const Estimate universal = Decay(motion(C2)).greatest_undershoot();
  for (const double x : {0.02, 0.1, 0.5}) {
    EXPECT_NEAR(exact_undershoot(C2, x), universal.value, 1.1 * universal.error) << x;
  }
}

// n e_n -> 3/(4 beta), by exact half-cycles of the balloon with a channel.
TEST(Decay, AmplitudesFallLikeOneOverTheNumberOfCycles) {
  const auto oscillator = test::channel_balloon(40.681720734041306, 179.04931097838227);
  const FreeMotion about(oscillator, middle_pressure, 4.8);
  const Decay decay(about);
  SimulationOptions<double> options;
  options.max_events = 600;
  const auto motion = simulate_by_quadrature(oscillator, 0.0, 5.0, 0.0, 1e6, options);
  ASSERT_EQ(motion.events.size(), 600U);
  for (const long n : {1L, 3L, 30L, 300L}) {
    const double exact = motion.events[static_cast<std::size_t>(2 * n - 1)].stretch - about.equilibrium();
    const Estimate e = decay.amplitude(5.0 - about.equilibrium(), n);
    EXPECT_NEAR(e.error, std::abs(e.value - exact), 0.1 * e.error + 1e-14) << n;
    EXPECT_LT(e.error, 1e-3 * exact) << n;
    EXPECT_NEAR(static_cast<double>(n) * exact * 4 * decay.beta() / 3, 1, 1.0 / static_cast<double>(n)) << n;
  }
  const double measured = motion.events[599].time - motion.events[597].time;
  EXPECT_NEAR(measured, decay.cycle_time(), 1e-4 * measured);  // slower by (beta x)^2/6 = 4e-7, and event times to 1e-6
}

// A million cycles are no work: the law of the first thousand goes on.
TEST(Decay, ManyCyclesFollowTheLaw) {
  const Decay decay(motion(500));
  const double far = decay.amplitude(0.05, 1000000).value;
  EXPECT_NEAR(1e6 * far * 4 * decay.beta() / 3, 1, 1e-5);
  EXPECT_NEAR(decay.cycles_until(1.0, far), 1e6, 10);
  EXPECT_EQ(decay.cycles_until(1e-3, 2e-3), 0);
  EXPECT_EQ(decay.amplitude(0.05, 0).value, 0.05);
}

TEST(Decay, HoldsForTheFullModel) {
  const auto p = test::paper_balloon(0.03, 0.05);
  const Oscillator<double> oscillator(Model::full, p, constant_pressure(6000 * middle_pressure), {0.3, 6000, 1});
  const FreeMotion about(oscillator, middle_pressure, 1.3);
  const Decay decay(about);
  for (const double X : {0.3, 3.0}) {
    const double x = X / (2 * decay.beta());
    const double exact = about.equilibrium() - test::exact_turn(oscillator, about.equilibrium() + x).stretch;
    EXPECT_NEAR(decay.undershoot(x).error, std::abs(decay.undershoot(x).value - exact),
                0.1 * decay.undershoot(x).error);
    EXPECT_NEAR(decay.corrected_undershoot(x).value, exact, 3 * decay.corrected_undershoot(x).error + 1e-13);
  }
}

TEST(Decay, RefusesWhatIsNoAmplitude) {
  const Decay decay(motion(500));
  for (const double x : {0.0, -1e-3, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)decay.undershoot(x), InvalidInput) << x;
    EXPECT_THROW((void)decay.amplitude(x, 3), InvalidInput) << x;
  }
  EXPECT_THROW((void)decay.amplitude(0.1, -1), InvalidInput);
}

}  // namespace
}  // namespace turgor
