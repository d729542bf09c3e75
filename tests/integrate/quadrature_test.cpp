// Motion under piecewise constant pressure by quadrature: against closed forms, against time stepping, and at the
// edges.

#include "turgor/integrate/quadrature.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cstdlib>
#include <iostream>
#include <random>

#include "../support/balloons.hpp"
#include "../support/same_motion.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

using test::expect_same;
using test::paper_balloon;
using test::si_scales;

template <class T>
SimulationOptions<T> at_tolerance(const T& tolerance) {
  SimulationOptions<T> options;
  options.rtol = options.atol = tolerance;
  return options;
}

/// The paper's balloon on the clock of SI units.
template <class T = double>
Oscillator<T> paper_oscillator(Model model, const PressureProgram<T>& program, const T& orifice_radius = T(3) / 100) {
  const auto p = paper_balloon<T>(orifice_radius, model == Model::orifice ? T(0) : T(1) / 2);
  return Oscillator<T>(model, p, program, si_scales(p));
}

const std::vector<Model> all_models{Model::full, Model::orifice, Model::long_channel};

// --- closed forms
// -----------------------------------------------------------------------------------------------------

// While inflating, M_+ v^2/2 + int E - P R^3/3 is constant: (2.22), (2.23), (2.25) alike, with the strain energy in
// closed form. The bound is the rounding of a hundred additions of energies.
TEST(Quadrature, ConservesTheFirstIntegralOfInflation) {
  for (const Model model : all_models) {
    const auto oscillator = paper_oscillator(model, constant_pressure(41e3));
    auto options = at_tolerance(1e-9);
    options.max_events = 1;
    const auto trajectory = simulate_by_quadrature(oscillator, 0.0, 1.0, 0.0, 1e3, options);
    ASSERT_EQ(trajectory.outcome, Outcome::max_events);
    const auto energy = [&](double R, double v) {
      const double P = 41e3;
      return oscillator.coefficients(Regime::inflating, R).mass * v * v / 2 + oscillator.elastic_energy(R) -
             P * (R * R * R - 1) / 3;
    };
    double largest = 0;
    for (const auto& step : trajectory.steps)
      largest = std::max(largest, oscillator.elastic_energy(step.stretch_at(0)));
    for (const auto& step : trajectory.steps) {
      EXPECT_NEAR(energy(step.stretch_at(0), step.rate_at(0)), 0, 2e-14 * largest) << name_of(model);
    }
    EXPECT_NEAR(energy(trajectory.last.stretch, 0), 0, 2e-14 * largest) << name_of(model);
  }
}

// Deflating from rest at R_i, w = 2 C1 int_R^{R_i} G(s) exp(-(2/3) C2 (s^3 - R^3)) ds with G = (E - a P)/R^4 for (2.23)
// and (2.25): here by adaptive Gauss-Kronrod in long double. An orifice of 3 mm makes the kernel 1e-6 wide.
TEST(Quadrature, FollowsTheIntegralOfDeflation) {
  using Real = long double;
  for (const Model model : {Model::orifice, Model::long_channel}) {
    for (const Real orifice_radius : {0.03L, 0.003L}) {
      const Real P = 30e3L;
      const Real start = 2.5L;
      const auto oscillator = paper_oscillator<Real>(model, constant_pressure(P), orifice_radius);
      const auto& g = oscillator.dimensionless_groups();
      const Real C1 = model == Model::orifice ? g.C1 : g.C1_long;
      const Real C2 = model == Model::orifice ? g.C2 : g.C2_long;
      auto options = at_tolerance<Real>(1e-9L);
      options.max_events = 1;
      const auto trajectory = simulate_by_quadrature<Real>(oscillator, 0, start, 0, 1e7L, options);
      ASSERT_EQ(trajectory.outcome, Outcome::max_events) << trajectory.message;
      for (const auto& step : trajectory.steps) {
        const Real R = step.stretch_at(0);
        if (R == start) continue;
        const auto kernel = [&](const Real& s) {
          const Real exponent = 2 * C2 / 3 * (s - R) * (s * s + s * R + R * R);
          return -oscillator.force_at_rest(s, P) / (s * s * s * s) * std::exp(-exponent);
        };
        Real integral = 0;
        const Real width = 1 / (2 * C2 * R * R);
        for (Real from = R; from < start && from < R + 60 * width; from += width) {
          integral += boost::math::quadrature::gauss_kronrod<Real, 31>::integrate(kernel, from,
                                                                                  std::min(from + width, start), 0);
        }
        const Real expected = -std::sqrt(2 * C1 * integral);
        // R itself is rounded: by a large part of what it has moved at first, and of the kernel's width.
        const Real rounding = 4 * std::numeric_limits<Real>::epsilon() * R * (1 / (start - R) + 2 * C2 * R * R);
        EXPECT_NEAR(static_cast<double>(step.rate_at(0) / expected), 1.0, static_cast<double>(1e-13L + rounding))
            << name_of(model) << " r_ch = " << orifice_radius << " at R = " << R;
      }
    }
  }
}

/// The lowest stable equilibrium of the paper's balloon with a channel, to the last digit.
long double equilibrium(const Oscillator<long double>& oscillator, long double P) {
  long double R =
      static_cast<long double>(equilibria(paper_balloon<double>(0.03, 0.5), static_cast<double>(P)).front().stretch);
  for (int i = 0; i < 3; ++i) {
    const auto c = oscillator.coefficients(Regime::inflating, R);
    R += (c.area * P - c.elastic) / (c.elastic_slope - c.area_slope * P);
  }
  return R;
}

// Half a period of small oscillations is pi/omega in either regime, with relative errors O(e^2); e C2 = 3e-5 at most.
// From a phase on the way, with its rate, what is left of it is acos(phase)/omega, with errors O(e C2) deflating and
// O(e) inflating, where the phases are therefore swept.
TEST(Quadrature, SmallHalfCyclesAreHarmonic) {
  using Real = long double;
  const Real P = 20e3L;
  for (const Model model : all_models) {
    const auto oscillator = paper_oscillator<Real>(model, constant_pressure(P));
    const Real R = equilibrium(oscillator, P);
    auto options = at_tolerance<Real>(1e-9L);
    options.max_events = 1;
    for (const Regime regime : {Regime::inflating, Regime::deflating}) {
      const auto c = oscillator.coefficients(regime, R);
      const Real omega = std::sqrt((c.elastic_slope - c.area_slope * P) / c.mass);
      const int s = static_cast<int>(regime);
      const auto check = [&](Real e, Real phase, double tolerance) {
        const Real rate = s * e * omega * std::sqrt((1 - phase) * (1 + phase));
        const auto trajectory = simulate_by_quadrature<Real>(oscillator, 0, R + s * e * phase, rate, 1e3L, options);
        ASSERT_EQ(trajectory.events.size(), 1U);
        EXPECT_EQ(trajectory.events[0].before, regime);
        EXPECT_NEAR(static_cast<double>(trajectory.events[0].time * omega / std::acos(phase)), 1.0, tolerance)
            << name_of(model) << " from phase " << static_cast<double>(phase);
      };
      check(1e-8L, -1, 2e-9);
      if (regime == Regime::deflating) continue;
      for (Real phase = -0.99L; phase < 0.99L; phase += 0.01L) check(1e-10L, phase, 3e-9);
    }
  }
}

// --- time stepping
// ----------------------------------------------------------------------------------------------------

std::uint64_t random_seed() {
  if (const char* given = std::getenv("TURGOR_TEST_SEED")) return std::strtoull(given, nullptr, 10);
  return std::random_device{}();
}

/// Random numbers of long double from doubles, so that both precisions can be given the same balloon.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  double log_between(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }

 private:
  std::mt19937_64 random_;
};

Material<long double> random_material(std::size_t kind, Draw& draw) {
  using Real = long double;
  const Real mu = draw.log_between(1e5, 3e6);
  const auto share = [&](double a, double b) { return mu * static_cast<Real>(draw.between(a, b)); };
  switch (kind) {
    case 0: return MooneyRivlin<Real>{mu, share(0.02, 0.4)};
    case 1: return NeoHookean<Real>{mu};
    case 2: return Yeoh<Real>{mu, share(-0.01, 0.01), share(0, 0.001)};
    case 3: return Gent<Real>{mu, draw.between(5, 100)};
    case 4: return GentGent<Real>{mu, draw.between(5, 100), share(0, 0.3)};
    case 5: return Ogden<Real>{{mu, mu * 1e-3L, -mu * 0.02L}, {1.3L, 5.0L, -2.0L}};
    case 6: return Fung<Real>{mu, draw.between(0.01, 1)};
    default: return ArrudaBoyce<Real>{mu, draw.between(2, 6)};
  }
}

/// A balloon, a program of four pressures and a start, on the clock of its own small oscillations.
struct RandomCase {
  Oscillator<long double> oscillator;
  long double stretch;
  long double rate;
  long double end;
};

RandomCase random_case(Model model, std::size_t material, Draw& draw) {
  using Real = long double;
  Parameters<Real> p{};
  p.radius = draw.log_between(0.01, 1);
  p.thickness = p.radius * static_cast<Real>(draw.log_between(1e-3, 3e-2));
  p.solid_density = draw.between(500, 3000);
  p.fluid_density = draw.between(500, 3000);
  p.fluid_viscosity = 1e-3L;
  p.orifice_radius = p.radius * static_cast<Real>(draw.log_between(1.0 / 40, 1.0 / 5));
  p.channel_length = model == Model::orifice ? 0 : p.orifice_radius * static_cast<Real>(draw.log_between(0.3, 30));
  constexpr std::array closures{Closure::theoretical, Closure::corrected, Closure::potential};
  p.closure = closures.at(static_cast<std::size_t>(draw.between(0, 3)));
  p.material = random_material(material, draw);
  const Real stiffness = p.thickness * strain_energy(p.material, Real(1)).second / p.radius;
  Scales<Real> scales{p.radius, stiffness, 1};
  const auto g = groups(p, scales);
  scales.time = std::sqrt((g.a0 + g.b + g.m) / g.K);
  const Real end = 40;
  SegmentList<Real> program(stiffness * static_cast<Real>(draw.between(-0.02, 0.08)));
  for (int i = 0; i < 3; ++i) {
    program.hold(end * scales.time * static_cast<Real>(draw.between(0.05, 0.3)));
    program.step(stiffness * static_cast<Real>(draw.between(-0.02, 0.08)));
  }
  const double most = std::min(1.6, 0.9 * static_cast<double>(stretch_limit(p.material)));
  const double rate = draw.between(0, 1) < 0.5 ? 0.0 : draw.between(-0.05, 0.05);
  return {Oscillator<Real>(model, p, program.build(), scales), draw.between(1.0, most), rate, end};
}

// All models and materials, several pressures, starts with and without a rate. At rtol 1e-15 the stepped solution's
// global error is of the order of 1e-13 in R; divided by small amplitudes it is the error of event times: 1e-11 as a
// rule, up to 1e-10 in one of thousands of balloons.
TEST(Quadrature, AgreesWithTimeSteppingForRandomBalloons) {
  const std::uint64_t seed = random_seed();
  std::cout << "TURGOR_TEST_SEED=" << seed << "\n";
  Draw draw(seed);
  std::size_t events = 0;
  long double largest = 0;
  for (std::size_t i = 0; i < 96; ++i) {
    const RandomCase c = random_case(all_models[i % 3], i / 3 % 8, draw);
    auto options = at_tolerance<long double>(1e-15L);
    options.max_events = 10;
    const auto stepped = simulate<long double>(c.oscillator, 0, c.stretch, c.rate, c.end, options);
    const auto exact = simulate_by_quadrature<long double>(c.oscillator, 0, c.stretch, c.rate, c.end, options);
    const std::string where = "balloon " + std::to_string(i) + " of seed " + std::to_string(seed);
    ASSERT_EQ(exact.outcome, stepped.outcome) << where << exact.message << stepped.message;
    ASSERT_EQ(exact.events.size(), stepped.events.size()) << where;
    const auto compare = [&](long double found, long double expected, const char* what) {
      largest = std::max(largest, std::abs(found - expected));
      EXPECT_NEAR(static_cast<double>(found - expected), 0, 1e-9) << what << " of " << where;
    };
    for (std::size_t k = 0; k < exact.events.size(); ++k) {
      EXPECT_EQ(exact.events[k].after, stepped.events[k].after) << where;
      compare(exact.events[k].stretch, stepped.events[k].stretch, "R at an event");
      compare(exact.events[k].time, stepped.events[k].time, "time of an event");
    }
    for (int k = 0; k <= 20; ++k) {
      const long double t = std::min(exact.last.time, stepped.last.time) * k / 20;
      compare(exact.at(t).stretch, stepped.at(t).stretch, "R");
    }
    events += exact.events.size();
  }
  EXPECT_GT(events, 100U);
  RecordProperty("largest_difference", std::to_string(static_cast<double>(largest)));
  std::cout << "largest difference " << static_cast<double>(largest) << " over " << events << " events\n";
}

// The same quadrature in double and in long double: times to 1e-13 of the run, R to rounding.
TEST(Quadrature, IsGoodToRoundingInDouble) {
  for (const Model model : all_models) {
    const auto options = at_tolerance(1e-9);
    const auto program = [](auto zero) {
      using T = decltype(zero);
      return SegmentList<T>(T(36000)).hold(T(1)).step(T(41000)).hold(T(2)).step(T(20000)).build();
    };
    const auto in_double = simulate_by_quadrature(paper_oscillator(model, program(0.0)), 0.0, 1.25, 0.0, 4.0, options);
    const auto exact = simulate_by_quadrature<long double>(paper_oscillator<long double>(model, program(0.0L)), 0,
                                                           1.25L, 0, 4, at_tolerance(1e-14L));
    ASSERT_EQ(in_double.events.size(), exact.events.size());
    for (std::size_t i = 0; i < exact.events.size(); ++i) {
      EXPECT_NEAR(in_double.events[i].time, static_cast<double>(exact.events[i].time), 4e-13) << name_of(model);
      EXPECT_NEAR(in_double.events[i].stretch, static_cast<double>(exact.events[i].stretch), 1e-13) << name_of(model);
    }
    EXPECT_NEAR(in_double.last.stretch, static_cast<double>(exact.last.stretch), 1e-13) << name_of(model);
  }
}

// Between nodes the dense output is within a tenth of the tolerances, here of a run a thousand times tighter.
TEST(Quadrature, DenseOutputKeepsTheTolerance) {
  for (const Model model : all_models) {
    for (const double tolerance : {1e-10, 1e-12}) {
      const auto oscillator = paper_oscillator(model, constant_pressure(41e3));
      const auto trajectory = simulate_by_quadrature(oscillator, 0.0, 1.0, 0.0, 1.0, at_tolerance(tolerance));
      const auto exact = simulate_by_quadrature<long double>(
          paper_oscillator<long double>(model, constant_pressure(41e3L)), 0, 1, 0, 1, at_tolerance(1e-16L));
      for (int i = 0; i <= 2000; ++i) {
        const double t = i / 2000.0;
        const Point<double> found = trajectory.at(t);
        const Point<long double> expected = exact.at(static_cast<long double>(t));
        // The middle, where the error is controlled, is no exact maximum of it: a factor of 1.5.
        EXPECT_NEAR(found.stretch, static_cast<double>(expected.stretch), 0.15 * tolerance * (1 + found.stretch));
        const double rate = static_cast<double>(expected.rate);
        EXPECT_NEAR(found.rate, rate, 0.15 * tolerance * (1 + 10 * std::abs(rate))) << name_of(model) << " at " << t;
      }
    }
  }
}

// --- edges
// ------------------------------------------------------------------------------------------------------------

TEST(Quadrature, TakesOnlyPiecewiseConstantPressure) {
  const auto run = [](const PressureProgram<double>& program, double end) {
    return simulate_by_quadrature(paper_oscillator(Model::orifice, program), 0.0, 1.2, 0.0, end, {});
  };
  const auto ramped = SegmentList<double>(20e3).hold(1).ramp(30e3, 2, RampShape::linear).hold(1).build();
  EXPECT_EQ(run(ramped, 1.0).outcome, Outcome::reached_end);  // ends before the ramp
  try {
    (void)run(ramped, 1.5);
    FAIL() << "a ramp was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().key, "solve.method");
    EXPECT_NE(std::string(error.what()).find("from 1 s to 1.5 s (piece 2"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)run(harmonic_pressure(HarmonicPressure<double>{20e3, 1, 1, 0}), 1), InvalidInput);
  EXPECT_EQ(run(harmonic_pressure(HarmonicPressure<double>{20e3, 0, 1, 0}), 1).outcome, Outcome::reached_end);
  EXPECT_THROW((void)run(constant_pressure(20e3), 0.0), InvalidInput);
  EXPECT_THROW(
      (void)simulate_by_quadrature(paper_oscillator(Model::orifice, constant_pressure(0.0)), 0.0, -1.0, 0.0, 1.0, {}),
      InvalidInput);
}

class StartsAndStops : public testing::TestWithParam<Model> {
 protected:
  using Real = long double;
  const Oscillator<Real> steady_ = paper_oscillator<Real>(GetParam(), constant_pressure(20e3L));
  SimulationOptions<Real> options_;
};

TEST_P(StartsAndStops, AtTheEndTime) {
  for (const Real end : {1e-12L, 1e-3L, 0.01L, 0.1L, 1.0L}) {
    expect_same(steady_, 1, 0, end, options_, Outcome::reached_end);
  }
  expect_same(steady_, 1.2L, 0, 3, options_, Outcome::reached_end);
}

TEST_P(StartsAndStops, WithARate) {
  for (const Real rate : {0.3L, -0.3L, 1e-9L, -1e-9L, 1e-14L}) {
    expect_same(steady_, 1.3L, rate, 3, options_, Outcome::reached_end);
  }
}

// In mid-swing, at rest, one soon after another, and one that changes nothing.
TEST_P(StartsAndStops, AtKnots) {
  SegmentList<Real> program(0);
  program.hold(0.5L).step(30e3L).hold(0.003L).step(41e3L).hold(0.2L).step(41e3L).hold(0.4L).step(-5e3L).hold(0.3L);
  expect_same(paper_oscillator<Real>(GetParam(), program.step(25e3L).build()), 1, 0, 2, options_, Outcome::reached_end);
}

TEST_P(StartsAndStops, AfterEvents) {
  options_.max_events = 3;
  expect_same(steady_, 1.1L, 0, 1e3L, options_, Outcome::max_events);
}

TEST_P(StartsAndStops, AtTheBurstStretch) {
  options_.max_stretch = 1.6L;
  expect_same(paper_oscillator<Real>(GetParam(), constant_pressure(60e3L)), 1, 0, 50, options_, Outcome::burst);
  const auto stepped = SegmentList<Real>(60e3L).hold(1e-3L).step(50e3L).build();
  expect_same(paper_oscillator<Real>(GetParam(), stepped), 1, 0, 50, options_, Outcome::burst);
}

TEST_P(StartsAndStops, NearRest) {
  options_.rest_tol = 1e-3L;
  expect_same(steady_, 1, 0, 1e4L, options_, Outcome::at_rest);
}

TEST_P(StartsAndStops, WhenInterrupted) {
  options_.keep_going = [](const Real& time) { return time < 0.01L; };
  expect_same(steady_, 1, 0, 0.011L, options_, Outcome::interrupted);
  options_.keep_going = {};
  options_.max_steps = 3;
  EXPECT_EQ(simulate_by_quadrature<Real>(steady_, 0, 1, 0, 100, options_).outcome, Outcome::max_steps);
}

INSTANTIATE_TEST_SUITE_P(Models, StartsAndStops, testing::ValuesIn(all_models), [](const auto& test) {
  return test.param == Model::full ? "Full" : test.param == Model::orifice ? "Orifice" : "LongChannel";
});

TEST(Quadrature, FollowsABalloonThatRunsAway) {
  auto p = paper_balloon<long double>(0.03L, 0.5L);
  p.material = NeoHookean<long double>{1e6L};
  expect_same(Oscillator<long double>(Model::full, p, constant_pressure(1e5L), si_scales(p)), 1, 0, 1e5L, {},
              Outcome::runaway);
}

// Pushed hard against the stretch at which it locks, where the tension becomes infinite.
TEST(Quadrature, TurnsBeforeTheMaterialLocks) {
  const Gent<long double> gent{3e5L, 20};
  auto p = paper_balloon<long double>(0.03L, 0.5L);
  p.material = gent;
  const Oscillator<long double> oscillator(Model::full, p, constant_pressure(60e3L), si_scales(p));
  SimulationOptions<long double> options;
  options.max_events = 1;
  expect_same(oscillator, 1, 0, 60, options, Outcome::max_events);
  const auto trajectory = simulate_by_quadrature<long double>(oscillator, 0, 1, 0, 60, options);
  EXPECT_GT(trajectory.last.stretch, 0.98L * gent.stretch_limit());
}

TEST(Quadrature, ReachesTheBurstStretchExactly) {
  SimulationOptions<double> options;
  options.max_stretch = 2.5;
  const auto trajectory =
      simulate_by_quadrature(paper_oscillator(Model::orifice, constant_pressure(60e3)), 0.0, 1.0, 0.0, 10.0, options);
  EXPECT_EQ(trajectory.outcome, Outcome::burst);
  EXPECT_EQ(trajectory.last.stretch, 2.5);
  EXPECT_NEAR(trajectory.steps.back().stretch_at(1), 2.5, 1e-14);
}

TEST(Quadrature, RestsInEquilibriumUntilThePressureJumps) {
  const auto program = SegmentList<double>(0).hold(3).step(0).hold(1).step(20e3).build();
  const auto trajectory = simulate_by_quadrature(paper_oscillator(Model::full, program), 0.0, 1.0, 0.0, 4.2, {});
  EXPECT_EQ(trajectory.at(3.9).stretch, 1.0);
  EXPECT_EQ(trajectory.at(3.9).regime, Regime::rest);
  ASSERT_EQ(trajectory.events.size(), 1U);
  EXPECT_EQ(trajectory.events[0].time, 4.0);
  EXPECT_EQ(trajectory.events[0].before, Regime::rest);
  EXPECT_EQ(trajectory.events[0].after, Regime::inflating);
}

TEST(Quadrature, TheRateIsExactlyZeroAtEvents) {
  const auto trajectory =
      simulate_by_quadrature(paper_oscillator(Model::full, constant_pressure(41e3)), 0.0, 1.35, 0.0, 200.0, {});
  ASSERT_GT(trajectory.events.size(), 5U);
  for (std::size_t i = 0; i < trajectory.events.size(); ++i) {
    EXPECT_EQ(trajectory.events[i].before, i % 2 == 0 ? Regime::deflating : Regime::inflating);
    const auto& next = trajectory.step_at(trajectory.events[i].time);
    EXPECT_EQ(next.start, trajectory.events[i].time);
    EXPECT_EQ(next.rate_at(0), 0.0);
    EXPECT_EQ(next.stretch_at(0), trajectory.events[i].stretch);
  }
}

// A run cut anywhere goes on as if it had not been: also right after and right before a turning point.
TEST(Quadrature, CanBeResumedAnywhere) {
  const auto oscillator = paper_oscillator(Model::long_channel, constant_pressure(41e3));
  auto options = at_tolerance(1e-10);
  options.max_events = 4;
  const auto whole = simulate_by_quadrature(oscillator, 0.0, 1.35, 0.0, 1e3, options);
  const double event = whole.events[1].time;
  for (const double cut : {1e-9, 0.3, event / 2, event - 1.0, event - 1e-6, event + 1e-6, event}) {
    const auto first = simulate_by_quadrature(oscillator, 0.0, 1.35, 0.0, cut, options);
    ASSERT_EQ(first.last.time, cut);
    const auto rest = simulate_by_quadrature(oscillator, cut, first.last.stretch, first.last.rate, 1e3, options);
    const auto& last = whole.events[3];
    const auto again = std::min_element(rest.events.begin(), rest.events.end(), [&](const auto& x, const auto& y) {
      return std::abs(x.time - last.time) < std::abs(y.time - last.time);
    });
    ASSERT_NE(again, rest.events.end()) << "cut at " << cut;
    EXPECT_NEAR(again->time, last.time, 1e-12 * last.time) << "cut at " << cut;
    EXPECT_NEAR(again->stretch, last.stretch, 1e-13) << "cut at " << cut;
  }
}

// On the slow manifold of the narrowest orifice that the closure allows, |lambda| is 1858/s and the run lasts two days.
// Inertia only matters to the relative order M/(Q R) there: v^2 = (E - R^2 P)/Q.
TEST(Quadrature, StaysOnTheSlowManifold) {
  const double P = 30e3;
  const auto oscillator = paper_oscillator(Model::orifice, constant_pressure(P), 0.3 / 200);
  const auto trajectory = simulate_by_quadrature(oscillator, 0.0, 5.0, 0.0, 2e5, at_tolerance(1e-10));
  ASSERT_EQ(trajectory.outcome, Outcome::reached_end) << trajectory.message;
  EXPECT_LT(trajectory.last.stretch, 4.9);
  EXPECT_LT(trajectory.statistics.steps, 200);
  const double R = trajectory.last.stretch;
  const auto c = oscillator.coefficients(Regime::deflating, R);
  const double quasi_static = -std::sqrt(-oscillator.force_at_rest(R, P) / c.centripetal);
  EXPECT_NEAR(trajectory.last.rate / quasi_static, 1, 10 * c.mass / (c.centripetal * R));
  EXPECT_NE(trajectory.last.rate, quasi_static);
}

/// A balloon given in double as long double, digit for digit.
Parameters<long double> widened(const Parameters<double>& p) {
  const auto& material = std::get<MooneyRivlin<double>>(p.material);
  return {p.radius,          p.thickness,      p.solid_density,  p.fluid_density,
          p.fluid_viscosity, p.orifice_radius, p.channel_length, MooneyRivlin<long double>{material.s1, material.s2},
          p.closure};
}

// An amplitude of 1e-6 leaves 1e-10 of the period to the rounding of R, and some 1e-11 (that of a P - E, 1e-17 to 3e-17
// over the amplitude) when R carries its rest along. The
// panel that runs into the upper turning point must not be taken from its lower end: that costs 1e-8 unnoticed in its
// middle.
TEST(Quadrature, KeepsDigitsOfSmallMotion) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const double pressure = 41313.600802474764;
  const auto scales = natural_scales(p, constant_pressure(pressure), 30.0);
  const Oscillator<double> in_double(Model::full, p, constant_pressure(pressure), scales);
  const Oscillator<long double> exact(Model::full, widened(p), constant_pressure<long double>(pressure),
                                      {scales.length, scales.pressure, scales.time});
  for (const double amplitude : {1e-3, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6}) {
    const double start = 1.2582010333829832 + amplitude;
    const auto found = simulate_by_quadrature(in_double, 0.0, start, 0.0, 60.0, at_tolerance(1e-12));
    const auto expected = simulate_by_quadrature<long double>(exact, 0, start, 0, 60, at_tolerance(1e-15L));
    ASSERT_EQ(found.events.size(), expected.events.size());
    ASSERT_GE(found.events.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(found.events[i].time / static_cast<double>(expected.events[i].time), 1.0, 3e-17 / amplitude + 2e-12)
          << "event " << i << " at amplitude " << amplitude;
    }
  }
}

// A rate that turns on a way below the last digit of R, late enough that the clock does not resolve its halves.
TEST(Quadrature, TurnsWithinTheLastDigit) {
  for (const Model model : all_models) {
    const auto oscillator = paper_oscillator(model, constant_pressure(20e3));
    for (const double rate : {1e-9, 1e-12}) {
      const auto trajectory = simulate_by_quadrature(oscillator, 1e3, 1.3, rate, 1e3 + 1, at_tolerance(1e-10));
      const auto from_rest = simulate_by_quadrature(oscillator, 1e3, 1.3, 0.0, 1e3 + 1, at_tolerance(1e-10));
      ASSERT_EQ(trajectory.outcome, Outcome::reached_end) << trajectory.message;
      ASSERT_EQ(trajectory.events.size(), 1U);
      EXPECT_EQ(trajectory.events[0].after, Regime::deflating);
      EXPECT_NEAR(trajectory.last.stretch, from_rest.last.stretch, 1e-8);
      EXPECT_LT(trajectory.statistics.steps, from_rest.statistics.steps + 10);
    }
  }
}

// Amplitudes down to what double resolves: runs end, and say how.
TEST(Quadrature, TinyAmplitudesEndOneWayOrAnother) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const double R = equilibria(p, 20e3).front().stretch;
  for (const Model model : all_models) {
    const auto oscillator = paper_oscillator(model, constant_pressure(20e3));
    for (double amplitude = 1e-6; amplitude > 1e-17; amplitude /= 10) {
      const auto trajectory = simulate_by_quadrature(oscillator, 0.0, R + amplitude, 0.0, 5.0, {});
      EXPECT_TRUE(trajectory.outcome == Outcome::reached_end || trajectory.outcome == Outcome::step_failed);
      EXPECT_TRUE(amplitude < 1e-11 || trajectory.outcome == Outcome::reached_end) << trajectory.message;
      EXPECT_NEAR(trajectory.last.stretch, R, 2 * amplitude + 1e-15);
      EXPECT_LT(trajectory.statistics.steps, 100000);
    }
  }
}

}  // namespace
}  // namespace turgor
