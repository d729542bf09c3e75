// The slow manifold and the deflation that follows it, against exact motion.

#include "turgor/asymptotics/slow_deflation.hpp"

#include <gtest/gtest.h>

#include "../support/reference.hpp"
#include "motions.hpp"
#include "turgor/asymptotics/decay.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::middle_pressure;

FreeMotion small_well(double C2, double C1 = 0.2233) { return {test::orifice_balloon(C1, C2), middle_pressure, 1.3}; }

// By quadrature from far above: the layer is long forgotten. Halving delta divides the errors by 4 and 8 relative to
// (dR/dT)^2 ~ delta, of which one factor is that of the rate itself.
TEST(SlowManifold, EachTermGainsAnOrder) {
  const auto errors = [](double C2) {
    const auto oscillator = test::orifice_balloon<long double>(0.2233, C2, middle_pressure);
    const auto motion = test::exact<long double>(oscillator, 1.5, 0.2L * std::sqrt(C2));
    const auto v = static_cast<double>(motion.last.rate);
    const SlowManifold w = slow_manifold(small_well(C2), static_cast<double>(motion.last.stretch));
    return std::array{std::abs(w.leading / (v * v) - 1), std::abs((w.leading + w.correction) / (v * v) - 1),
                      std::abs((w.leading + w.correction + w.next) / (v * v) - 1)};
  };
  const auto coarse = errors(800);
  const auto fine = errors(1600);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(test::order(coarse[i], fine[i], 2), static_cast<double>(i + 1), 0.1) << i;
  }
}

// (3.21) as the paper writes it.
TEST(SlowManifold, LeadingTermIsThePapers) {
  const FreeMotion motion = small_well(500, 0.7);
  for (const double R : {1.3, 1.6, 1.9}) {
    const auto r = [&](int n) { return std::pow(R, -n); };
    const double expected = 0.7 / 500 * (10 * (r(5) - r(11)) + r(3) - r(9) - r(4) * middle_pressure);
    EXPECT_NEAR(slow_manifold(motion, R).leading, expected, 1e-15);
    const double h = 1e-5;  // the others by differences
    const auto slope = [&](auto term) {
      return (slow_manifold(motion, R + h).*term - slow_manifold(motion, R - h).*term) / (2 * h) / (2 * 500 * R * R);
    };
    EXPECT_NEAR(slow_manifold(motion, R).correction, slope(&SlowManifold::leading), 1e-14);
    EXPECT_NEAR(slow_manifold(motion, R).next, slope(&SlowManifold::correction),
                1e-8 * std::abs(slow_manifold(motion, R).next));
  }
}

TEST(SlowDeflation, TransitionReproducesTheReferenceValues) {
  for (const auto& entry : test::reference().at("T_di_exact")) {
    const bool channel = entry.input("C2") < 1000;
    const auto oscillator = channel ? test::channel_balloon(entry.input("C1"), entry.input("C2"), entry.input("P0"))
                                    : test::orifice_balloon(entry.input("C1"), entry.input("C2"), entry.input("P0"));
    const SlowDeflation deflation(FreeMotion(oscillator, entry.input("P0"), 4.8), entry.input("R_i"));
    const Estimate T = deflation.transition_time();
    EXPECT_NEAR(T.value, entry.value, 2 * T.error) << entry.inputs;
    EXPECT_LT(T.error, 2e-7 * entry.value) << entry.inputs;
    for (const auto& end : test::reference().at("R_at_T_di_exact")) {
      if (end.inputs != entry.inputs) continue;
      const Estimate R = deflation.turning_point();
      EXPECT_NEAR(R.value, end.value, 1.1 * R.error) << entry.inputs;
      EXPECT_LT(R.error, 3e-8) << entry.inputs;
    }
  }
}

// Through the layer, the slow motion and the turning point, from everywhere between the equilibria.
TEST(SlowDeflation, KnowsItsErrorAtAllTimes) {
  const double C2 = 1000;
  const auto oscillator = test::orifice_balloon<long double>(0.2233, C2, middle_pressure);
  for (const double start : {1.2595, 1.27, 1.35, 1.6, 1.9, 1.99}) {
    const SlowDeflation deflation(small_well(C2), start);
    const double end = static_cast<double>(test::exact_turn<long double>(oscillator, start).time);
    EXPECT_NEAR(deflation.transition_time().value, end, 1.1 * deflation.transition_time().error) << start;
    EXPECT_LT(deflation.transition_time().error, 1e-3 * end);
    for (const double part : {1e-4, 0.01, 0.1, 0.5, 0.9, 0.999}) {
      const Estimate R = deflation.at(part * end);
      const double exact = test::exact_stretch<long double>(oscillator, start, part * end);
      EXPECT_NEAR(R.value, exact, 1.2 * R.error + 2e-15) << start << " " << part;
      EXPECT_LT(R.error, 1e-5) << start << " " << part;
    }
  }
}

TEST(SlowDeflation, StaysAtItsTurningPoint) {
  const SlowDeflation deflation(small_well(1000), 1.4);
  EXPECT_EQ(deflation.at(0).value, 1.4);
  EXPECT_EQ(deflation.at(1e9).value, deflation.turning_point().value);
  EXPECT_EQ(deflation.squared_rate(1.4), 0);
  const double undershoot = small_well(1000).equilibrium() - deflation.turning_point().value;
  EXPECT_NEAR(undershoot, Decay(small_well(1000)).greatest_undershoot().value, 0.02 * undershoot);
}

TEST(SlowDeflation, RefusesOrificesThatAreTooWide) {
  EXPECT_THROW(SlowDeflation(small_well(1.5), 1.5), InvalidInput);
  EXPECT_THROW((void)SlowDeflation(small_well(1000), 1.5).at(-1), InvalidInput);
}

}  // namespace
}  // namespace turgor
