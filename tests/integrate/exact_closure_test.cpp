// Motion with an exact closure: two ways to follow it, and the ends of the range in which it is known.

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "../support/same_motion.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::expect_same;
using test::paper_balloon;
using test::si_scales;

SimulationOptions<double> at_tolerance(double tolerance) {
  SimulationOptions<double> options;
  options.rtol = options.atol = tolerance;
  return options;
}

// At wide orifices the factors of an exact closure vary a lot along the way, and inflation through a channel is not
// free of damping. r_ch/r stays within one binade, where the factors are smooth to the last digit of long double.
TEST(ExactClosureMotion, IsTheSameSteppedAndByQuadrature) {
  for (const Model model : {Model::full, Model::orifice, Model::long_channel}) {
    for (const Closure closure : {Closure::potential, Closure::profile, Closure::calibrated}) {
      const auto p =
          test::with_closure(paper_balloon<long double>(0.135L, model == Model::orifice ? 0 : 0.4L), closure);
      const auto program = SegmentList<long double>(36e3L).hold(0.7L).step(42e3L).hold(1).step(-5e3L).build();
      const Oscillator<long double> oscillator(model, p, program, si_scales(p));
      expect_same(oscillator, 1.1L, 0, 1.9L, {}, Outcome::reached_end);
      expect_same(oscillator, 1.2L, -0.3L, 1.9L, {}, Outcome::reached_end);
    }
  }
}

// Between binades the factors jump in their last digit of double precision; there r_ch/r = 1/2 at R = 1.2.
TEST(ExactClosureMotion, CrossesTheBinadesOfTheTable) {
  const auto p = test::with_closure(paper_balloon<double>(0.18, 0.4), Closure::potential);
  const auto program = SegmentList<double>(36e3).hold(0.7).step(42e3).hold(1).step(-5e3).build();
  const Oscillator<double> oscillator(Model::full, p, program, si_scales(p));
  const auto stepped = simulate(oscillator, 0.0, 1.1, 0.0, 1.9, at_tolerance(1e-12));
  const auto exact = simulate_by_quadrature(oscillator, 0.0, 1.1, 0.0, 1.9, at_tolerance(1e-12));
  EXPECT_EQ(stepped.outcome, Outcome::reached_end);
  EXPECT_EQ(exact.outcome, Outcome::reached_end) << exact.message;
  EXPECT_EQ(stepped.events.size(), exact.events.size());
  EXPECT_NEAR(stepped.last.stretch, exact.last.stretch, 1e-9);
}

// A balloon that is sucked empty shrinks to its orifice: there the closure ends, and both methods say where and why.
TEST(ExactClosureMotion, StopsWhereTheOrificeIsTooWideForTheTable) {
  const auto p = test::with_closure(paper_balloon<double>(0.15, 0.4), Closure::potential);
  for (const Model model : {Model::full, Model::long_channel}) {
    const Oscillator<double> oscillator(model, p, constant_pressure(-1e6), si_scales(p));
    const auto stepped = simulate(oscillator, 0.0, 1.0, 0.0, 10.0, at_tolerance(1e-10));
    const auto exact = simulate_by_quadrature(oscillator, 0.0, 1.0, 0.0, 10.0, at_tolerance(1e-10));
    for (const auto& t : {stepped, exact}) {
      EXPECT_EQ(t.outcome, Outcome::closure_end);
      EXPECT_FALSE(is_complete(t.outcome));
      EXPECT_NE(t.message.find("R fell to r_ch/(0.75 r0) = 0.666667"), std::string::npos) << t.message;
      EXPECT_NE(t.message.find("\"potential\""), std::string::npos) << t.message;
      EXPECT_NEAR(t.last.stretch, 0.5 / 0.75, 1e-9);
      EXPECT_TRUE(std::isfinite(t.last.rate));
      for (const auto& step : t.steps) EXPECT_TRUE(std::isfinite(step.stretch_at(0.5) + step.rate_at(0.5)));
    }
    EXPECT_NEAR(stepped.last.time, exact.last.time, 1e-9);
    EXPECT_NEAR(stepped.last.rate, exact.last.rate, 1e-7);
  }
}

// At the other end the opening is a pinhole: inflation, which knows of none, passes it, deflation cannot begin.
TEST(ExactClosureMotion, StopsWhereTheOrificeIsTooNarrowForTheTable) {
  const auto p = test::with_closure(paper_balloon<double>(0.3 * 0x1p-17 * 1.05, 0.0), Closure::potential);
  const Oscillator<double> oscillator(Model::full, p, constant_pressure(40e3), si_scales(p));
  for (const auto& method : {&simulate<double>, &simulate_by_quadrature<double>}) {
    const auto t = method(oscillator, 0.0, 1.0, 0.0, 1.0, at_tolerance(1e-8));
    EXPECT_EQ(t.outcome, Outcome::closure_end);
    EXPECT_NE(t.message.find("R reached 2^17 r_ch/r0 = 1.05"), std::string::npos) << t.message;
    EXPECT_GT(t.last.stretch, 1.05);
    EXPECT_EQ(t.last.rate, 0);
  }
}

TEST(ExactClosureMotion, DoesNotStartBeyondTheTable) {
  const auto p = test::with_closure(paper_balloon<double>(0.15, 0.0), Closure::potential);
  const Oscillator<double> oscillator(Model::orifice, p, constant_pressure(0.0), si_scales(p));
  for (const auto& method : {&simulate<double>, &simulate_by_quadrature<double>}) {
    for (const double start : {0.66, 0.5 * 0x1p17 * 1.01}) {
      try {
        (void)method(oscillator, 0.0, start, 0.0, 1.0, {});
        FAIL() << start << " was accepted";
      } catch (const InvalidInput& error) {
        EXPECT_EQ(error.issues().front().key, "initial.stretch");
        const std::string text = error.what();
        EXPECT_NE(text.find("must be from 0.66666667 to 65536"), std::string::npos) << text;
        EXPECT_NE(text.find("inlet.orifice_radius"), std::string::npos) << text;
      }
    }
    EXPECT_EQ(method(oscillator, 0.0, 0.67, 0.0, 1e-3, {}).outcome, Outcome::reached_end);
  }
}

}  // namespace
}  // namespace turgor
