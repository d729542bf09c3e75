// Basins by exact half-cycles against integrating many balloons.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <span>

#include "../support/balloons.hpp"
#include "../support/seed.hpp"
#include "turgor/ensemble/ensemble.hpp"
#include "turgor/portrait/phase_plane.hpp"

namespace turgor {
namespace {

using test::between;
using test::paper_balloon;
using test::with_closure;

constexpr double bistable = 6.88560013375 * 6000;  // [Pa]

struct Balloon {
  std::string name;
  Model model;
  double orifice;
  double channel;
  Closure closure;
  std::size_t members;
};

PhaseWindow window_of(const PhasePlane& plane) {
  const PhaseCurve rise = plane.path({0.8, 0}, Regime::inflating, Course::forward, {0.5, 6, 1, 1}, 1);
  return {0.7, 6, -3 * plane.slow_rate(5.5).value(), 1.2 * std::ranges::max(rise, {}, &PhasePoint::rate).rate};
}

/// How far a state is from another basin, along R at the same rate or along the rate at the same R, whichever is less;
/// in units of the window's width and height, at most `reach`. One alone will not do: boundaries run along both.
double distance_from_boundary(const PhasePlane& plane, const PhasePoint& at, const PhaseWindow& window, double reach) {
  const int well = plane.final_well(at.stretch, at.rate).well;
  const double width = window.greatest_stretch - window.least_stretch;
  const double height = at.rate < 0 ? window.deflation : window.inflation;
  double nearest = reach;
  for (const PhasePoint& way : {PhasePoint{-width, 0}, {width, 0}, {0, -height}, {0, height}}) {
    const auto stays = [&](double d) {
      return plane.final_well(at.stretch + d * way.stretch, at.rate + d * way.rate).well == well;
    };
    if (stays(nearest)) continue;
    double same = 0;
    double other = nearest;
    for (int i = 0; i < 40; ++i) {
      const double middle = (same + other) / 2;
      (stays(middle) ? same : other) = middle;
    }
    nearest = other;
  }
  return nearest;
}

/// Half of them anywhere in the window, in inflation as often as in deflation, half at 1e-13 to 1e-1 from a boundary.
std::vector<PhasePoint> starts(const PhasePlane& plane, std::size_t count, std::mt19937_64& random) {
  const PhaseWindow window = window_of(plane);
  const std::vector<PhaseCurve> boundaries = plane.separatrices(window);
  std::vector<PhasePoint> all;
  while (all.size() < count / 2) {
    all.push_back({between(random, window.least_stretch, window.greatest_stretch),
                   all.size() % 2 == 0 ? between(random, 0, window.inflation) : between(random, -window.deflation, 0)});
  }
  while (all.size() < count) {
    const PhaseCurve& curve = boundaries[all.size() % 2];  // of the saddle, which they start at
    const auto& [R, rate] = curve[std::uniform_int_distribution<std::size_t>(1, curve.size() - 1)(random)];
    const double off = std::pow(10, between(random, -13, -1)) * (between(random, 0, 1) < 0.5 ? -1 : 1);
    if (R + off > plane.least_stretch()) all.push_back({R + off, rate});
  }
  return all;
}

class Basins : public testing::TestWithParam<Balloon> {};

// What the integrator does at tolerance 1e-11 differs from the exact basin only within 1e-8 of the boundary.
TEST_P(Basins, AreWhatAnEnsembleFinds) {
  const Balloon& b = GetParam();
  const Parameters<double> p = with_closure(paper_balloon(b.orifice, b.channel), b.closure);
  const PressureProgram<double> program = constant_pressure(bistable);
  const Oscillator<double> oscillator(b.model, p, program, natural_scales(p, program, 1));
  const PhasePlane plane(oscillator, bistable);
  ASSERT_EQ(plane.equilibria().size(), 3U);
  std::mt19937_64 random(test::random_seed());
  const std::vector<PhasePoint> states = starts(plane, b.members, random);
  SimulationOptions<double> options;
  options.rtol = options.atol = 1e-11;
  options.rest_tol = 0.05;  // a turning point as near as that to a stable equilibrium is far below the saddle
  std::vector<Member> members;
  for (const PhasePoint& s : states) members.push_back({oscillator, s.stretch, s.rate, 1e9, options});
  std::vector<MemberSummary> summaries(members.size());
  integrate_ensemble(members, {}, summaries);

  int disagree = 0;
  double farthest = 0;
  std::array<int, 3> found{};
  for (std::size_t i = 0; i < states.size(); ++i) {
    ASSERT_EQ(summaries[i].outcome, Outcome::at_rest) << summaries[i].message;
    const Fate fate = plane.final_well(states[i].stretch, states[i].rate);
    ASSERT_EQ(fate.outcome, Outcome::at_rest);
    ++found.at(static_cast<std::size_t>(fate.well));
    if (plane.well_of(summaries[i].last.stretch) == fate.well) continue;
    ++disagree;
    farthest = std::max(farthest, distance_from_boundary(plane, states[i], window_of(plane), 1e-3));
  }
  EXPECT_LT(farthest, 1e-8);
  EXPECT_GT(found[1], static_cast<int>(b.members / 20));
  EXPECT_GT(found[2], static_cast<int>(b.members / 20));
  std::cout << b.name << ": " << disagree << " of " << states.size() << " disagree, the farthest " << farthest
            << " from the boundary; wells " << found[1] << ", " << found[2] << "\n";
}

INSTANTIATE_TEST_SUITE_P(
    All, Basins,
    testing::Values(Balloon{"orifice_30mm", Model::orifice, 0.03, 0, Closure::corrected, 10'000},
                    Balloon{"orifice_10mm", Model::orifice, 0.01, 0, Closure::corrected, 10'000},
                    Balloon{"channel_30mm", Model::long_channel, 0.03, 0.5, Closure::corrected, 10'000},
                    Balloon{"channel_10mm", Model::long_channel, 0.01, 0.5, Closure::corrected, 10'000},
                    Balloon{"full_30mm", Model::full, 0.03, 0.5, Closure::corrected, 10'000},
                    Balloon{"potential_30mm", Model::full, 0.03, 0.5, Closure::potential, 500}),
    [](const auto& each) { return each.param.name; });

// The separatrix: a little to one side one well, to the other side the other.
TEST_P(Basins, AreDividedByTheSeparatrix) {
  const Balloon& b = GetParam();
  const Parameters<double> p = with_closure(paper_balloon(b.orifice, b.channel), b.closure);
  const PressureProgram<double> program = constant_pressure(bistable);
  const PhasePlane plane({b.model, p, program, natural_scales(p, program, 1)}, bistable);
  const std::vector<PhaseCurve> curves = plane.separatrices(window_of(plane));
  ASSERT_EQ(curves.size(), has_table(b.closure) ? 3U : 2U);  // the last is where the closure's range is left
  for (const PhaseCurve& curve : std::span(curves).first(2)) {
    ASSERT_GT(curve.size(), 10U);
    for (std::size_t i = 1; i < curve.size(); i += 7) {
      const auto& [R, rate] = curve[i];
      constexpr double off = 1e-9;
      EXPECT_NE(plane.final_well(R - off, rate).well, plane.final_well(R + off, rate).well) << R << " " << rate;
    }
  }
}

}  // namespace
}  // namespace turgor
