// (3.3) and (3.5): reference values, what they say of their errors, and where they end.

#include "turgor/asymptotics/equilibria.hpp"

#include <gtest/gtest.h>

#include "../support/reference.hpp"
#include "motions.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

/// A balloon on which S1 and S2 are given in Pa.
Parameters<double> balloon_with(double S1, double S2) {
  auto p = test::paper_balloon<double>(0.03, 0.0);
  const double unit = p.radius / (4 * p.thickness);
  p.material = MooneyRivlin<double>{S1 * unit, S2 * unit};
  return p;
}

TEST(ClosedEquilibria, ReproduceTheReferenceValues) {
  for (const char* name : {"delta_3.3", "R_eq1_approx", "R_eq2_approx"}) {
    for (const auto& entry : test::reference().at(name)) {
      const auto p = balloon_with(entry.input("S1"), entry.input("S2"));
      const double P = entry.input("P0");
      const double found = std::string(name) == "R_eq2_approx" ? large_equilibrium(p, P).value
                           : std::string(name) == "delta_3.3"  ? small_equilibrium(p, P).delta
                                                               : small_equilibrium(p, P).stretch.value;
      EXPECT_NEAR(found, entry.value, 4e-15 * entry.value) << name << entry.inputs;  // a few roundings
    }
  }
}

TEST(ClosedEquilibria, KnowTheirErrors) {
  const auto p = balloon_with(10, 1);
  for (const double P : {-1.0, 0.5, 2.0, 5.0, 6.9, 7.3, 7.45}) {
    const Estimate R = small_equilibrium(p, P).stretch;
    const double error = std::abs(R.value - equilibria(p, P).front().stretch);
    EXPECT_GT(R.error, 0.7 * error) << P;  // the next term of its series is all that is left out
    EXPECT_LT(R.error, 1.3 * error) << P;
  }
  for (const double P : {6.33, 6.5, 7.0, 20.0}) {
    const Estimate R = large_equilibrium(p, P);
    const double error = std::abs(R.value - equilibria(p, P).back().stretch);
    EXPECT_GT(R.error, 0.7 * error) << P;
    EXPECT_LT(R.error, 1.3 * error) << P;
  }
}

// Without pressure delta is 0/0 in the paper's form; its error is O(delta^3), with delta = P0/(6(S1+S2)) for small P0.
TEST(ClosedEquilibria, SmallOneIsOfThirdOrder) {
  const auto p = balloon_with(10, 1);
  EXPECT_EQ(small_equilibrium(p, 0).stretch.value, 1);
  const auto error = [&](double P) {
    return std::abs(small_equilibrium(p, P).stretch.value - equilibria(p, P).front().stretch);
  };
  EXPECT_NEAR(test::order(error(0.2), error(0.1), 2), 3, 0.1);
}

// The large one leaves out R^-7 and R^-5 in (3.1), and R P'(R) ~ R for large R: relative to R an error O(R^-6).
TEST(ClosedEquilibria, LargeOneIsOfFifthOrder) {
  const auto p = balloon_with(10, 1);
  const auto error = [&](double P) {
    return std::abs(large_equilibrium(p, P).value - equilibria(p, P).back().stretch);
  };
  EXPECT_NEAR(test::order(error(20), error(40), 2), 5, 0.3);
}

TEST(ClosedEquilibria, RefuseWhatTheyCannotDo) {
  const auto p = balloon_with(10, 1);
  EXPECT_THROW((void)small_equilibrium(p, 7.46), InvalidInput);  // past the limit point, where (3.3) stays real
  EXPECT_THROW((void)large_equilibrium(p, 6.32), InvalidInput);  // it exists, but (3.5) is complex
  EXPECT_THROW((void)large_equilibrium(p, -1), InvalidInput);
  EXPECT_THROW((void)small_equilibrium(p, -1e9), InvalidInput);
  EXPECT_THROW((void)large_equilibrium(balloon_with(10, 0), 7), InvalidInput);
  auto other = p;
  other.material = NeoHookean<double>{1e6};
  EXPECT_THROW((void)small_equilibrium(other, 1), InvalidInput);
}

// Below this ratio the whole range with two stable equilibria lies where (3.5) is complex.
TEST(ClosedEquilibria, LargeOneIsUselessBelowARatioOfStiffnesses) {
  const double ratio = test::reference().at("S1_over_S2_where_Pmax=2sqrt(S1S2)").front().value;
  const auto points = limit_points(balloon_with(ratio, 1));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].pressure, 2 * std::sqrt(ratio), 1e-13);
}

}  // namespace
}  // namespace turgor
