// What a portrait puts together: window, forbidden intervals, basins.

#include "turgor/portrait/portrait.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/balloons.hpp"
#include "../support/seed.hpp"

namespace turgor {
namespace {

using test::between;
using test::paper_balloon;

constexpr double bistable = 6.88560013375 * 6000;  // [Pa]

PhasePlane plane_of(Model model, double channel, double pressure, double max_stretch = 0) {
  const Parameters<double> p = paper_balloon(0.03, channel);
  const PressureProgram<double> program = constant_pressure(pressure);
  return {Oscillator<double>(model, p, program, natural_scales(p, program, 1)), pressure, max_stretch};
}

std::vector<PhasePlane> planes() {
  return {plane_of(Model::orifice, 0, bistable), plane_of(Model::long_channel, 0.5, bistable),
          plane_of(Model::full, 0.5, bistable), plane_of(Model::orifice, 0, 0),
          plane_of(Model::orifice, 0, bistable, 5.5)};
}

TEST(Portrait, NaturalWindowShowsTheEquilibriaAndTheMotionAboutThem) {
  for (const PhasePlane& plane : planes()) {
    const PhaseWindow window = natural_window(plane);
    for (const Equilibrium& e : plane.equilibria()) {
      EXPECT_LT(window.least_stretch, e.stretch);
      EXPECT_GT(window.greatest_stretch, e.stretch);
    }
    const Portrait portrait = make_portrait(plane, window);
    for (const KindOfCurve& curve : portrait.curves) {
      ASSERT_GE(curve.points.size(), 2U);
      for (const PhasePoint& p : curve.points) {
        ASSERT_TRUE(std::isfinite(p.stretch) && std::isfinite(p.rate));
        if (p.stretch < window.least_stretch || p.stretch > window.greatest_stretch) continue;
        EXPECT_TRUE(curve.kind != CurveKind::inflation || p.rate <= window.inflation);
        EXPECT_TRUE(curve.kind != CurveKind::slow_manifold || p.rate >= -window.deflation);
      }
    }
    const PhaseWindow wished = natural_window(plane, {1.1, 1.4, 2, 3});
    EXPECT_EQ(wished.least_stretch, 1.1);
    EXPECT_EQ(wished.greatest_stretch, 1.4);
    EXPECT_EQ(wished.deflation, 2);
    EXPECT_EQ(wished.inflation, 3);
  }
}

// (3.21) has no real value below the small equilibrium and between the unstable and the large one.
TEST(Portrait, SlowDeflationIsForbiddenWhereTheForceIsOutward) {
  const PhasePlane plane = plane_of(Model::orifice, 0, bistable);
  const PhaseWindow window = natural_window(plane);
  const Portrait portrait = make_portrait(plane, window);
  ASSERT_EQ(portrait.forbidden.size(), 2U);
  EXPECT_EQ(portrait.forbidden[0].from, window.least_stretch);
  EXPECT_EQ(portrait.forbidden[0].to, plane.equilibria()[0].stretch);
  EXPECT_EQ(portrait.forbidden[1].from, plane.equilibria()[1].stretch);
  EXPECT_EQ(portrait.forbidden[1].to, plane.equilibria()[2].stretch);
  // With a channel so long that Q_- = n R^6 - 2 b R^3 changes its sign within the window: R^3 = 2b/n.
  const PhasePlane slender = plane_of(Model::full, 400, 0);
  const auto& g = slender.oscillator().dimensionless_groups();
  const double turn = std::cbrt(2 * g.b / g.n);
  ASSERT_GT(turn, 1.5);
  const Portrait other = make_portrait(slender, natural_window(slender, {0.9, 3, 0, 0}));
  ASSERT_EQ(other.forbidden.size(), 1U);
  EXPECT_NEAR(other.forbidden[0].to, turn, 1e-12);
}

// Anywhere in a strip final_well() is what the strip says, but next to the separatrix, which has been interpolated; and
// the strips leave nothing out.
TEST(Portrait, StripsOfBasinsCoverTheWindow) {
  std::mt19937_64 random(test::random_seed());
  for (const PhasePlane& plane : planes()) {
    const PhaseWindow window = natural_window(plane);
    const Portrait portrait = make_portrait(plane, window);
    double area = 0;
    for (const BasinStrip& strip : portrait.basins) {
      for (std::size_t i = 1; i + 1 < strip.columns.size(); ++i) {
        const auto& [R, low, high] = strip.columns[i];
        area += (high - low) / (window.deflation + window.inflation);
        const Fate fate = plane.final_well(R, low + (high - low) * between(random, 0.01, 0.99));
        EXPECT_EQ(fate.outcome, strip.fate.outcome);
        EXPECT_EQ(fate.well, strip.fate.well) << R;
      }
    }
    EXPECT_NEAR(area, 600, 1e-9);
    for (const RestInterval& rest : portrait.at_rest) {
      const double R = between(random, rest.stretches.from, rest.stretches.to);
      EXPECT_EQ(plane.final_well(R, 0).well, rest.fate.well) << R;
    }
  }
}

}  // namespace
}  // namespace turgor
