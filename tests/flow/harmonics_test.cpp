#include "turgor/flow/harmonics.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>

#include "../support/flow.hpp"
#include "../support/reference.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {
namespace {

constexpr double pi = std::numbers::pi;

double bound(const test::ReferenceValue& entry) { return std::max(entry.error_bound, 1e-12 * std::abs(entry.value)); }

TEST(Harmonics, ReproduceTheReferenceCoefficients) {
  for (const auto& entry : test::reference().at("A_m")) {
    const int m = static_cast<int>(entry.input("m"));
    const Harmonics a = uniform_harmonics(test::fraction(entry.text("kappa")), m);
    EXPECT_NEAR(a.amplitude.back(), entry.value, bound(entry)) << entry.inputs;
  }
  for (const auto& entry : test::reference().at("dA_m/deps")) {
    const int m = static_cast<int>(entry.input("m"));
    const Harmonics a = uniform_harmonics(test::fraction(entry.text("kappa")), m);
    EXPECT_NEAR(a.change.back(), entry.value, bound(entry)) << entry.inputs;
  }
  const OutflowProfile profile = OutflowProfile::polynomial({1.25, 0, -0.5});
  for (const auto& entry : test::reference().at("Atilde_m")) {
    ASSERT_EQ(entry.text("f_hat"), "1.25-0.5*Y^2");
    const int m = static_cast<int>(entry.input("m"));
    const Harmonics a = profile_harmonics(test::fraction(entry.text("kappa")), profile, m);
    EXPECT_NEAR(a.amplitude.back(), entry.value, bound(entry)) << entry.inputs;
  }
}

// (2.7) as it is printed, which in double precision loses digits as eps falls: hence a large orifice.
TEST(Harmonics, AreThoseOfTheFormulaAsPrinted) {
  const double kappa = 0.6;
  const double eps = cap_depth(kappa);
  const double x = eps - 1;
  const auto P = [&](int m) { return boost::math::legendre_p(m, x); };
  const Harmonics a = uniform_harmonics(kappa, 30);
  EXPECT_NEAR(a.amplitude[0], (12 - 6 * eps + eps * eps) / 2, 1e-14);
  for (int m = 2; m <= 30; ++m) {
    const double printed = 2 / eps * ((P(m) - m * x * P(m - 1)) / (m - 1) + (P(m) + (m + 1) * x * P(m + 1)) / (m + 2)) +
                           P(m - 1) - P(m + 1);
    EXPECT_NEAR(a.amplitude[static_cast<std::size_t>(m - 1)], printed, 1e-12) << m;
  }
}

// Quadrature over the cap and recurrences are two ways to the same numbers. The sum of the sources is of order m A_m.
TEST(Harmonics, OfAUniformProfileAreThoseOfUniformOutflow) {
  for (const double kappa : {0.7, 0.1, 0.005}) {
    constexpr int count = 3000;
    const Harmonics a = uniform_harmonics(kappa, count);
    const Harmonics b = profile_harmonics(kappa, OutflowProfile::polynomial({7}), count);
    const double eps = cap_depth(kappa);
    for (std::size_t i = 0; i < count; ++i) {
      const double size = 2 * static_cast<double>(i) + 3;
      EXPECT_NEAR(b.amplitude[i], a.amplitude[i], 1e-13 * size) << kappa << " " << i;
      EXPECT_NEAR(b.change[i], a.change[i], 1e-13 * size / eps) << kappa << " " << i;
    }
  }
}

// Central differences of fourth order; eps changes with kappa.
TEST(Harmonics, ChangeWithEpsAsFiniteDifferencesSay) {
  const OutflowProfile profile = OutflowProfile::polynomial({1, 0.3, 0, -0.9});
  const double kappa = 0.3;
  constexpr int count = 12;
  const auto at = [&](double k) { return profile_harmonics(k, profile, count).amplitude; };
  const double h = 1e-3;
  const auto a = at(kappa - 2 * h), b = at(kappa - h), c = at(kappa + h), d = at(kappa + 2 * h);
  const Harmonics exact = profile_harmonics(kappa, profile, count);
  const double eps_slope = kappa / std::sqrt(1 - kappa * kappa);
  for (std::size_t i = 0; i < count; ++i) {
    const double slope = (a[i] - 8 * b[i] + 8 * c[i] - d[i]) / (12 * h) / eps_slope;
    EXPECT_NEAR(exact.change[i], slope, 1e-7 * std::abs(slope) + 1e-7) << i + 1;  // h^4 times a fifth derivative
  }
}

TEST(TruncatedForce, ReproducesTheReferenceValues) {
  const auto check = [](const char* name, auto member) {
    for (const auto& entry : test::reference().at(name)) {
      const int N = static_cast<int>(entry.input("N"));
      const TruncatedForce force = truncated_force(uniform_harmonics(test::fraction(entry.text("kappa")), N));
      EXPECT_NEAR(force.*member, entry.value, bound(entry)) << name << entry.inputs;
    }
  };
  check("g3_truncated", &TruncatedForce::g3);
  check("g5_truncated_no_integral", &TruncatedForce::g5_without_integral);
  check("g5_truncated_with_integral", &TruncatedForce::g5);
}

// The collapsed double series against the velocities of the truncated series, squared and integrated over the wall by a
// Gauss rule that is exact for them.
TEST(TruncatedForce, HasTheIntegralOfTheSquaredVelocityOverTheWall) {
  const double kappa = 0.4;
  const double eps = cap_depth(kappa);
  constexpr int count = 40;
  const Harmonics a = profile_harmonics(kappa, OutflowProfile::polynomial({1, 0, -0.4}), count);
  double integral = 0;
  for (const double node : boost::math::legendre_p_zeros<double>(2 * count)) {
    for (const double sign : {-1.0, 1.0}) {
      if (node == 0 && sign < 0) continue;
      const double slope = boost::math::legendre_p_prime(2 * count, node);
      const double x = (eps + sign * node * (2 - eps)) / 2;
      const auto v = test::series(a, 1, std::acos(x));
      integral += (2 - eps) / ((1 - node * node) * slope * slope) * (v.radial * v.radial + v.tangential * v.tangential);
    }
  }
  const TruncatedForce force = truncated_force(a);
  EXPECT_NEAR(force.g5_without_integral - force.g5, pi * integral, 1e-11 * integral);
}

TEST(Harmonics, RefuseWhatIsNoBalloon) {
  for (const double kappa : {0.0, 1.0, -0.1, std::nan("")}) {
    EXPECT_THROW((void)uniform_harmonics(kappa, 5), InvalidInput);
    EXPECT_THROW((void)profile_harmonics(kappa, OutflowProfile::uniform(), 5), InvalidInput);
  }
  EXPECT_THROW((void)uniform_harmonics(0.1, 0), InvalidInput);
}

}  // namespace
}  // namespace turgor
