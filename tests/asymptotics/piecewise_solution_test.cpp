// Half-cycles one after the other, against exact motion.

#include "turgor/asymptotics/piecewise_solution.hpp"

#include <gtest/gtest.h>

#include "motions.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::middle_pressure;

Oscillator<double> balloon(bool channel) {
  return channel ? test::channel_balloon(40.681720734041306, 179.04931097838227)
                 : test::orifice_balloon(40.681720734041306, 2690.5829596412555);
}

// The two balloons of figure 8, from above and below; errors up to those that they name.
TEST(PiecewiseSolution, FollowsTheExactMotionThroughManyHalfCycles) {
  for (const bool channel : {false, true}) {
    const FreeMotion motion(balloon(channel), middle_pressure, 4.8);
    for (const double start : {5.0, 4.6}) {
      const PiecewiseSolution solution(motion, start, 13, Chain::uniform);
      ASSERT_EQ(solution.half_cycles().size(), 13U) << solution.ending();
      EXPECT_TRUE(solution.ending().empty());
      const auto exact = test::exact(balloon(channel), start, 1.001 * solution.end_time());
      double late = 0;
      for (std::size_t i = 0; i < exact.events.size() && i < 13; ++i) {
        const auto& half = solution.half_cycles()[i];
        late += half.duration.error;
        EXPECT_NEAR(half.begin + half.duration.value, exact.events[i].time, 1.3 * late) << channel << start << " " << i;
        EXPECT_NEAR(half.to.value, exact.events[i].stretch, 1.3 * half.to.error + 1e-13);
      }
      for (int i = 0; i <= 500; ++i) {
        const double T = solution.end_time() * i / 500;
        const Estimate R = solution.at(T);
        EXPECT_NEAR(R.value, exact.at(T).stretch, 1.4 * R.error + 1e-11) << channel << start << " " << T;
        EXPECT_LT(R.error, start == 5.0 ? 1e-6 : 2e-3);
      }
    }
  }
}

TEST(PiecewiseSolution, IsContinuous) {
  const PiecewiseSolution solution(FreeMotion(balloon(true), middle_pressure, 4.8), 5.0, 13, Chain::uniform);
  for (std::size_t i = 1; i < solution.half_cycles().size(); ++i) {
    const auto& before = solution.half_cycles()[i - 1];
    const auto& after = solution.half_cycles()[i];
    EXPECT_EQ(after.from, before.to.value);
    EXPECT_EQ(after.begin, before.begin + before.duration.value);
    EXPECT_NE(after.regime, before.regime);
    EXPECT_NEAR(solution.at(after.begin).value, solution.at(after.begin * (1 - 1e-12)).value, 1e-7);
  }
  EXPECT_EQ(solution.at(0).value, 5.0);
}

// The paper's own chain: figure 8 in numbers. It ends where its deflation stops short of the equilibrium.
TEST(PiecewiseSolution, PapersChainEndsAfterItsFirstDeflation) {
  for (const bool channel : {false, true}) {
    const FreeMotion motion(balloon(channel), middle_pressure, 4.8);
    const PiecewiseSolution solution(motion, 4.6, 5, Chain::paper);
    ASSERT_EQ(solution.half_cycles().size(), 2U);
    EXPECT_EQ(solution.half_cycles()[0].regime, Regime::inflating);
    EXPECT_NE(solution.ending().find("before the equilibrium"), std::string::npos) << solution.ending();
    const Oscillation law(motion, Regime::inflating);
    const double e = 4.6 - motion.equilibrium();
    const double T = 0.4 / law.frequency();
    EXPECT_EQ(solution.at(T).value, channel ? law.second_order(e, T).value : law.first_order(e, T).value);
    const auto exact = test::exact(balloon(channel), 4.6, solution.end_time());
    for (int i = 0; i <= 100; ++i) {
      const double now = solution.end_time() * i / 100;
      const Estimate R = solution.at(now);
      EXPECT_NEAR(R.value, exact.at(now).stretch, 1.2 * R.error) << channel << " " << now;
    }
  }
}

TEST(PiecewiseSolution, RefusesWhatHasNoMotion) {
  const FreeMotion motion(balloon(false), middle_pressure, 4.8);
  EXPECT_THROW(PiecewiseSolution(motion, motion.equilibrium(), 3, Chain::uniform), InvalidInput);
  EXPECT_THROW(PiecewiseSolution(motion, 1.5, 3, Chain::uniform), InvalidInput);  // the other well
  EXPECT_THROW(PiecewiseSolution(motion, std::nan(""), 3, Chain::uniform), InvalidInput);
  EXPECT_THROW(PiecewiseSolution(motion, 5, 0, Chain::uniform), InvalidInput);
  const PiecewiseSolution solution(motion, 5, 1, Chain::uniform);
  EXPECT_THROW((void)solution.at(-1), InvalidInput);
  EXPECT_THROW((void)solution.at(1.01 * solution.end_time()), InvalidInput);
  EXPECT_THROW((void)solution.at(std::nan("")), InvalidInput);
}

}  // namespace
}  // namespace turgor
