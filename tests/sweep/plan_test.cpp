#include "turgor/sweep/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

double number(const Node& node) {
  const auto* exact = node.as<Node::Quantity>();
  return exact != nullptr ? exact->value : *node.as<double>();
}

const AxisRange unit_range{0, 1, false, 0};

SweepSettings sampled(Sampler sampler, std::uint64_t members, std::size_t axes, std::uint64_t seed = 0) {
  SweepSettings s{.sampler = sampler, .members = members, .seed = seed};
  for (std::size_t a = 0; a < axes; ++a) s.axes.push_back({"solve.rtol", "1", unit_range});
  return s;
}

TEST(Grid, SpacesEvenlyOrInEqualRatiosBetweenExactEnds) {
  const Axis linear{"pressure.constant", "Pa", AxisRange{0.1, 0.7, false, 7}};
  const Axis ratios{"pressure.constant", "Pa", AxisRange{0.001, 1000, true, 7}};
  const auto even = grid_values(linear);
  const auto geometric = grid_values(ratios);
  ASSERT_EQ(even.size(), 7U);
  EXPECT_EQ(number(even.front()), 0.1);
  EXPECT_EQ(number(even.back()), 0.7);
  EXPECT_EQ(number(geometric.back()), 1000);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(number(even[k]), 0.1 * static_cast<double>(k + 1), 1e-15);  // rounding
    EXPECT_NEAR(number(geometric[k]) / std::pow(10.0, static_cast<double>(k) - 3), 1, 1e-14);
  }
  EXPECT_EQ(grid_values({"solve.rtol", "1", AxisRange{5, 5, false, 1}}).size(), 1U);
}

TEST(Grid, VisitsEveryCombinationOnceWithTheLastAxisFastest) {
  SweepSettings s{.sampler = Sampler::grid, .members = 24};
  for (const std::uint64_t n : {2U, 3U, 4U}) s.axes.push_back({"solve.rtol", "1", AxisRange{0, 1, false, n}});
  SweepPlan plan(s);
  std::set<std::vector<std::uint64_t>> seen;
  for (std::uint64_t i = 0; i < 24; ++i) seen.insert(plan.indices(i));
  EXPECT_EQ(seen.size(), 24U);
  EXPECT_EQ(plan.indices(1), (std::vector<std::uint64_t>{0, 0, 1}));
  EXPECT_EQ(plan.indices(23), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(number(plan.values(4)[1]), 0.5);
}

TEST(LatinHypercube, HitsEveryStratumOfEveryAxisOnce) {
  constexpr std::uint64_t members = 1000;
  SweepPlan plan(sampled(Sampler::latin_hypercube, members, 3, 7));
  for (std::size_t a = 0; a < 3; ++a) {
    std::set<int> strata;
    for (std::uint64_t i = 0; i < members; ++i) {
      const double u = number(plan.values(i)[a]);
      ASSERT_GT(u, 0);
      ASSERT_LT(u, 1);
      strata.insert(static_cast<int>(u * members));
    }
    EXPECT_EQ(strata.size(), members);
  }
}

TEST(LatinHypercube, ShufflesAxesIndependently) {
  constexpr std::uint64_t members = 4000;
  SweepPlan plan(sampled(Sampler::latin_hypercube, members, 2, 3));
  double covariance = 0;
  double neighbours = 0;
  for (std::uint64_t i = 0; i < members; ++i) {
    const auto u = plan.values(i);
    covariance += (number(u[0]) - 0.5) * (number(u[1]) - 0.5);
    neighbours += (number(u[0]) - 0.5) * (number(plan.values((i + 1) % members)[0]) - 0.5);
  }
  // A correlation of independent numbers is of size 1/sqrt(4000) = 0.016; four times that is 6e-5 improbable.
  EXPECT_LT(std::abs(12 * covariance / members), 0.064);
  EXPECT_LT(std::abs(12 * neighbours / members), 0.064);
}

// The bits of a sample belong to the format of a case: they must not change between versions or machines.
TEST(LatinHypercube, IsTheSameEverywhere) {
  SweepPlan plan(sampled(Sampler::latin_hypercube, 5, 2, 1));
  SweepPlan other(sampled(Sampler::latin_hypercube, 5, 2, 2));
  EXPECT_EQ(number(plan.values(0)[0]), 0.9228606325596681);
  EXPECT_EQ(number(plan.values(4)[1]), 0.9126855969422859);
  EXPECT_NE(number(other.values(0)[0]), number(plan.values(0)[0]));
}

TEST(LatinHypercube, RefusesWhatDoesNotFitInMemory) {
  EXPECT_THROW(SweepPlan(sampled(Sampler::latin_hypercube, 200'000'000, 2)), InvalidInput);
}

TEST(Sobol, IsBoostsSequenceInAnyOrder) {
  SweepPlan plan(sampled(Sampler::sobol, 1000, 4));
  boost::random::sobol sequence(4);
  std::vector<std::vector<double>> expected;
  for (int i = 0; i < 1000; ++i) {
    expected.emplace_back();
    for (int a = 0; a < 4; ++a) expected.back().push_back(std::ldexp(static_cast<double>(sequence()), -64));
  }
  EXPECT_EQ(expected[0][0], 0.5);
  for (const std::uint64_t i : {999U, 0U, 500U, 1U, 500U, 3U}) {
    const auto u = plan.values(i);
    // points of the sequence are kept to 52 bits, in the middle of their cell
    for (std::size_t a = 0; a < 4; ++a) EXPECT_NEAR(number(u[a]), expected[i][a], std::ldexp(1, -52)) << i;
  }
}

TEST(Sobol, ASeedShiftsItAndKeepsItBalanced) {
  SweepPlan plain(sampled(Sampler::sobol, 1023, 2));
  SweepPlan shifted(sampled(Sampler::sobol, 1023, 2, 5));
  double mean = 0;
  for (std::uint64_t i = 0; i < 1023; ++i) mean += number(shifted.values(i)[1]) / 1023;
  EXPECT_NE(number(plain.values(0)[1]), number(shifted.values(0)[1]));
  EXPECT_NEAR(mean, 0.5, 1e-3);  // one point short of a net: its share
}

TEST(Distributions, HaveTheirQuantiles) {
  const Axis normal{"material.s1", "Pa", NormalAxis{10, 2}};
  const Axis lognormal{"material.s1", "Pa", LognormalAxis{10, 0.5}};
  for (double u = 0.01; u < 1; u += 0.07) {
    // distribution functions by the error function of the standard library
    EXPECT_NEAR(0.5 * std::erfc(-(quantile_of(normal, u) - 10) / 2 / std::sqrt(2)), u, 1e-14);
    EXPECT_NEAR(0.5 * std::erfc(-std::log(quantile_of(lognormal, u) / 10) / 0.5 / std::sqrt(2)), u, 1e-14);
  }
  EXPECT_DOUBLE_EQ(quantile_of(lognormal, 0.5), 10);
  const Axis ratios{"material.s1", "Pa", AxisRange{1, 100, true, 0}};
  EXPECT_DOUBLE_EQ(quantile_of(ratios, 0.5), 10);
}

TEST(Distributions, SamplesHaveTheirMoments) {
  SweepSettings s = sampled(Sampler::latin_hypercube, 20000, 1, 4);
  s.axes[0].form = NormalAxis{3, 0.25};
  SweepPlan plan(s);
  double mean = 0;
  double square = 0;
  for (std::uint64_t i = 0; i < s.members; ++i) {
    const double x = number(plan.values(i)[0]);
    mean += x / 20000;
    square += (x - 3) * (x - 3) / 20000;
  }
  // Stratified: only the jitter within strata of width 1/20000 is left, largest in the tails.
  EXPECT_NEAR(mean, 3, 1e-4);
  EXPECT_NEAR(std::sqrt(square), 0.25, 1e-3);
}

}  // namespace
}  // namespace turgor
