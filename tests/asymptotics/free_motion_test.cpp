// What all local approximations rest on: the force about an equilibrium, the two clocks, beta.

#include "turgor/asymptotics/free_motion.hpp"

#include <gtest/gtest.h>

#include "../support/reference.hpp"
#include "motions.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::middle_pressure;

double well(const test::ReferenceValue& entry) {
  return entry.text("R_eq") == "small" ? test::small_equilibrium_stretch : test::large_equilibrium_stretch;
}

// Differences of the next lower derivative; O(h^2) for h = 1e-4 R, and 1e-5 for F''' which is one itself.
TEST(RestoringForce, DerivativesAreThoseOfEveryMaterial) {
  auto p = test::paper_balloon<double>(0.03, 0.0);
  const std::vector<Material<double>> materials{MooneyRivlin<double>{1.5e6, 1.5e5},
                                                NeoHookean<double>{4e5},
                                                Gent<double>{4e5, 97.2},
                                                Fung<double>{5e4, 0.8},
                                                Ogden<double>{{6.3e5, 1.2e3, -1e4}, {1.3, 5.0, -2.0}},
                                                ArrudaBoyce<double>{3e5, 5.0},
                                                GentGent<double>{3e5, 77.9, 1.5e5},
                                                Yeoh<double>{2e5, -1.2e3, 40}};
  for (const Material<double>& material : materials) {
    p.material = material;
    const Oscillator<double> oscillator(Model::orifice, p, constant_pressure(0.0), {p.radius, 6000, 1});
    const RestoringForce force(oscillator, 2.5);
    for (const double R : {0.9, 1.0, 1.3, 3.0}) {
      const double h = 1e-4 * R;
      const Jet<double> F = force.at(R);
      const double size = std::abs(F.first) + std::abs(F.second) + std::abs(force.third(R));
      EXPECT_NEAR(F.value, -oscillator.force_at_rest(R, 2.5), 1e-14 * size);
      EXPECT_NEAR(F.first, (force.at(R + h).value - force.at(R - h).value) / (2 * h), 1e-7 * size);
      EXPECT_NEAR(F.second, (force.at(R + h).first - force.at(R - h).first) / (2 * h), 1e-6 * size);
      EXPECT_NEAR(force.third(R), (force.at(R + h).first - 2 * F.first + force.at(R - h).first) / (h * h), 1e-5 * size);
    }
  }
}

TEST(FreeMotion, ClocksReproduceTheReferenceValues) {
  for (const char* name : {"C1_3.6a", "C3_3.6b"}) {
    for (const auto& entry : test::reference().at(name)) {
      const TimeScales times =
          FreeMotion(test::orifice_balloon(1.0, 1000.0), middle_pressure, well(entry)).time_scales();
      // the slope of F is a difference of terms of order 100 S2
      EXPECT_NEAR(std::string(name) == "C1_3.6a" ? times.C1 : times.C3, entry.value, 1e-13 * entry.value * entry.value);
    }
  }
  for (const char* name : {"t_typ_deflation_nochannel[s]", "t_typ_inflation_nochannel[s]", "t_typ_channel[s]"}) {
    for (const auto& entry : test::reference().at(name)) {
      const bool channel = entry.has("L_ch");
      const auto p = test::paper_balloon(entry.input("r_ch"), channel ? entry.input("L_ch") : 0.0);
      const Model model = channel ? Model::long_channel : Model::orifice;
      const Oscillator<double> oscillator(model, p, constant_pressure(0.0), test::si_scales(p));
      const TimeScales times = FreeMotion(oscillator, 6000 * middle_pressure, well(entry)).time_scales();
      const bool inflation = std::string(name) == "t_typ_inflation_nochannel[s]";
      EXPECT_NEAR(inflation ? times.inflation : times.deflation, entry.value, 1e-12 * entry.value) << entry.inputs;
      EXPECT_EQ(channel, times.inflation == times.deflation);  // (3.7): one clock for both
    }
  }
}

// On deflation's clock C1 is (3.6a), but C3 then is not (3.6b): one T cannot be both.
TEST(FreeMotion, NoClockSatisfiesBothRegimes) {
  auto oscillator = test::orifice_balloon(1.0, 1000.0);
  const TimeScales times = FreeMotion(oscillator, middle_pressure, 4.8).time_scales();
  const Oscillator<double> again(Model::orifice, oscillator.parameters(), constant_pressure(0.0),
                                 {0.3, oscillator.scales().pressure, times.deflation});
  const Groups<double>& g = again.dimensionless_groups();
  EXPECT_NEAR(g.C1, times.C1, 1e-13 * times.C1);
  const double ratio = times.deflation / times.inflation;
  EXPECT_NEAR(g.C3, times.C3 * ratio * ratio, 1e-10 * g.C3);
  EXPECT_GT(ratio, 100);
}

TEST(FreeMotion, BetaReproducesTheReferenceValues) {
  for (const char* name : {"beta=C2Req^2+2/Req", "universal undershoot 1/(2beta)"}) {
    for (const auto& entry : test::reference().at(name)) {
      const std::string which = entry.text("case");
      const bool channel = which.starts_with("(2.25)");
      const auto p = test::paper_balloon(entry.input("r_ch"), channel ? 0.5 : 0.0);
      const Oscillator<double> oscillator(channel ? Model::long_channel : Model::orifice, p, constant_pressure(0.0),
                                          test::si_scales(p));
      const double R = which.ends_with("small") ? test::small_equilibrium_stretch : test::large_equilibrium_stretch;
      const double beta = FreeMotion(oscillator, 6000 * middle_pressure, R).beta();
      const double found = std::string(name).starts_with("beta") ? beta : 1 / (2 * beta);
      EXPECT_NEAR(found, entry.value, 1e-13 * entry.value) << entry.inputs;
    }
  }
}

// M_-'/2 + Q_- over M_-, from the table of theory.md in section 2.4 on the energy balance.
TEST(FreeMotion, BetaOfTheFullModelIsTheDampingOfItsEnergy) {
  const auto p = test::paper_balloon(0.03, 0.05);
  const Oscillator<double> oscillator(Model::full, p, constant_pressure(0.0), test::si_scales(p));
  const Groups<double>& g = oscillator.dimensionless_groups();
  const double R = test::small_equilibrium_stretch;
  const double expected = (2 * g.m * R * R * R + g.n * std::pow(R, 6)) / (g.a0 + (g.b + g.m) * std::pow(R, 4));
  const FreeMotion motion(oscillator, 6000 * middle_pressure, R);
  EXPECT_NEAR(motion.beta(), expected, 1e-12 * expected);
  EXPECT_THROW((void)motion.require_deflation(), InvalidInput);
}

TEST(FreeMotion, FindsTheWell) {
  const auto oscillator = test::orifice_balloon(1.0, 1000.0);
  const FreeMotion small(oscillator, middle_pressure, 1.9);
  EXPECT_NEAR(small.equilibrium(), test::small_equilibrium_stretch, 1e-13);
  EXPECT_EQ(small.least(), 0);
  EXPECT_NEAR(small.greatest(), 2.0043852291984, 1e-12);
  const FreeMotion large(oscillator, middle_pressure, 2.1);
  EXPECT_NEAR(large.equilibrium(), test::large_equilibrium_stretch, 1e-13);
  EXPECT_EQ(large.greatest(), std::numeric_limits<double>::infinity());
  EXPECT_NO_THROW(FreeMotion(oscillator, -2.0, 1.0));  // compressed, but stable
}

TEST(FreeMotion, RefusesWhatHasNoWell) {
  const auto oscillator = test::orifice_balloon(1.0, 1000.0);
  for (const double R : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(FreeMotion(oscillator, middle_pressure, R), InvalidInput) << R;
  }
  EXPECT_THROW(FreeMotion(oscillator, std::nan(""), 1.2), InvalidInput);
  auto p = test::paper_balloon(0.03, 0.0);
  p.material = NeoHookean<double>{1e6};
  const Oscillator<double> soft(Model::orifice, p, constant_pressure(0.0), test::si_scales(p));
  EXPECT_THROW(FreeMotion(soft, 1e6, 1.2), InvalidInput);  // above its limit point: no equilibrium at all
  EXPECT_THROW(FreeMotion(soft, 1e4, 50), InvalidInput);   // beyond the unstable one
  p.material = Gent<double>{4e5, 30};
  const Oscillator<double> locking(Model::orifice, p, constant_pressure(0.0), test::si_scales(p));
  EXPECT_THROW(FreeMotion(locking, 1e3, 10), InvalidInput);
  try {
    (void)FreeMotion(soft, 1e4, 50);
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("(unstable)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace turgor
