#include "turgor/run/force_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "turgor/oscillator/oscillator.hpp"

namespace turgor {
namespace {

constexpr std::size_t theoretical = 0;
constexpr std::size_t corrected = 1;

Case motion_case(const std::vector<std::string>& overrides = {}, const std::string& name = "motion-orifice-30mm") {
  return read_case(std::filesystem::path(TURGOR_CASES) / (name + ".toml"), overrides);
}

ClosureForces forces(const Case& c, double t) { return forces_at(c, compared_closures(c), t, c.motion->at(t)); }

/// (2.12) and (2.15) as the paper writes them, for the 3 cm orifice without a channel.
double papers_force(bool is_corrected, double r, double rate, double acceleration) {
  const double off = 1 - (rate < 0 ? -1 : 1);
  const double inertial = (is_corrected ? 223.0 / 32 : 9 / std::sqrt(2.0)) * off;
  const double centripetal = (is_corrected ? 75.0 / 32 : 3.0 / 2) * off;
  const double r_ch = 0.03;
  return -4 * 1000 / r_ch * inertial * std::pow(r, 4) * acceleration +
         32 * 1000 / (r_ch * r_ch) * centripetal * std::pow(r, 3) / (r_ch * r_ch) * std::pow(r, 3) * rate * rate;
}

// Where the motion is known by hand; 1e-12 for the ulps of r in r^6.
TEST(ForceHistory, IsThePapersForce) {
  const Case c = motion_case();
  // At 3.5 s it deflates evenly, half of the 3 cm left. At 4.25 s it is halfway through the last ramp: half of 2 cm/s,
  // 30/16 of the mean acceleration, and the integral of S to 1/2 left, (1/16)(5/2 - 3/2 + 1/4) = 5/64 of a whole.
  const double left = 0.02 * 0.5 * 5 / 64;
  for (const bool is_corrected : {false, true}) {
    const double even = papers_force(is_corrected, 0.315, -0.02, 0);
    const double slowing = papers_force(is_corrected, 0.3 + left, -0.01, 30.0 / 16 * 0.02 / 0.5);
    EXPECT_NEAR(forces(c, 3.5).all[is_corrected ? corrected : theoretical], even, 1e-12 * even);
    EXPECT_NEAR(forces(c, 4.25).all[is_corrected ? corrected : theoretical], slowing, 1e-12 * even);
  }
}

TEST(ForceHistory, PartsSumToTheForceOfTheCasesClosure) {
  for (const std::string name : {"theoretical", "corrected"}) {
    const Case c = motion_case({"model.closure=" + name, "motion.inlet_pressure=3 kPa"}, "motion-channel-20mm");
    for (double t = 0; t < c.solve.t_end; t += c.solve.t_end / 101) {
      const ClosureForces at = forces(c, t);
      EXPECT_EQ(at.parts.sum(), at.all[name == "corrected" ? corrected : theoretical]);
    }
  }
}

// A jet into a bare orifice leaves the pressure uniform, section 2.2.
TEST(ForceHistory, InflationWithoutAChannelHasNoForce) {
  const Case c = motion_case();
  for (double t = 0; t < 2.5; t += 0.01) {
    for (const double force : forces(c, t).all) EXPECT_EQ(force, 0) << t;
  }
  for (const ForceSummary& of : force_history(c).closures) EXPECT_EQ(of.inflating->force, 0);
}

TEST(ForceHistory, AtRestOnlyThePressureRemains) {
  const Case c = motion_case({"motion.inlet_pressure=3 kPa"}, "motion-channel-30mm");
  const double pi = std::numbers::pi;
  for (const auto& [time, r] : {std::pair{2.2, 0.33}, {4.7, 0.3}}) {
    const auto all = forces(c, time).all;
    EXPECT_NEAR(all.at(theoretical), 4 * pi * r * r * 3000, 1e-9);
    EXPECT_NEAR(all.at(corrected), 4 * pi * r * r * 3000, 1e-9);
    EXPECT_NEAR(all.at(2), 2 * pi * r * (r + std::sqrt(r * r - 0.03 * 0.03)) * 3000, 1e-9);  // g1 r^2 p
  }
  const Case still = motion_case({"motion.velocity=[{ hold = \"2 s\" }]"});
  for (const ForceSummary& of : force_history(still).closures) {
    EXPECT_EQ(of.peak.force, 0);
    EXPECT_FALSE(of.inflating);
    EXPECT_FALSE(of.deflating);
  }
}

// The same motion over half the orifice: inertia 2 times, centripetal force 16 times that of the liquid in the balloon;
// both terms of the channel 4 times.
TEST(ForceHistory, ScalesWithTheOrifice) {
  const Case wide = motion_case({}, "motion-channel-30mm");
  const Case narrow = motion_case({"inlet.orifice_radius=1.5 cm"}, "motion-channel-30mm");
  for (const double t : {0.2, 1.0, 1.8, 2.7, 3.4, 4.3}) {
    const ForceParts<double> a = forces(wide, t).parts;
    const ForceParts<double> b = forces(narrow, t).parts;
    EXPECT_DOUBLE_EQ(b.balloon_inertial, 2 * a.balloon_inertial);
    EXPECT_DOUBLE_EQ(b.balloon_centripetal, 16 * a.balloon_centripetal);
    EXPECT_DOUBLE_EQ(b.channel_inertial, 4 * a.channel_inertial);
    EXPECT_DOUBLE_EQ(b.channel_centripetal, 4 * a.channel_centripetal);
  }
}

// The shipped motions run backwards the way they ran forwards, about the middle of their rest. The channel's terms are
// even in time; 1e-12 is the rounding of 4.5 s - t, which the steep ramps amplify.
TEST(ForceHistory, TheChannelDoesNotKnowTheDirectionOfTime) {
  const Case c = motion_case({}, "motion-channel-30mm");
  for (const double t : {0.2, 1.0, 1.8}) {
    const ForceParts<double> up = forces(c, t).parts;
    const ForceParts<double> down = forces(c, 4.5 - t).parts;
    EXPECT_NEAR(up.channel_inertial, down.channel_inertial, 1e-12 * 3e4);
    EXPECT_NEAR(up.channel_centripetal, down.channel_centripetal, 1e-12 * 3e4);
    EXPECT_EQ(up.balloon_centripetal, 0);
    EXPECT_GT(down.balloon_centripetal, 0);
  }
}

// Half the speed along the same way: a quarter of the forces and of the work, half of the impulse.
TEST(ForceHistory, ScalesWithTheSpeed) {
  const auto way = [](const std::string& speed, const std::string& time) {
    return "motion.velocity=[{ to = \"" + speed + " cm/s\", over = \"" + time +
           " s\", shape = \"smooth\" }, { to = \"-" + speed + " cm/s\", over = \"" + time +
           " s\", shape = \"smooth\" }]";
  };
  const ForceHistory fast = force_history(motion_case({way("2", "1")}, "motion-channel-30mm"));
  const ForceHistory slow = force_history(motion_case({way("1", "2")}, "motion-channel-30mm"));
  for (std::size_t i = 0; i < fast.closures.size(); ++i) {
    const double peak = fast.closures[i].peak.force;
    EXPECT_NEAR(slow.closures[i].peak.force, peak / 4, 1e-12 * std::abs(peak));
    EXPECT_NEAR(slow.closures[i].work, fast.closures[i].work / 4, 1e-12 * std::abs(fast.closures[i].work));
    EXPECT_NEAR(slow.closures[i].impulse, fast.closures[i].impulse / 2, 1e-12 * std::abs(fast.closures[i].impulse));
  }
}

// What the wall puts into the liquid on a closed way leaves with the jet. The oscillator has that loss as the term
// (M_'/2 + Q_) v^3 of its energy balance. The integrand vanishes with the velocity at both ends, so that the
// trapezoidal sum is good to 1e-9.
TEST(ForceHistory, WorkOnAClosedWayIsWhatTheOscillatorDissipates) {
  for (const std::string name : {"motion-orifice-30mm", "motion-channel-20mm"}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Case c = motion_case({"model.closure=" + std::string(name_of(all_closures.at(i)))}, name);
      const Scales<double> si{c.parameters.radius, 1, 1};
      const Oscillator<double> oscillator(Model::full, c.parameters, c.pressure, si);
      constexpr int n = 20000;
      double loss = 0;
      for (int k = 0; k < n; ++k) {
        const auto state = c.motion->at(c.solve.t_end * k / n);
        if (state.regime == Regime::rest) continue;
        const auto numbers = oscillator.coefficients(state.regime, state.radius / si.length);
        const double v = state.rate / si.length;
        loss += (numbers.mass_slope / 2 + numbers.centripetal) * v * v * v * c.solve.t_end / n;
      }
      EXPECT_LT(loss, 0);
      EXPECT_NEAR(force_history(c).closures[i].work, loss * si.energy(), -1e-9 * loss * si.energy()) << name;
    }
  }
}

// Against the rows of the table: no row exceeds the peak, and one of 40001 comes as close as the curvature says.
TEST(ForceHistory, PeaksAndImpulseAreThoseOfTheMotion) {
  for (const std::string name : {"motion-orifice-20mm", "motion-channel-30mm", "motion-channel-5mm"}) {
    const Case c = motion_case({}, name);
    const ForceHistory history = force_history(c);
    for (std::size_t i = 0; i < history.closures.size(); ++i) {
      constexpr int n = 40000;
      double greatest = 0;
      double impulse = 0;
      for (int k = 0; k <= n; ++k) {
        const double force = forces(c, c.solve.t_end * k / n).all.at(i);
        greatest = std::max(greatest, std::abs(force));
        impulse += force * c.solve.t_end / n;  // zero at both ends
      }
      const ForceSummary& of = history.closures[i];
      EXPECT_GE(std::abs(of.peak.force), greatest * (1 - 1e-15));
      EXPECT_NEAR(std::abs(of.peak.force), greatest, 1e-6 * greatest);
      EXPECT_EQ(of.deflating->force, of.peak.force);
      EXPECT_EQ(forces(c, of.peak.time).all.at(i), of.peak.force);
      EXPECT_NEAR(of.impulse, impulse, 1e-7 * greatest * c.solve.t_end);
    }
  }
}

// At a turn with an acceleration the force jumps: the peak of inflation is the one before the turn.
TEST(ForceHistory, PeaksStandOnTheirSideOfATurn) {
  const Case c = motion_case(
      {"motion.start=2 cm/s", "motion.velocity=[{ to = \"-2 cm/s\", over = \"1 s\" }]", "inlet.channel_length=10 cm"});
  const ForceSummary of = force_history(c).closures[corrected];
  EXPECT_NEAR(of.inflating->time, 0.5, 1e-12);
  const FlowState<double> turn{0.305, 0, -0.04, 0, 0.03, 0.1, 1000};
  EXPECT_NEAR(of.inflating->force, generalized_force(Closure::corrected, Regime::inflating, turn), 1e-9);
  EXPECT_NEAR(forces(c, 0.5).all[corrected], generalized_force(Closure::corrected, Regime::deflating, turn), 1e-9);
}

TEST(ForceHistory, WarnsOutsideTheFits) {
  EXPECT_TRUE(force_history(motion_case()).warnings.empty());
  const auto warnings = force_history(motion_case({"inlet.orifice_radius=6 cm"})).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].name, "orifice-large");
}

}  // namespace
}  // namespace turgor
