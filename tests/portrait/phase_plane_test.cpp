// Curves of the phase plane against closed first integrals, time stepping and the paper's formulas.

#include "turgor/portrait/phase_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../support/balloons.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/integrate/simulate.hpp"

namespace turgor {
namespace {

using test::paper_balloon;
using test::with_closure;

constexpr double s2 = 6000;  // S2 p_typ of the paper's balloon [Pa]
constexpr double bistable = 6.88560013375 * s2;

Oscillator<double> balloon(Model model, double orifice, double channel, Closure closure = Closure::corrected,
                           double pressure = bistable) {
  const Parameters<double> p = with_closure(paper_balloon(orifice, channel), closure);
  const PressureProgram<double> program = constant_pressure(pressure);
  return {model, p, program, natural_scales(p, program, 1)};
}

/// One of each model, and exact closures without and with a channel.
std::vector<Oscillator<double>> all_kinds() {
  return {balloon(Model::orifice, 0.03, 0),
          balloon(Model::long_channel, 0.03, 0.5),
          balloon(Model::full, 0.01, 0.5),
          balloon(Model::full, 0.03, 0, Closure::theoretical),
          balloon(Model::orifice, 0.03, 0, Closure::potential),
          balloon(Model::full, 0.03, 0.5, Closure::potential)};
}

PhaseWindow window_of(const PhasePlane& plane) {
  const double slow = std::max(-plane.slow_rate(5.5).value(), -plane.slow_rate(1.5).value());
  const PhaseCurve rise = plane.path({0.8, 0}, Regime::inflating, Course::forward, {0.5, 6, 1, 1}, 1);
  return {0.7, 6, 3 * slow, std::ranges::max(rise, {}, &PhasePoint::rate).rate};
}

TEST(PhasePlane, InflationKeepsTheClosedFirstIntegral) {
  for (const Oscillator<double>& oscillator : all_kinds()) {
    const PhasePlane plane(oscillator, bistable);
    EXPECT_EQ(plane.first_integral({2, 0}).has_value(), oscillator.force_table() == nullptr);
    if (oscillator.force_table() != nullptr) continue;
    for (const double R : {0.8, 1.1, 2.5, 4.0}) {
      const PhaseCurve curve = plane.path({R, 0}, Regime::inflating, Course::forward, window_of(plane), 1);
      const double kept = *plane.first_integral(curve.front());
      double size = 0;  // of the terms
      for (const PhasePoint& p : curve) size = std::max(size, 2 * oscillator.elastic_energy(p.stretch));
      for (const PhasePoint& p : curve) ASSERT_NEAR(*plane.first_integral(p), kept, 1e-14 * size) << p.stretch;
      EXPECT_EQ(curve.back().rate, 0);
    }
  }
}

/// From a state to a drawn curve, in units of the window.
double distance(const PhaseCurve& curve, const PhasePoint& from, const PhaseWindow& window) {
  const double width = window.greatest_stretch - window.least_stretch;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double x = (curve[i].stretch - curve[i - 1].stretch) / width;
    const double y = window.height(curve[i].rate) - window.height(curve[i - 1].rate);
    const double u = (from.stretch - curve[i - 1].stretch) / width;
    const double v = window.height(from.rate) - window.height(curve[i - 1].rate);
    const double along = std::clamp((u * x + v * y) / std::max(x * x + y * y, 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(u - along * x, v - along * y));
  }
  return nearest;
}

// Three strokes of every kind against the adaptive integrator: turning points to its tolerance, and all of it to a
// few times the 1e-4 of the window that curves are drawn with, which is tested at three places of every chord.
TEST(PhasePlane, PathsAreWhatTheIntegratorFinds) {
  for (const Oscillator<double>& oscillator : all_kinds()) {
    const PhasePlane plane(oscillator, bistable);
    const PhaseWindow window = window_of(plane);
    for (const PhasePoint start :
         {PhasePoint{1.0, 0}, {1.6, 0}, {3.0, window.inflation / 9}, {5.6, 0}, {3.0, -0.9 * window.deflation}}) {
      SimulationOptions<double> options;
      options.rtol = options.atol = 1e-12;
      options.max_events = 3;
      const auto run = simulate<double>(oscillator, 0, start.stretch, start.rate, 1e6, options);
      ASSERT_EQ(run.events.size(), 3U);
      const PhaseCurve curve = plane.path(start, run.steps.front().regime, Course::forward, window, 3);
      std::vector<double> turns;
      for (std::size_t i = 1; i < curve.size(); ++i) {
        if (curve[i].rate == 0) turns.push_back(curve[i].stretch);
      }
      ASSERT_EQ(turns.size(), 3U);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(turns[i], run.events[i].stretch, 3e-10) << start.stretch;
      for (const auto& step : run.steps) {
        const PhasePoint at{step.stretch_at(0.5), step.rate_at(0.5)};
        EXPECT_LT(distance(curve, at, window), 3e-4) << start.stretch << ": " << at.stretch << " " << at.rate;
      }
    }
  }
}

TEST(PhasePlane, BackwardIsTheWayForwardUndone) {
  for (const Oscillator<double>& oscillator : all_kinds()) {
    const PhasePlane plane(oscillator, bistable);
    const PhaseWindow window = window_of(plane);
    const PhaseCurve rise = plane.path({1.0, 0}, Regime::inflating, Course::forward, window, 1);
    const PhaseCurve fall = plane.path(rise.back(), Regime::inflating, Course::backward, window, 1);
    EXPECT_NEAR(fall.back().stretch, 1.0, 1e-13);
    const PhaseCurve back = plane.path({1.1, 0}, Regime::deflating, Course::backward, window, 1);
    EXPECT_NEAR(back.back().rate, -window.deflation, 1e-9 * window.deflation);
    const PhaseCurve again = plane.path(back.back(), Regime::deflating, Course::forward, window, 1);
    EXPECT_NEAR(again.back().stretch, 1.1, 1e-11);
  }
}

// Points of a curve are so close that its chords show nothing that is not there.
TEST(PhasePlane, CurvesAreDense) {
  const PhasePlane plane(balloon(Model::orifice, 0.03, 0), bistable);
  const PhaseWindow window = window_of(plane);
  const PhaseCurve curve = plane.path({5.9, 0}, Regime::deflating, Course::forward, window, 2);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_LE(std::abs(curve[i].stretch - curve[i - 1].stretch), (6 - 0.7) / 60);
    EXPECT_LE(std::abs(window.height(curve[i].rate) - window.height(curve[i - 1].rate)), 1.0 / 60);
  }
  EXPECT_LT(curve.size(), 3000U);
}

// (3.21), and the first correction, against the exact motion from rest far above.
TEST(PhasePlane, SlowManifoldAndItsCorrection) {
  for (const Oscillator<double>& oscillator : all_kinds()) {
    const PhasePlane plane(oscillator, bistable);
    const PhaseWindow window = window_of(plane);
    const PhaseCurve exact = plane.path({8, 0}, Regime::deflating, Course::forward, window, 1);
    for (const PhasePoint& p : exact) {
      if (p.stretch < 5.2 || p.stretch > 7) continue;
      const double leading = std::abs(*plane.slow_rate(p.stretch) / p.rate - 1);
      const double corrected = std::abs(*plane.corrected_slow_rate(p.stretch) / p.rate - 1);
      EXPECT_LT(corrected, 0.02 * leading) << p.stretch;
      EXPECT_LT(leading, 0.06);
    }
  }
  // As printed, with p_typ = 1 Pa and t_typ = 1 s.
  const Parameters<double> p = paper_balloon(0.03, 0.0);
  const Oscillator<double> si(Model::orifice, p, constant_pressure(0.0), test::si_scales(p));
  const PhasePlane plane(si, bistable);
  const auto& g = si.dimensionless_groups();
  const double S2 = 4 * p.thickness * 150000 / p.radius;
  const double S1 = 10 * S2;
  const auto square = [&](double R) {
    return g.C1 / g.C2 * (S1 * (R - std::pow(R, -5)) + S2 * (R * R * R - std::pow(R, -3)) - R * R * bistable) /
           std::pow(R, 6);
  };
  for (const double R : {1.4, 1.9, 4.9, 6.0}) {
    EXPECT_NEAR(*plane.slow_rate(R), -std::sqrt(square(R)), 1e-12);
    const double slope = (square(R + 1e-5) - square(R - 1e-5)) / 2e-5;
    EXPECT_NEAR(*plane.corrected_slow_rate(R), -std::sqrt(square(R) + slope / (2 * g.C2 * R * R)), 1e-9);
  }
  for (const double R : {1.0, 2.1, 4.7}) EXPECT_FALSE(plane.slow_rate(R) || plane.corrected_slow_rate(R));
}

// A wall that locks turns every motion.
TEST(PhasePlane, LockingWallsHoldEverything) {
  Parameters<double> stiff = paper_balloon(0.03, 0.0);
  stiff.material = Gent<double>{1e6, 30};
  const Oscillator<double> oscillator(Model::orifice, stiff, constant_pressure(0.0), test::si_scales(stiff));
  for (const double pressure : {5e3, 5e4, 5e12}) {
    const PhasePlane plane(oscillator, pressure);
    ASSERT_FALSE(plane.equilibria().empty());
    for (const double rate : {-1e3, 0.0, 1.0, 1e4}) {
      const Fate fate = plane.final_well(2, rate);
      EXPECT_EQ(fate.outcome, Outcome::at_rest) << pressure << " " << rate;
      EXPECT_EQ(fate.stretch, plane.equilibria().back().stretch);
    }
  }
}

TEST(PhasePlane, FatesWithoutAWell) {
  Parameters<double> soft = paper_balloon(0.03, 0.0);
  soft.material = NeoHookean<double>{1e6};
  const Oscillator<double> oscillator(Model::orifice, soft, constant_pressure(0.0), test::si_scales(soft));
  const PhasePlane above(oscillator, 20000);  // its maximum is 12.4 kPa
  EXPECT_TRUE(above.equilibria().empty());
  EXPECT_EQ(above.final_well(1.2, 0).outcome, Outcome::runaway);
  EXPECT_EQ(above.final_well(1.2, -0.5).outcome, Outcome::runaway);
  const PhasePlane below(oscillator, 8000);
  const double wall = below.equilibria().back().stretch;
  EXPECT_EQ(below.final_well(wall + 1e-9, 0).outcome, Outcome::runaway);
  const Fate well = below.final_well(wall - 1e-9, 0);
  EXPECT_EQ(well.outcome, Outcome::at_rest);
  EXPECT_EQ(well.well, 1);
  EXPECT_EQ(well.stretch, below.equilibria().front().stretch);
  EXPECT_EQ(below.final_well(wall, 0).well, 0);

  const Oscillator<double> paper = balloon(Model::orifice, 0.03, 0);
  const PhasePlane bursting(paper, bistable, 5.5);
  EXPECT_EQ(bursting.final_well(0.8, 0).outcome, Outcome::burst);
  EXPECT_EQ(bursting.final_well(5.4, 0).well, 2);
  const PhasePlane closed(balloon(Model::orifice, 0.2, 0, Closure::potential), bistable);
  EXPECT_EQ(closed.final_well(0.95, -50).outcome, Outcome::closure_end);
  EXPECT_THROW((void)closed.final_well(0.8, 0), InvalidInput);
  EXPECT_THROW((void)closed.final_well(2, std::nan("")), InvalidInput);
  EXPECT_THROW((void)closed.final_well(2, 1e200), InvalidInput);
  EXPECT_EQ(PhasePlane(paper, bistable).final_well(2, 1e9).outcome, Outcome::runaway);
}

}  // namespace
}  // namespace turgor
