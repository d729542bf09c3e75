#include "turgor/statics/statics.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "../support/reference.hpp"

namespace turgor {
namespace {

/// The reference gives pressures in units of S2, stretches as they are; any balloon with S2 = 1 Pa will do.
Parameters<double> balloon_with(double S1, double S2) {
  auto p = test::paper_balloon<double>(0.03, 0.0);
  const double unit = p.radius / (4 * p.thickness);  // S = 4 d0 s/(r0 p_typ), eq. (2.21)
  p.material = MooneyRivlin<double>{S1 * unit, S2 * unit};
  return p;
}

double value_of(const char* name) { return test::reference().at(name).front().value; }

TEST(Statics, LimitPointsReproduceTheReferenceValues) {
  const auto points = limit_points(balloon_with(10, 1));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_TRUE(points[0].maximum);
  EXPECT_FALSE(points[1].maximum);
  // An extremum's position is known to the square root of rounding of the slope's own terms, its value to rounding.
  EXPECT_NEAR(points[0].stretch, value_of("R_extremum_max"), 1e-12);
  EXPECT_NEAR(points[1].stretch, value_of("R_extremum_min"), 1e-12);
  EXPECT_NEAR(points[0].pressure, value_of("P_max"), 1e-13);
  EXPECT_NEAR(points[1].pressure, value_of("P_min"), 1e-13);
}

TEST(Statics, EquilibriaReproduceTheReferenceValues) {
  const auto states = equilibria(balloon_with(10, 1), value_of("P0_mean"));
  ASSERT_EQ(states.size(), 3U);
  EXPECT_NEAR(states[0].stretch, value_of("R_eq_small_stable"), 1e-13);
  EXPECT_NEAR(states[1].stretch, value_of("R_eq_unstable"), 1e-13);
  EXPECT_NEAR(states[2].stretch, value_of("R_eq_large_stable"), 1e-13);
  EXPECT_TRUE(states[0].stable);
  EXPECT_FALSE(states[1].stable);
  EXPECT_TRUE(states[2].stable);
  for (const char* name : {"R_eq1_exact", "R_eq2_exact"}) {
    for (const auto& entry : test::reference().at(name)) {
      const auto all = equilibria(balloon_with(entry.input("S1"), entry.input("S2")), entry.input("P0"));
      ASSERT_FALSE(all.empty());
      const double found = std::string(name) == "R_eq1_exact" ? all.front().stretch : all.back().stretch;
      EXPECT_NEAR(found, entry.value, 1e-12) << entry.inputs;
    }
  }
}

// Bistable if and only if S1/S2 > 4.6629..., where the two limit points merge in a cusp.
TEST(Statics, LimitPointsAppearAtTheCriticalRatio) {
  const double critical = value_of("critical_S1_over_S2");
  EXPECT_TRUE(limit_points(balloon_with(critical * (1 - 1e-4), 1)).empty());
  const auto points = limit_points(balloon_with(critical * (1 + 1e-4), 1));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR((points[0].stretch + points[1].stretch) / 2, value_of("critical_R"), 1e-3);
}

// Elementary calculus: P = mu d0/r0 (R^-1 - R^-7) is greatest at R = 7^(1/6).
TEST(Statics, NeoHookeanBalloonHasItsMaximumAtTheSixthRootOfSeven) {
  auto p = balloon_with(1, 1);
  p.material = NeoHookean<double>{1e6};
  const auto points = limit_points(p);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points[0].stretch, std::pow(7.0, 1.0 / 6), 1e-12);
  EXPECT_TRUE(equilibria(p, 1.01 * points[0].pressure).empty());
  EXPECT_EQ(equilibria(p, 0.99 * points[0].pressure).size(), 2U);
}

TEST(Statics, StaticPressureIsTheSlopeOfTheEnergyPerVolume) {
  auto p = balloon_with(10, 1);
  for (const Material<double>& material :
       {Material<double>(Gent<double>{4e5, 30}), p.material, Material<double>(ArrudaBoyce<double>{3e5, 4})}) {
    p.material = material;
    for (const double R : {0.7, 1.2, 2.5}) {
      const double h = 1e-5;
      const auto energy = [&](double x) {
        return 4 * std::numbers::pi * p.radius * p.radius * p.thickness * strain_energy(material, x).value;
      };
      const auto volume = [&](double x) { return 4 * std::numbers::pi / 3 * std::pow(p.radius * x, 3); };
      const double expected = (energy(R + h) - energy(R - h)) / (volume(R + h) - volume(R - h));
      EXPECT_NEAR(static_pressure(p, R).value, expected, 1e-8 * std::abs(expected));  // O(h^2)
      const double slope = (static_pressure(p, R + h).value - static_pressure(p, R - h).value) / (2 * h);
      EXPECT_NEAR(static_pressure(p, R).slope, slope, 1e-7 * (std::abs(slope) + std::abs(expected)));
    }
  }
}

// Chains lock in compression too, where I1 - 3 = jm with R < 1: nothing beyond that is an equilibrium.
TEST(Statics, LockingMaterialsHaveNoSpuriousEquilibria) {
  auto p = balloon_with(10, 1);
  for (const Material<double>& material :
       {Material<double>(Gent<double>{4e5, 30}), Material<double>(Fung<double>{5e4, 0.8}),
        Material<double>(Fung<double>{5e4, 50})}) {
    p.material = material;
    const double pressure = static_pressure(p, 1.15).value;
    const auto states = equilibria(p, pressure);
    ASSERT_FALSE(states.empty());
    EXPECT_NEAR(states.front().stretch, 1.15, 1e-12);
  }
}

// Rest is where the oscillator feels no force, with the area that the pressure works on, and stable where the force
// points back.
TEST(Statics, ExactClosureRestsWhereTheForceChangesSign) {
  const auto p = test::with_closure(test::paper_balloon<double>(0.15, 0.4), Closure::potential);
  const double pressure = 45e3;
  const Oscillator<double> oscillator(Model::full, p, constant_pressure(pressure), test::si_scales(p));
  const auto states = equilibria(p, pressure);
  ASSERT_EQ(states.size(), 3U);
  for (const auto& state : states) {
    EXPECT_GT(oscillator.force_at_rest(state.stretch * (state.stable ? 1 - 1e-9 : 1 + 1e-9), pressure), 0);
    EXPECT_LT(oscillator.force_at_rest(state.stretch * (state.stable ? 1 + 1e-9 : 1 - 1e-9), pressure), 0);
  }
  const auto fitted = equilibria(test::paper_balloon<double>(0.15, 0.4), 44e3);
  EXPECT_GT(std::abs(fitted.front().stretch - equilibria(p, 44e3).front().stretch), 1e-3);

  for (const double R : {0.7, 1.0, 1.3, 4.0}) {
    EXPECT_NEAR(static_pressure(p, R).value, oscillator.coefficients(Regime::inflating, R).elastic / oscillator.area(R),
                1e-11 * 45e3);
    const double h = 1e-5;
    const double slope = (static_pressure(p, R + h).value - static_pressure(p, R - h).value) / (2 * h);
    EXPECT_NEAR(static_pressure(p, R).slope, slope, 1e-7 * (std::abs(slope) + 45e3));  // O(h^2)
  }
  for (const auto& point : limit_points(p)) {
    EXPECT_NEAR(static_pressure(p, point.stretch).slope, 0, 1e-8 * point.pressure);
    const auto lower = static_pressure(p, point.stretch - 1e-3).value;
    EXPECT_EQ(lower < point.pressure, point.maximum);
  }
  EXPECT_EQ(limit_points(p).size(), 2U);
}

// One balloon after another of the same material: what is remembered of the last must not serve the next.
TEST(Statics, LimitPointsDependOnTheOrificeOfAnExactClosure) {
  const auto first = [](double orifice_radius, Closure closure) {
    const auto p = test::with_closure(test::paper_balloon<double>(orifice_radius, 0.0), closure);
    const LimitPoint point = limit_points(p).front();
    EXPECT_NEAR(static_pressure(p, point.stretch).slope, 0, 1e-8 * point.pressure);
    return point;
  };
  const auto fitted = first(0.15, Closure::corrected);
  const auto wide = first(0.15, Closure::potential);
  const auto narrow = first(0.003, Closure::potential);
  EXPECT_EQ(first(0.003, Closure::corrected).stretch, fitted.stretch);
  EXPECT_GT(wide.pressure, narrow.pressure);
  EXPECT_GT(narrow.pressure, fitted.pressure);
  EXPECT_NEAR(narrow.pressure / fitted.pressure, 1, 1e-4);  // eps/2
}

// r_ch/r <= 0.75: a balloon that would have to shrink below has no equilibrium.
TEST(Statics, ExactClosureHasNoEquilibriaBeyondItsRange) {
  const auto p = test::with_closure(test::paper_balloon<double>(0.21, 0.0), Closure::potential);
  const double least = closure_limits(p).least;
  EXPECT_NEAR(least, 0.7 / 0.75, 1e-15);
  const double pressure = static_pressure(p, least).value;
  EXPECT_EQ(equilibria(p, 0.99 * pressure).size(), 1U);
  EXPECT_TRUE(equilibria(p, 1.01 * pressure).empty());
}

TEST(Statics, CompressedBalloonHoldsNegativePressure) {
  const auto states = equilibria(balloon_with(10, 1), -3.0);
  ASSERT_EQ(states.size(), 1U);
  EXPECT_LT(states[0].stretch, 1);
  EXPECT_TRUE(states[0].stable);
}

}  // namespace
}  // namespace turgor
