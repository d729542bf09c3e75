#include "turgor/oscillator/selection.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"

namespace turgor {
namespace {

Parameters<double> balloon(double orifice_radius, double channel_length) {
  return test::paper_balloon<double>(orifice_radius, channel_length);
}

TEST(Selection, ComparesEachDroppedTermWithTheOneThatIsKept) {
  // r_ch = 1 cm, L_ch = 50 cm, by hand: b = 100, a0 = 1/3000, m = 223/(32 pi), n = 75/(4 pi) 27000.
  const auto terms = dropped_terms(Model::long_channel, balloon(0.01, 0.5), 1.0, 2.0);
  ASSERT_EQ(terms.size(), 4U);
  const double m = 223 / (32 * std::numbers::pi);
  const double n = 75 / (4 * std::numbers::pi) * 27000;
  EXPECT_NEAR(terms[0].ratio, 1.0 / 3000 / 100, 1e-15);  // solid, inflating: greatest at R = 1
  EXPECT_NEAR(terms[1].ratio, 1.0 / 3000 / 100, 1e-15);  // solid, deflating
  EXPECT_NEAR(terms[2].ratio, m / 100, 1e-12);           // balloon liquid, any R
  EXPECT_NEAR(terms[3].ratio, 200 / n, 1e-12);           // channel centripetal, greatest at R = 1
  EXPECT_TRUE(dropped_terms(Model::full, balloon(0.01, 0.5), 1.0, 2.0).empty());
}

// 0.15 m of 0.3 m at R = 1: kappa = 1/2. What the factors do at each end is taken from the coefficients themselves.
TEST(Selection, ComparesTermsWithTheirFactors) {
  const auto p = test::with_closure(balloon(0.15, 0.5), Closure::potential);
  const Oscillator<double> full(Model::full, p, constant_pressure(0.0), test::si_scales(p));
  const auto at = [&](double R) {
    const auto in = full.coefficients(Regime::inflating, R);
    const auto out = full.coefficients(Regime::deflating, R);
    const double solid = full.dimensionless_groups().a0 / full.dimensionless_groups().K;
    return std::array{solid / (in.mass - solid), (out.mass - in.mass) / (in.mass - solid),
                      in.centripetal / (in.centripetal - out.centripetal)};
  };
  const auto terms = dropped_terms(Model::long_channel, p, 0.8, 3.0);
  ASSERT_EQ(terms.size(), 4U);
  EXPECT_NEAR(terms[0].ratio / at(0.8)[0], 1, 1e-12);
  EXPECT_NEAR(terms[2].ratio / std::max(at(0.8)[1], at(3.0)[1]), 1, 1e-12);
  EXPECT_NEAR(terms[3].ratio / at(0.8)[2], 1, 1e-12);
  EXPECT_NE(dropped_terms(Model::long_channel, balloon(0.15, 0.5), 0.8, 3.0)[2].ratio, terms[2].ratio);
}

TEST(Selection, TakesTheSimplestModelThatDropsLittle) {
  EXPECT_EQ(simplest_model(balloon(0.03, 0.0), 1.0, 1.2, 0.05), Model::orifice);
  EXPECT_EQ(simplest_model(balloon(0.01, 0.5), 1.0, 1.2, 0.05), Model::long_channel);
  // 3 cm: the balloon liquid's inertia is m/b = 6.7 % of the channel's
  EXPECT_EQ(simplest_model(balloon(0.03, 0.5), 1.0, 1.2, 0.05), Model::full);
  EXPECT_EQ(simplest_model(balloon(0.03, 0.5), 1.0, 1.2, 0.07), Model::long_channel);
  EXPECT_EQ(simplest_model(balloon(0.03, 0.01), 1.0, 1.2, 0.05), Model::full);
}

}  // namespace
}  // namespace turgor
