// (3.9) to (3.17): reference values, the paper's own formulas for the Mooney-Rivlin solid, orders of convergence.

#include "turgor/asymptotics/matched_deflation.hpp"

#include <gtest/gtest.h>

#include "../support/reference.hpp"
#include "motions.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::middle_pressure;
using test::ReferenceValue;

Oscillator<double> oscillator_of(const ReferenceValue& entry) {
  const double C2 = entry.has("C2") ? entry.input("C2") : 1000.0;
  const bool channel = entry.has("note") && entry.text("note").starts_with("C2~");
  return channel ? test::channel_balloon(entry.input("C1"), C2, entry.input("P0"))
                 : test::orifice_balloon(entry.input("C1"), C2, entry.input("P0"));
}

FreeMotion motion_of(const ReferenceValue& entry) {
  return {oscillator_of(entry), entry.input("P0"), entry.input("R_i")};
}

TEST(MatchedDeflation, GammasReproduceTheReferenceValues) {
  for (const char* name : {"gamma1", "gamma2", "gamma3"}) {
    ASSERT_EQ(test::reference().at(name).size(), 3U);
    for (const auto& entry : test::reference().at(name)) {
      const Gammas g = gammas(motion_of(entry), entry.input("R_i"));
      const std::string which = name;
      const double found = which == "gamma1" ? g.first : which == "gamma2" ? g.second : g.third;
      EXPECT_NEAR(found, entry.value, 2e-14) << name << entry.inputs;  // F loses two digits of terms ~ C1 S1/R^3
    }
  }
}

TEST(MatchedDeflation, GammasAreThePapersForMooneyRivlin) {
  const double S1 = 10;
  const double S2 = 1;
  const double P = middle_pressure;
  const double C1 = 0.7;
  const FreeMotion motion(test::orifice_balloon(C1, 500.0), P, 1.2);
  for (const double R : {1.27, 1.4, 1.8}) {
    const auto r = [&](int n) { return std::pow(R, -n); };
    const Gammas g = gammas(motion, R);
    EXPECT_NEAR(g.first, C1 * (S1 * (r(3) - r(9)) + S2 * (r(1) - r(7)) - r(2) * P), 1e-14);
    EXPECT_NEAR(g.second, C1 * (S1 * (r(3) - 7 * r(9)) - S2 * (r(1) + 5 * r(7))), 1e-14);
    EXPECT_NEAR(g.third, C1 * (3 * S1 * (5 * r(7) - 22 * r(13)) + 3 * S2 * (2 * r(5) - 15 * r(11)) - 10 * r(6) * P),
                1e-13);
  }
}

// The reference sums (3.9), (3.12) and (3.16) as printed, with many digits.
TEST(MatchedDeflation, SolutionsReproduceTheReferenceValues) {
  for (const char* name : {"R_outer_3.9", "R_inner_3.12", "R_composite_3.16"}) {
    ASSERT_EQ(test::reference().at(name).size(), 6U);
    for (const auto& entry : test::reference().at(name)) {
      const MatchedDeflation deflation(motion_of(entry), entry.input("R_i"));
      const std::string which = name;
      const double T = entry.input("T");
      const Estimate R = which == "R_outer_3.9"    ? deflation.outer(T)
                         : which == "R_inner_3.12" ? deflation.inner(T)
                                                   : deflation.composite(T);
      EXPECT_NEAR(R.value, entry.value, 5e-15) << name << entry.inputs;  // rounding of R = 5
    }
  }
}

// What each says of its own error against the exact values of the file.
TEST(MatchedDeflation, KnowsItsErrors) {
  for (const auto& entry : test::reference().at("R_deflation_exact")) {
    const MatchedDeflation deflation(motion_of(entry), entry.input("R_i"));
    const double T = entry.input("T");
    for (const Estimate& R :
         {deflation.outer(T), deflation.inner(T), deflation.composite(T), deflation.uniform().at(T)}) {
      const double error = std::abs(R.value - entry.value);
      EXPECT_LT(error, 1.2 * R.error + 2e-14) << entry.inputs;  // the file's 1e-14 and as much rounding
      EXPECT_LT(R.error, 5 * error + 5e-13) << entry.inputs;    // an estimate, not a shrug
    }
  }
}

TEST(MatchedDeflation, TransitionTimesReproduceTheReferenceValues) {
  ASSERT_EQ(test::reference().at("T_di_3.17").size(), 6U);
  for (const auto& entry : test::reference().at("T_di_3.17")) {
    const MatchedDeflation deflation(motion_of(entry), entry.input("R_i"));
    EXPECT_NEAR(deflation.transition_time().value, entry.value, 1e-12 * entry.value) << entry.inputs;
  }
}

TEST(MatchedDeflation, TransitionTimeKnowsItsError) {
  for (const auto& entry : test::reference().at("T_di_exact")) {
    const MatchedDeflation deflation(motion_of(entry), entry.input("R_i"));
    const Estimate paper = deflation.transition_time();
    EXPECT_NEAR(paper.error, std::abs(paper.value - entry.value), 1e-3 * paper.error) << entry.inputs;
    const double relative = paper.error / entry.value;
    EXPECT_GT(relative, 0.02);  // 2 % to 5 % here
    EXPECT_LT(relative, 0.05);
  }
}

/// Error of an approximation of R at time T, with C1 = 0.2233 about the small equilibrium.
struct Errors {
  double composite;
  double uniform;
};
Errors errors_at(double C2, double T, double start = 1.35) {
  const MatchedDeflation deflation(FreeMotion(test::orifice_balloon(0.2233, C2), middle_pressure, 1.3), start);
  using Long = long double;
  const auto oscillator = test::orifice_balloon<Long>(0.2233, C2, middle_pressure);
  const double exact = test::exact_stretch<Long>(oscillator, start, T);
  return {std::abs(deflation.composite(T).value - exact), std::abs(deflation.uniform().at(T).value - exact)};
}

// (3.16) claims O(delta^5/2). Slopes over one octave of delta: 3.00, and 1.85, 1.95 on the way to 2.
TEST(MatchedDeflation, CompositeIsOfThirdOrderAtFixedTauAndOfSecondAtFixedTime) {
  const auto at_tau = [](double C2) { return errors_at(C2, 3 / std::sqrt(C2)); };
  EXPECT_NEAR(test::order(at_tau(800).composite, at_tau(1600).composite, 2), 3, 0.02);
  const auto at_time = [](double C2) { return errors_at(C2, 0.5); };
  const double slope = test::order(at_time(6400).composite, at_time(12800).composite, 2);
  EXPECT_NEAR(slope, 2, 0.1);
  EXPECT_GT(slope, test::order(at_time(800).composite, at_time(1600).composite, 2));
}

// At sqrt(delta) T = 1 the slow motion has gone a finite way: a cubic polynomial does not follow it, the integral does.
TEST(MatchedDeflation, OnlyTheUniformSolutionHoldsForTimesOfTheSlowMotion) {
  const auto late = [](double C2) { return errors_at(C2, std::sqrt(C2), 1.5); };
  const Errors coarse = late(800);
  const Errors fine = late(12800);
  EXPECT_NEAR(test::order(coarse.composite, fine.composite, 16), 0, 0.1);
  EXPECT_GT(fine.composite, 1e-4);
  EXPECT_NEAR(test::order(coarse.uniform, fine.uniform, 16), 2, 0.1);
  EXPECT_LT(fine.uniform, 1e-7);
}

TEST(MatchedDeflation, UniformSolutionIsBetterEverywhere) {
  EXPECT_NEAR(
      test::order(errors_at(800, 3 / std::sqrt(800.0)).uniform, errors_at(1600, 3 / std::sqrt(1600.0)).uniform, 2), 3,
      0.05);
  EXPECT_NEAR(test::order(errors_at(800, 0.5).uniform, errors_at(1600, 0.5).uniform, 2), 2.5, 0.05);
}

TEST(MatchedDeflation, NeverOverflows) {
  const MatchedDeflation deflation(FreeMotion(test::orifice_balloon(40.0, 2690.0), middle_pressure, 5), 5);
  for (const double T : {0.0, 1e-300, 1e-8, 1.0, 1e3, 1e6}) {
    for (const Estimate& R : {deflation.outer(T), deflation.inner(T), deflation.composite(T)}) {
      EXPECT_TRUE(std::isfinite(R.value)) << T;
      EXPECT_TRUE(std::isfinite(R.error)) << T;
    }
  }
  EXPECT_EQ(deflation.composite(0).value, 5);
  EXPECT_EQ(deflation.inner(0).value, 5);
}

// Li2(-y) by its defining series for y <= 1/2; at 1 it is -pi^2/12.
TEST(MatchedDeflation, DilogarithmIsItsSeries) {
  EXPECT_NEAR(dilogarithm_of_layer(0), -std::numbers::pi * std::numbers::pi / 12, 1e-15);
  for (const double x : {0.35, 0.8, 2.0, 10.0, 300.0}) {
    const double y = std::exp(-2 * x);
    double sum = 0;
    double power = 1;
    for (int k = 1; k < 60; ++k) {
      power *= -y;
      sum += power / (k * k);
    }
    EXPECT_NEAR(dilogarithm_of_layer(x), sum, 4e-16 * std::abs(sum)) << x;
  }
  EXPECT_EQ(dilogarithm_of_layer(1e6), 0);
}

TEST(MatchedDeflation, RefusesWhatItCannotDo) {
  const auto oscillator = test::orifice_balloon(1.0, 2690.0);
  const FreeMotion small(oscillator, middle_pressure, 1.3);
  for (const double start : {1.2, small.equilibrium(), 2.1, std::nan("")}) {
    EXPECT_THROW(MatchedDeflation(small, start), InvalidInput) << start;
  }
  EXPECT_THROW(MatchedDeflation(small, small.equilibrium() * (1 + 1e-12)), InvalidInput);
  EXPECT_THROW(MatchedDeflation(small, small.greatest() * (1 - 1e-9)), InvalidInput);
  // 2 beta (start - R_eq) = 0.02: w2 is not small, and the undershoot would be twice too large.
  EXPECT_THROW(MatchedDeflation(FreeMotion(test::orifice_balloon(0.2233, 500.0), middle_pressure, 1.3), 1.2582136),
               InvalidInput);
  // From R = 1.5 the slow motion gains speed at first: 4 gamma1 + gamma2 > 0, where the plus root is 4.8 times too
  // large.
  const MatchedDeflation far(small, 1.5);
  EXPECT_GT(4 * far.constants().first + far.constants().second, 0);
  EXPECT_THROW((void)far.transition_time(), InvalidInput);
  EXPECT_NO_THROW((void)far.uniform().transition_time());
  EXPECT_THROW((void)far.composite(-1), InvalidInput);
  EXPECT_THROW((void)far.composite(std::nan("")), InvalidInput);
}

}  // namespace
}  // namespace turgor
