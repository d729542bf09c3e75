#include "turgor/flow/force_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <thread>

#include "../support/flow.hpp"
#include "../support/seed.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {
namespace {

constexpr double pi = std::numbers::pi;

// The shipped numbers are what its generator makes; rounding of other compilers is let pass.
TEST(ForceTable, IsWhatTheGeneratorMakes) {
  for (const std::size_t i : {std::size_t{8}, ForceTable::pieces - 1}) {
    const auto made = ForceTable::compute(OutflowProfile::uniform(), i, 1e-15);
    const double lower = std::ldexp(1.0, ForceTable::first_binade + static_cast<int>(i));
    for (const double share : {0.01, 0.3, 0.77}) {
      const double kappa = lower + share * (made.inertial.upper - made.inertial.lower);
      const auto shipped = ForceTable::uniform().at(kappa);
      EXPECT_NEAR(shipped.inertial, made.inertial.at(kappa).value, 1e-13);
      EXPECT_NEAR(shipped.centripetal, made.centripetal.at(kappa).value, 1e-13);
    }
  }
}

TEST(ForceTable, HoldsTheForceCoefficientsBetweenItsPoints) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 60; ++i) {
    const double kappa = std::exp(test::between(random, std::log(ForceTable::least_kappa), std::log(0.75)));
    const ForceCoefficients g = ForceTable::uniform().coefficients(kappa);
    const ForceCoefficients direct = force_coefficients(PotentialFlow(kappa, OutflowProfile::uniform(), 1e-15));
    EXPECT_NEAR(g.g3, direct.g3, 1e-12 * direct.g3) << kappa;
    EXPECT_NEAR(g.g5, direct.g5, 1e-12 * direct.g5) << kappa;
    EXPECT_EQ(g.g2, direct.g2);
  }
}

/// g3 and g5 without its integral by the sums of appendix B.
class SeriesForce {
 public:
  SeriesForce(double kappa, int count) : harmonics_(uniform_harmonics(kappa, count)), eps_(cap_depth(kappa)) {}

  /// First `count` harmonics, the last quarter fading out smoothly so that oscillating tails cancel: what is left of
  /// the error is a power series in 1/count.
  [[nodiscard]] std::array<double, 2> faded(int count) const {
    const double area = 2 - eps_;
    const double rate = eps_ * area / (1 - eps_);
    double inertial = 0;
    double centripetal = 0;
    double speed = 0;
    double power = 1;
    double p_before = 1;
    double p = eps_ - 1;
    for (int m = 1; m <= count; ++m) {
      const auto i = static_cast<std::size_t>(m - 1);
      const double p_after = ((2 * m + 1) * (eps_ - 1) * p - m * p_before) / (m + 1);
      const double x = static_cast<double>(m) / count;
      const double fading = x < 0.5 ? 1 : 0.5 * std::erfc(24 * (x - 0.75));
      speed += fading * harmonics_.amplitude[i] / 2 * power;
      power *= eps_ - 1;
      const double mean = (p_before - p_after) / (2 * m + 1) - area * power;
      inertial += fading * harmonics_.amplitude[i] / m * mean;
      centripetal += fading * (harmonics_.change[i] * rate + harmonics_.amplitude[i] * (m - 1)) / (2 * m) * mean;
      p_before = p;
      p = p_after;
    }
    return {pi * (area * area / (1 - eps_) + inertial),
            2 * pi * (rate * area * area / (2 * power_of_height()) + centripetal + area * speed * speed / 2)};
  }

  /// Two steps of Richardson's extrapolation.
  [[nodiscard]] std::array<double, 2> extrapolated() const {
    const int count = harmonics_.count();
    const auto a = faded(count / 4), b = faded(count / 2), c = faded(count);
    std::array<double, 2> limit;
    for (std::size_t i = 0; i < 2; ++i) limit[i] = (4 * (2 * c[i] - b[i]) - (2 * b[i] - a[i])) / 3;
    return limit;
  }

 private:
  [[nodiscard]] double power_of_height() const { return (1 - eps_) * (1 - eps_); }
  Harmonics harmonics_;
  double eps_;
};

// Series and flow have nothing in common but (2.5). The sums for the flow in the orifice end at some 40/eps.
TEST(ForceTable, AgreesWithTheSeries) {
  for (const double kappa : {1.0 / 500, 1.0 / 100, 1.0 / 20, 1.0 / 5, 1.0 / 2}) {
    const double eps = cap_depth(kappa);
    const auto [g3, g5] = SeriesForce(kappa, static_cast<int>(160 / eps) + 40000).extrapolated();
    const ForceCoefficients g = ForceTable::uniform().coefficients(kappa);
    const FlowIntegrals integrals = flow_integrals(PotentialFlow(kappa, OutflowProfile::uniform(), 1e-14));
    EXPECT_NEAR(g.g3, g3, 1e-10 * g3) << kappa;
    EXPECT_NEAR(g.g5 + pi * (2 - eps + integrals.wall_speed_squared), g5, 1e-10 * g5) << kappa;
  }
}

TEST(ForceTable, KnowsItsSlopes) {
  for (const double kappa : {2e-5, 0.003, 0.11, 0.4, 0.7}) {
    const double h = 1e-4 * kappa;
    const auto value = [](double k) { return ForceTable::uniform().at(k); };
    const auto at = value(kappa);
    EXPECT_NEAR(at.inertial_slope, (value(kappa + h).inertial - value(kappa - h).inertial) / (2 * h), 1e-6);
    EXPECT_NEAR(at.centripetal_slope, (value(kappa + h).centripetal - value(kappa - h).centripetal) / (2 * h), 1e-6);
  }
}

// kappa -> 0: 1 + kappa [ln(2/kappa)/4 ...]: the limit is approached like kappa ln kappa.
TEST(ForceTable, TendsToOneForSmallOrifices) {
  const auto at = ForceTable::uniform().at(1e-5);
  EXPECT_NEAR(at.inertial, 1, 1e-4);
  EXPECT_NEAR(at.centripetal, 1, 1e-4);
}

TEST(ForceTable, OfAProfileHoldsItsForceCoefficients) {
  const ForceTable table(OutflowProfile::table({0, 0.5, 0.8, 0.9, 0.95, 1}, {1.27, 1.19, 0.98, 0.80, 0.65, 0}));
  std::vector<std::thread> threads;  // the piece is made once, whoever asks first
  std::vector<double> seen(4);
  for (std::size_t i = 0; i < 4; ++i) threads.emplace_back([&, i] { seen[i] = table.at(0.1).inertial; });
  for (auto& thread : threads) thread.join();
  for (const double value : seen) EXPECT_EQ(value, seen[0]);
  for (const double kappa : {0.07, 0.1, 0.12}) {
    const ForceCoefficients g = table.coefficients(kappa);
    const ForceCoefficients direct = force_coefficients(PotentialFlow(kappa, table.profile(), 1e-14));
    EXPECT_NEAR(g.g3, direct.g3, 1e-9 * direct.g3);
    EXPECT_NEAR(g.g5, direct.g5, 1e-9 * direct.g5);
  }
  // The paper's factors for a profile of its own that it does not show: 1.095 and 1.5625.
  const ForceCoefficients g = table.coefficients(0.1);
  const ForceCoefficients uniform = ForceTable::uniform().coefficients(0.1);
  EXPECT_NEAR(g.g3 / uniform.g3, 1.095, 0.005);
  EXPECT_NEAR(g.g5 / uniform.g5, 1.56, 0.05);
}

TEST(ForceTable, OfUniformOutflowIsTheShippedOne) {
  const ForceTable table(OutflowProfile::polynomial({3}));
  const auto made = table.at(0.3);
  const auto shipped = ForceTable::uniform().at(0.3);
  EXPECT_NEAR(made.inertial, shipped.inertial, 1e-9);
  EXPECT_NEAR(made.centripetal, shipped.centripetal, 1e-9);
}

TEST(ForceTable, EndsWhereItEnds) {
  for (const double kappa : {0.0, 1e-6, 0.76, 1.0, std::nan("")}) {
    EXPECT_TRUE(std::isnan(ForceTable::uniform().at(kappa).inertial)) << kappa;
    EXPECT_THROW((void)ForceTable::uniform().coefficients(kappa), InvalidInput);
  }
  EXPECT_FALSE(std::isnan(ForceTable::uniform().at(0.75).inertial));
  EXPECT_FALSE(std::isnan(ForceTable::uniform().at(0x1p-17).inertial));
}

}  // namespace
}  // namespace turgor
