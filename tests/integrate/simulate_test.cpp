// Switching: which regime the balloon leaves a state of rest in, what counts as an event, and where runs stop.

#include "turgor/integrate/simulate.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

using test::paper_balloon;
using test::si_scales;

struct Start {
  double stretch = 1;
  double rate = 0;
};

Trajectory<double> run(const Parameters<double>& p, const PressureProgram<double>& program, Start start, double end,
                       SimulationOptions<double> options = {}, Model model = Model::full) {
  return simulate(Oscillator<double>(model, p, program, si_scales(p)), 0.0, start.stretch, start.rate, end, options);
}

Regime first_regime(const Parameters<double>& p, const PressureProgram<double>& program, double stretch) {
  const Oscillator<double> oscillator(Model::full, p, program, si_scales(p));
  return regime_from_rest(oscillator, oscillator.pressure().after(0), 0.0, stretch);
}

TEST(RegimeFromRest, IsTheSignOfTheForce) {
  const auto p = paper_balloon<double>(0.03, 0.0);
  EXPECT_EQ(first_regime(p, constant_pressure(20e3), 1.0), Regime::inflating);
  EXPECT_EQ(first_regime(p, constant_pressure(20e3), 1.3), Regime::deflating);
  EXPECT_EQ(first_regime(p, constant_pressure(0.0), 1.0), Regime::rest);
}

// Where the force vanishes the first non-vanishing derivative decides: the first of a line, the third of a smooth ramp.
TEST(RegimeFromRest, IsTheSignOfTheFirstDerivativeThatDoesNotVanish) {
  const auto p = paper_balloon<double>(0.03, 0.0);
  const auto ramp = [](double to, RampShape shape) { return SegmentList<double>(0).ramp(to, 2, shape).build(); };
  EXPECT_EQ(first_regime(p, ramp(1e3, RampShape::linear), 1.0), Regime::inflating);
  EXPECT_EQ(first_regime(p, ramp(-1e3, RampShape::linear), 1.0), Regime::deflating);
  EXPECT_EQ(first_regime(p, ramp(1e3, RampShape::smooth), 1.0), Regime::inflating);
  EXPECT_EQ(first_regime(p, ramp(-1e3, RampShape::smooth), 1.0), Regime::deflating);
  // cos has its first non-vanishing derivative at k = 2, and it is negative
  const auto cosine = harmonic_pressure(HarmonicPressure<double>{-1e3, 1e3, 0.5, std::numbers::pi / 2});
  EXPECT_EQ(first_regime(p, cosine, 1.0), Regime::deflating);
}

// An equilibrium is only known to rounding; that must not decide which way the balloon leaves it.
TEST(RegimeFromRest, IgnoresTheRoundingOfAnEquilibrium) {
  const auto p = paper_balloon<double>(0.03, 0.0);
  for (const double pressure : {1e3, 12345.6, 41313.600802474764}) {
    const double R = equilibria(p, pressure).front().stretch;
    EXPECT_EQ(first_regime(p, constant_pressure(pressure), R), Regime::rest);
    const auto up = SegmentList<double>(pressure).ramp(pressure * 1.1, 2, RampShape::smooth).build();
    const auto down = SegmentList<double>(pressure).ramp(pressure * 0.9, 2, RampShape::smooth).build();
    EXPECT_EQ(first_regime(p, up, R), Regime::inflating);
    EXPECT_EQ(first_regime(p, down, R), Regime::deflating);
    const auto trajectory = run(p, up, {R, 0}, 1.0);
    EXPECT_TRUE(trajectory.events.empty());  // it goes up and only up
    EXPECT_GT(trajectory.last.stretch, R);
  }
}

TEST(Simulate, StaysAtRestOnlyWhileThePressureIsConstant) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const auto program = SegmentList<double>(0).hold(3).ramp(10e3, 2, RampShape::smooth).hold(1).build();
  const auto trajectory = run(p, program, {}, 10.0);
  ASSERT_FALSE(trajectory.events.empty());
  EXPECT_EQ(trajectory.events[0].time, 3.0);  // decided again at the knot, exactly
  EXPECT_EQ(trajectory.events[0].before, Regime::rest);
  EXPECT_EQ(trajectory.events[0].after, Regime::inflating);
  EXPECT_EQ(trajectory.at(2.9).regime, Regime::rest);
  EXPECT_EQ(trajectory.at(2.9).stretch, 1.0);
  EXPECT_EQ(trajectory.at(3.5).regime, Regime::inflating);

  const auto asleep = run(p, constant_pressure(0.0), {}, 1e6);
  EXPECT_EQ(asleep.outcome, Outcome::reached_end);
  EXPECT_TRUE(asleep.events.empty());
  EXPECT_EQ(asleep.last.stretch, 1.0);
}

TEST(Simulate, TheStartIsNoEvent) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  EXPECT_TRUE(run(p, constant_pressure(20e3), {}, 0.1).events.empty());
  EXPECT_TRUE(run(p, constant_pressure(20e3), {1.0, -0.01}, 1e-4).events.empty());
}

TEST(Simulate, RegimesAlternateAndTheRateIsExactlyZeroAtEvents) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const auto trajectory = run(p, constant_pressure(41e3), {1.35, 0}, 200.0);
  ASSERT_GT(trajectory.events.size(), 5U);
  for (std::size_t i = 0; i < trajectory.events.size(); ++i) {
    const auto& event = trajectory.events[i];
    EXPECT_EQ(event.before, i % 2 == 0 ? Regime::deflating : Regime::inflating);
    EXPECT_EQ(event.after, i % 2 == 0 ? Regime::inflating : Regime::deflating);
    const auto& next = trajectory.step_at(event.time);
    EXPECT_EQ(next.start, event.time);
    EXPECT_EQ(next.rate_at(0), 0.0);
  }
}

// Between two events the rate keeps its sign everywhere on the dense output, up to the tolerance that it was computed
// with.
TEST(Simulate, TheRateNeverHasTheWrongSign) {
  const auto p = paper_balloon<double>(0.02, 0.0);
  const auto trajectory = run(p, test::up_hold_down(36e3, 2.0, 4.0, 6.0), {}, 30.0, {}, Model::orifice);
  ASSERT_GT(trajectory.events.size(), 10U);
  for (const auto& step : trajectory.steps) {
    for (double theta = 0; theta <= 1; theta += 0.125) {
      EXPECT_GE(static_cast<int>(step.regime) * step.rate_at(theta), -1e-7) << "at t = " << step.start;
    }
  }
}

// A fast harmonic pressure on a slowly inflating balloon makes dR/dt dip below zero and come back within one step. Over
// a sweep of amplitudes a run at 1e-5 must find the zeros that a run at 1e-11 finds, wherever their number does not
// hang on the amplitude's last per cent. (Looking only at the ends of steps misses some in a quarter of these runs.)
TEST(Simulate, FindsThePairOfZerosInsideOneStep) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const auto events = [&](double amplitude, double tolerance) {
    SimulationOptions<double> options;
    options.rtol = options.atol = tolerance;
    return run(p, harmonic_pressure(HarmonicPressure<double>{30e3, amplitude, 2.0, 0.3}), {}, 20.0, options)
        .events.size();
  };
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const double amplitude = 500 * std::pow(60.0, i / 99.0);
    const std::size_t expected = events(amplitude, 1e-11);
    if (events(1.01 * amplitude, 1e-11) != expected || events(0.99 * amplitude, 1e-11) != expected) continue;
    ++compared;
    EXPECT_EQ(events(amplitude, 1e-5), expected) << "amplitude " << amplitude;
  }
  EXPECT_GT(compared, 50);
}

// Equilibrium is neither left nor reached in finite time: turning points decay like 3/(4 beta n) (docs/theory.md), so a
// long run has many events, each half-cycle takes its time, and none of them is an accumulation point.
TEST(Simulate, FreeOscillationsDecayAlgebraicallyWithoutZeno) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const auto trajectory =
      run(p, constant_pressure(41313.600802474764), {1.2582010333829832 + 0.02, 0}, 3000.0, {}, Model::long_channel);
  ASSERT_GT(trajectory.events.size(), 200U);
  double shortest = 1e9;
  for (std::size_t i = 1; i < trajectory.events.size(); ++i) {
    shortest = std::min(shortest, trajectory.events[i].time - trajectory.events[i - 1].time);
  }
  EXPECT_GT(shortest, 1.0);  // half a period is 4.9 s
  const auto g = groups(p, si_scales(p));
  const double R = 1.2582010333829832;
  const double beta = g.C2_long * R * R + 2 / R;
  // e_n = 3/(4 beta n) (1 + O(log n/n)) for upper turning points, that is every second event
  const std::size_t n = trajectory.events.size() / 2 - 1;
  const double amplitude = trajectory.events[2 * n + 1].stretch - R;
  EXPECT_NEAR(amplitude * 4 * beta * static_cast<double>(n + 1) / 3, 1.0, 0.1);
}

TEST(Simulate, StopsWhereItIsAskedTo) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  SimulationOptions<double> options;
  options.max_events = 3;
  const auto three = run(p, constant_pressure(41e3), {1.35, 0}, 1e4, options);
  EXPECT_EQ(three.outcome, Outcome::max_events);
  EXPECT_EQ(three.events.size(), 3U);
  EXPECT_EQ(three.last.time, three.events.back().time);

  options = {};
  options.rest_tol = 1e-4;
  const auto rested = run(p, constant_pressure(20e3), {1.0, 0}, 1e5, options);
  EXPECT_EQ(rested.outcome, Outcome::at_rest);
  EXPECT_EQ(rested.last.regime, Regime::rest);
  EXPECT_NEAR(rested.last.stretch, equilibria(p, 20e3).front().stretch, 1e-4);
  EXPECT_EQ(rested.at(9e4).stretch, rested.last.stretch);

  // With a later knot the pressure is not constant for ever, so the run goes on.
  const auto later = SegmentList<double>(20e3).hold(5e3).step(10e3).build();
  EXPECT_EQ(run(p, later, {1.0, 0}, 4e3, options).outcome, Outcome::reached_end);
}

TEST(Simulate, BurstsAtItsStretchAndKeepsWhatWasComputed) {
  const auto p = paper_balloon<double>(0.03, 0.0);
  SimulationOptions<double> options;
  options.max_stretch = 2.5;
  const auto trajectory = run(p, constant_pressure(60e3), {}, 10.0, options);
  EXPECT_EQ(trajectory.outcome, Outcome::burst);
  EXPECT_EQ(trajectory.last.stretch, 2.5);
  EXPECT_NEAR(trajectory.steps.back().stretch_at(1), 2.5, 1e-9);
  EXPECT_NE(trajectory.message.find("R = 2.5"), std::string::npos);
  EXPECT_FALSE(is_complete(trajectory.outcome));
}

TEST(Simulate, SaysWhenABalloonRunsAway) {
  auto p = paper_balloon<double>(0.03, 0.5);
  p.material = NeoHookean<double>{1e6};
  const auto trajectory = run(p, constant_pressure(1e5), {}, 1e5);
  EXPECT_EQ(trajectory.outcome, Outcome::runaway);
  EXPECT_GT(trajectory.last.stretch, largest_stretch);
  EXPECT_TRUE(std::isfinite(trajectory.last.rate));
}

TEST(Simulate, StaysBelowTheStretchAtWhichTheMaterialLocks) {
  auto p = paper_balloon<double>(0.03, 0.0);
  const Gent<double> gent{3e5, 20};
  p.material = gent;
  const auto trajectory = run(p, constant_pressure(40e3), {}, 1.0);
  EXPECT_EQ(trajectory.outcome, Outcome::reached_end) << trajectory.message;
  for (const auto& step : trajectory.steps) EXPECT_LT(step.stretch_at(1), gent.stretch_limit());
  EXPECT_GT(trajectory.events.size(), 0U);
}

TEST(Simulate, CanBeInterrupted) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  SimulationOptions<double> options;
  options.keep_going = [](const double& time) { return time < 3; };
  const auto trajectory = run(p, constant_pressure(41e3), {1.35, 0}, 1e4, options);
  EXPECT_EQ(trajectory.outcome, Outcome::interrupted);
  EXPECT_GE(trajectory.last.time, 3);
  EXPECT_LT(trajectory.last.time, 100);
}

TEST(Simulate, TheLastAllowedStepMayReachTheEnd) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const auto whole = run(p, constant_pressure(20e3), {}, 5.0);
  SimulationOptions<double> options;
  options.max_steps = whole.statistics.steps;
  EXPECT_EQ(run(p, constant_pressure(20e3), {}, 5.0, options).outcome, Outcome::reached_end);
  options.max_steps -= 1;
  EXPECT_EQ(run(p, constant_pressure(20e3), {}, 5.0, options).outcome, Outcome::max_steps);
}

TEST(Simulate, RefusesAStartThatCannotBe) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  EXPECT_THROW((void)run(p, constant_pressure(0.0), {0, 0}, 1), InvalidInput);
  EXPECT_THROW((void)run(p, constant_pressure(0.0), {-1, 0}, 1), InvalidInput);
  EXPECT_THROW((void)run(p, constant_pressure(0.0), {NAN, 0}, 1), InvalidInput);
  EXPECT_THROW((void)run(p, constant_pressure(0.0), {1, INFINITY}, 1), InvalidInput);
  EXPECT_THROW((void)run(p, constant_pressure(0.0), {1, 0}, 0), InvalidInput);
  auto locking = p;
  locking.material = Gent<double>{1e5, 5};
  EXPECT_THROW((void)run(locking, constant_pressure(0.0), {3, 0}, 1), InvalidInput);
  EXPECT_THROW((void)run(locking, constant_pressure(0.0), {0.3, 0}, 1), InvalidInput);
  SimulationOptions<double> options;
  options.max_stretch = 1.5;
  EXPECT_THROW((void)run(p, constant_pressure(0.0), {1.5, 0}, 1, options), InvalidInput);
}

// Deflating through a narrow orifice, the balloon is on its slow manifold at once: explicit steps at the limit of
// stability would be hundreds; accuracy alone needs about ten.
TEST(Simulate, KeepsTheImplicitMethodOnTheSlowManifold) {
  const auto p = paper_balloon<double>(0.01, 0.0);
  SimulationOptions<double> options;
  options.rtol = options.atol = 1e-6;
  const auto creep = run(p, constant_pressure(41313.6), {1.3, 0}, 20, options);
  EXPECT_TRUE(creep.events.empty());
  EXPECT_GT(creep.statistics.linearizations, 3);
  EXPECT_LT(creep.statistics.steps, 30);
}

}  // namespace
}  // namespace turgor
