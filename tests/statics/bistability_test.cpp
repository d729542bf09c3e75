#include "turgor/statics/bistability.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <numbers>

#include "../support/balloons.hpp"
#include "../support/reference.hpp"
#include "turgor/statics/energy.hpp"

namespace turgor {
namespace {

/// The paper's balloon in another material.
Parameters<double> balloon_of(const Material<double>& material, Closure closure = Closure::corrected) {
  auto p = test::with_closure(test::paper_balloon<double>(0.03, 0.0), closure);
  p.material = material;
  return p;
}

/// S2 p_typ = 1 Pa.
Parameters<double> balloon_with_ratio(double ratio, Closure closure = Closure::corrected) {
  const auto p = test::paper_balloon<double>(0.03, 0.0);
  const double unit = p.radius / (4 * p.thickness);
  return balloon_of(MooneyRivlin<double>{ratio * unit, unit}, closure);
}

double integral(const std::function<double(double)>& f, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, 5, 1e-13);
}

/// dV/dR by the definition, with the cap cut off by an exact closure's orifice.
double volume_rate(const Parameters<double>& p, double R) {
  const double kappa = has_table(p.closure) ? p.orifice_radius / p.radius / R : 0;
  return 2 * std::numbers::pi * std::pow(p.radius, 3) * R * R * (1 + std::sqrt(1 - kappa * kappa));
}

const std::vector<Parameters<double>> bistable_balloons{balloon_with_ratio(10),
                                                        balloon_with_ratio(10, Closure::potential),
                                                        balloon_with_ratio(4.7),
                                                        balloon_with_ratio(50),
                                                        balloon_of(Gent<double>{4e5, 30}),
                                                        balloon_of(Fung<double>{4e5, 0.01}),
                                                        balloon_of(ArrudaBoyce<double>{3e5, 5})};

// pi r0^3 p_typ [S1 (2 R^2 + R^-4 - 3) + S2 (R^4 + 2 R^-2 - 3) - (4/3) R^3 P0], eq. (3.2) as printed
TEST(Energy, IsThePaperSForMooneyRivlin) {
  const auto p = balloon_with_ratio(10);
  for (const double R : {0.8, 1.0, 1.7, 4.8}) {
    for (const double P : {-1.0, 0.0, 6.8}) {
      const double bracket =
          10 * (2 * R * R + std::pow(R, -4) - 3) + (std::pow(R, 4) + 2 / (R * R) - 3) - 4 * R * R * R * P / 3;
      const double expected = std::numbers::pi * 0.027 * bracket;
      EXPECT_NEAR(potential_energy(p, R, P), expected, 1e-13 * (1 + std::abs(expected)));
    }
  }
}

TEST(Energy, IsTheIntegralOfTheForce) {
  for (const auto& p : bistable_balloons) {
    const double pressure = 0.8 * static_pressure(p, 1.3).value;
    const auto force = [&](double R) { return (static_pressure(p, R).value - pressure) * volume_rate(p, R); };
    const double expected = integral(force, 1.05, 2.5);
    EXPECT_NEAR(potential_energy(p, 2.5, pressure) - potential_energy(p, 1.05, pressure), expected,
                1e-12 * pressure * working_volume(p, 2.5));
  }
}

// Two independent rules: equal depths of the wells, and equal areas in the plane of pressure and volume.
TEST(Bistability, MaxwellSPressureCutsEqualAreas) {
  for (const auto& p : bistable_balloons) {
    const auto windows = bistable_windows(p);
    ASSERT_EQ(windows.size(), 1U);
    ASSERT_TRUE(windows[0].maxwell);
    const double pressure = *windows[0].maxwell;
    EXPECT_GT(pressure, windows[0].least);
    EXPECT_LT(pressure, windows[0].greatest);
    const auto states = equilibria(p, pressure);
    ASSERT_EQ(states.size(), 3U);
    const auto area = [&](double R) { return (static_pressure(p, R).value - pressure) * volume_rate(p, R); };
    const double above = integral(area, states[0].stretch, states[1].stretch);
    const double below = integral(area, states[1].stretch, states[2].stretch);
    EXPECT_GT(above, 0);
    EXPECT_NEAR(above + below, 0, 1e-13 * pressure * working_volume(p, states[2].stretch));
  }
}

TEST(Bistability, TheWindowEndsAtTheLimitPoints) {
  for (const auto& p : bistable_balloons) {
    const auto points = limit_points(p);
    const auto windows = bistable_windows(p);
    ASSERT_EQ(windows.size(), 1U);
    EXPECT_EQ(windows[0].greatest, points[0].pressure);
    EXPECT_EQ(windows[0].least, points[1].pressure);
    const double width = windows[0].greatest - windows[0].least;
    for (const auto& [pressure, count] : {std::pair{windows[0].least - 1e-9 * width, 1},
                                          {windows[0].least + 1e-6 * width, 2},
                                          {windows[0].greatest - 1e-6 * width, 2},
                                          {windows[0].greatest + 1e-9 * width, 1}}) {
      EXPECT_EQ(std::ranges::count_if(equilibria(p, pressure), &Equilibrium::stable), count);
    }
  }
  const auto paper = bistable_windows(balloon_with_ratio(10)).front();
  EXPECT_NEAR(paper.greatest, test::reference().at("P_max").front().value, 1e-13);
  EXPECT_NEAR(paper.least, test::reference().at("P_min").front().value, 1e-13);
}

TEST(Bistability, BarriersAreIntegralsFromWellToSaddle) {
  for (const auto& p : bistable_balloons) {
    const auto window = bistable_windows(p).front();
    for (const double share : {0.1, 0.5, 0.9}) {
      const double pressure = window.least + share * (window.greatest - window.least);
      const auto states = equilibria(p, pressure);
      const auto found = wells(p, pressure);
      ASSERT_EQ(found.size(), 2U);
      EXPECT_FALSE(found[0].barrier_below);
      EXPECT_FALSE(found[1].barrier_above);
      const auto force = [&](double R) { return (static_pressure(p, R).value - pressure) * volume_rate(p, R); };
      const double tolerance = 1e-13 * pressure * working_volume(p, states[2].stretch);
      EXPECT_NEAR(*found[0].barrier_above, integral(force, states[0].stretch, states[1].stretch), tolerance);
      EXPECT_NEAR(*found[1].barrier_below, integral(force, states[2].stretch, states[1].stretch), tolerance);
      EXPECT_GT(*found[0].barrier_above, 0);
      EXPECT_GT(*found[1].barrier_below, 0);
      EXPECT_EQ(found[0].energy < found[1].energy, pressure < *window.maxwell);
    }
  }
}

TEST(Bistability, JumpsOfAPrescribedPressure) {
  for (const auto& p : bistable_balloons) {
    const auto points = limit_points(p);
    const auto found = jumps(p, prescribed_pressure);
    ASSERT_EQ(found.size(), 2U);
    for (std::size_t i : {0U, 1U}) {
      EXPECT_EQ(found[i].stretch, points[i].stretch);
      EXPECT_EQ(found[i].inflating, points[i].maximum);
      ASSERT_TRUE(found[i].to);
      EXPECT_NEAR(found[i].to_pressure, found[i].pressure, 1e-12 * found[i].pressure);
      EXPECT_GT(static_pressure(p, *found[i].to).slope, 0);
      EXPECT_EQ(*found[i].to > found[i].stretch, found[i].inflating);
      const auto work = [&](double R) { return (found[i].pressure - static_pressure(p, R).value) * volume_rate(p, R); };
      EXPECT_NEAR(found[i].released, integral(work, found[i].stretch, *found[i].to),
                  1e-12 * found[i].pressure * working_volume(p, std::max(*found[i].to, found[i].stretch)));
      EXPECT_GT(found[i].released, 0);
    }
  }
}

// Elementary calculus, for Mooney-Rivlin and a working area of R^2: dp0/dV is least where
// 4 S1 R^6 - 70 S1 - 2 S2 R^8 - 40 S2 R^2 = 0.
TEST(Bistability, CriticalComplianceOfMooneyRivlin) {
  for (const double ratio : {5.0, 10.0, 100.0}) {
    const auto p = balloon_with_ratio(ratio);
    double lo = 1.5;  // the lesser positive root: the polynomial is negative below
    double hi = 2.2;
    const auto polynomial = [&](double R) {
      return 4 * ratio * std::pow(R, 6) - 70 * ratio - 2 * std::pow(R, 8) - 40 * R * R;
    };
    ASSERT_LT(polynomial(lo) * polynomial(hi), 0);
    for (int i = 0; i < 60; ++i) (polynomial((lo + hi) / 2) < 0 ? lo : hi) = (lo + hi) / 2;
    const double slope = ratio * (-std::pow(lo, -2) + 7 * std::pow(lo, -8)) + 1 + 5 * std::pow(lo, -6);
    EXPECT_NEAR(critical_compliance(p) * -slope / volume_rate(p, lo), 1, 1e-13);
  }
  EXPECT_TRUE(std::isinf(critical_compliance(balloon_with_ratio(4.6))));
}

TEST(Bistability, FillingJumpsOnlyBeyondTheCriticalCompliance) {
  for (const auto& p : bistable_balloons) {
    const double critical = critical_compliance(p);
    EXPECT_TRUE(jumps(p, Loading{0}).empty());
    EXPECT_TRUE(jumps(p, Loading{0.999 * critical}).empty());
    const Loading soft{1.5 * critical};
    const auto found = jumps(p, soft);
    ASSERT_EQ(found.size(), 2U);
    const auto total = [&](double R) { return working_volume(p, R) + soft.compliance * static_pressure(p, R).value; };
    for (const Jump& jump : found) {
      const double h = 1e-6;  // dp0/dV = -1/C
      const double slope = (static_pressure(p, jump.stretch + h).value - static_pressure(p, jump.stretch - h).value) /
                           (working_volume(p, jump.stretch + h) - working_volume(p, jump.stretch - h));
      EXPECT_NEAR(slope * soft.compliance, -1, 1e-6);
      ASSERT_TRUE(jump.to);
      EXPECT_NEAR(total(*jump.to), total(jump.stretch), 1e-13 * total(jump.stretch));
      EXPECT_TRUE(is_stable(p, *jump.to, soft));
      // The supply's pressure at this total volume less the balloon's works on the way.
      const auto work = [&](double R) {
        const double supplied = (total(jump.stretch) - working_volume(p, R)) / soft.compliance;
        return (supplied - static_pressure(p, R).value) * volume_rate(p, R);
      };
      EXPECT_NEAR(jump.released, integral(work, jump.stretch, *jump.to), 1e-12 * jump.pressure * total(jump.stretch));
      EXPECT_GT(jump.released, 0);
    }
    const double falling = std::sqrt(limit_points(p)[0].stretch * limit_points(p)[1].stretch);
    EXPECT_FALSE(is_stable(p, falling, prescribed_pressure));
    EXPECT_TRUE(is_stable(p, falling, Loading{0}));
  }
}

// A supply of no stiffness prescribes the pressure.
TEST(Bistability, AVerySoftSupplyPrescribesThePressure) {
  const auto p = balloon_with_ratio(10);
  const auto soft = jumps(p, Loading{1e9 * critical_compliance(p)});
  const auto hard = jumps(p, prescribed_pressure);
  ASSERT_EQ(soft.size(), 2U);
  for (std::size_t i : {0U, 1U}) {
    EXPECT_NEAR(soft[i].stretch, hard[i].stretch, 1e-6);
    EXPECT_NEAR(*soft[i].to, *hard[i].to, 1e-6);
  }
}

TEST(Bistability, ACurveThatOnlyRisesHasNothingToReport) {
  for (const auto& p : {balloon_with_ratio(4), balloon_of(Fung<double>{4e5, 0.2}), balloon_of(Gent<double>{4e5, 1})}) {
    EXPECT_TRUE(bistable_windows(p).empty());
    EXPECT_TRUE(jumps(p, prescribed_pressure).empty());
    EXPECT_TRUE(jumps(p, Loading{1}).empty());
    EXPECT_TRUE(std::isinf(critical_compliance(p)));
    EXPECT_EQ(stable_branches(p).size(), 1U);
    const auto found = wells(p, static_pressure(p, 1.1).value);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].barrier_below || found[0].barrier_above);
  }
}

// One maximum and then down for ever: a well with a rim, and nothing to land on beyond it.
TEST(Bistability, ANeoHookeanBalloonHasNoSecondBranch) {
  const auto p = balloon_of(NeoHookean<double>{1e6});
  EXPECT_TRUE(bistable_windows(p).empty());
  const auto found = jumps(p, prescribed_pressure);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].inflating);
  EXPECT_FALSE(found[0].to);
  const auto held = wells(p, 0.9 * found[0].pressure);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_GT(*held[0].barrier_above, 0);
  EXPECT_TRUE(wells(p, 1.01 * found[0].pressure).empty());
}

TEST(Bistability, CompressedBalloonHasOneWell) {
  const auto found = wells(balloon_with_ratio(10), -3.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(found[0].stretch, 1);
  EXPECT_FALSE(found[0].barrier_below || found[0].barrier_above);
}

TEST(Bistability, LimitPointsAppearAtACusp) {
  const auto cusps = find_cusps([](double ratio) { return balloon_with_ratio(ratio); }, 1, 20);
  ASSERT_EQ(cusps.size(), 1U);
  EXPECT_NEAR(cusps[0].parameter, test::reference().at("critical_S1_over_S2").front().value, 1e-12);
  EXPECT_NEAR(cusps[0].stretch, test::reference().at("critical_R").front().value, 1e-7);  // half of the digits
  EXPECT_TRUE(find_cusps([](double ratio) { return balloon_with_ratio(ratio); }, 5, 20).empty());
}

// The same ratio, reached the other way round.
TEST(Bistability, LimitPointsVanishAtACusp) {
  const auto cusps = find_cusps([](double s2) { return balloon_of(MooneyRivlin<double>{1.5e6, s2}); }, 1e5, 1e6);
  ASSERT_EQ(cusps.size(), 1U);
  EXPECT_NEAR(1.5e6 / cusps[0].parameter, test::reference().at("critical_S1_over_S2").front().value, 1e-12);
}

// p0'(R) and p0''(R) of a Gent balloon both vanish at the critical jm; the number of limit points says on which side.
TEST(Bistability, CuspOfGent) {
  const auto family = [](double jm) { return balloon_of(Gent<double>{4e5, jm}); };
  const auto cusps = find_cusps(family, 2, 60);
  ASSERT_EQ(cusps.size(), 1U);
  EXPECT_TRUE(limit_points(family(cusps[0].parameter * 0.999)).empty());
  EXPECT_EQ(limit_points(family(cusps[0].parameter * 1.001)).size(), 2U);
}

}  // namespace
}  // namespace turgor
