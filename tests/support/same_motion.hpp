#pragma once
// Time stepping against quadrature.

#include <gtest/gtest.h>

#include "turgor/integrate/quadrature.hpp"

namespace turgor::test {

/// Runs both methods and compares everything that does not depend on where steps end. In long double, because events of
/// small amplitude are worth less in stepped solutions than 1e-9.
inline void expect_same(const Oscillator<long double>& oscillator, long double R, long double v, long double end,
                        SimulationOptions<long double> options, Outcome outcome) {
  options.rtol = options.atol = 1e-15L;
  const auto stepped = simulate<long double>(oscillator, 0, R, v, end, options);
  const auto exact = simulate_by_quadrature<long double>(oscillator, 0, R, v, end, options);
  const auto near = [](long double found, long double expected) {
    EXPECT_NEAR(static_cast<double>(found), static_cast<double>(expected), 1e-9);
  };
  EXPECT_EQ(exact.outcome, outcome) << exact.message;
  EXPECT_EQ(stepped.outcome, outcome) << stepped.message;
  ASSERT_EQ(exact.events.size(), stepped.events.size());
  for (std::size_t i = 0; i < exact.events.size(); ++i) {
    near(exact.events[i].time, stepped.events[i].time);
    near(exact.events[i].stretch, stepped.events[i].stretch);
    EXPECT_EQ(exact.events[i].before, stepped.events[i].before);
    EXPECT_EQ(exact.events[i].after, stepped.events[i].after);
  }
  EXPECT_EQ(exact.last.regime, stepped.last.regime);
  if (outcome == Outcome::interrupted || outcome == Outcome::runaway) return;
  near(exact.last.time, stepped.last.time);
  near(exact.last.stretch, stepped.last.stretch);
  near(exact.last.rate, stepped.last.rate);
  for (int i = 0; i <= 50; ++i) {
    const long double t = stepped.last.time * i / 50;
    near(exact.at(t).stretch, stepped.at(t).stretch);
  }
}

}  // namespace turgor::test
