#include "turgor/closure/closure.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "../support/reference.hpp"

namespace turgor {
namespace {

// Ratios of the corrected to the theoretical constants, which section 2.3 rounds to 1.095 and 1.56.
TEST(Closure, CorrectedConstantsAreTheTheoreticalOnesTimesTheStatedFactors) {
  const auto theoretical = constants<double>(Closure::theoretical);
  const auto corrected = constants<double>(Closure::corrected);
  EXPECT_NEAR(corrected.inertial / theoretical.inertial, 1.09503, 5e-6);
  EXPECT_DOUBLE_EQ(corrected.centripetal / theoretical.centripetal, 1.5625);
}

TEST(Closure, ForceReproducesTheReferenceValues) {
  for (const char* name : {"F_2.11", "F_2.15"}) {
    ASSERT_FALSE(test::reference().at(name).empty());
    for (const auto& entry : test::reference().at(name)) {
      const Closure closure = std::string(name) == "F_2.15" ? Closure::corrected : Closure::theoretical;
      const Regime regime = entry.input("rdot") < 0 ? Regime::deflating : Regime::inflating;
      const FlowState<double> state{entry.input("r"),     entry.input("rdot"), entry.input("rddot"),
                                    entry.input("p_ext"), entry.input("r_ch"), entry.input("L_ch"),
                                    entry.input("rho")};
      const double force = generalized_force(closure, regime, state);
      EXPECT_NEAR(force, entry.value, std::max(entry.error_bound, 1e-9)) << entry.inputs;
    }
  }
}

// Each term of (2.12) and (2.15) written out as the paper does, with its 1 - sgn(dr/dt).
TEST(Closure, PartsAreTheTermsOfThePaper) {
  const double pi = std::numbers::pi;
  const double rho = 870, r_ch = 0.013, L = 0.4, r = 0.21, p = 1234;
  for (const Closure closure : all_closures) {
    const bool corrected = closure == Closure::corrected;
    for (const double rate : {-0.07, 0.05}) {
      for (const double acceleration : {-0.6, 0.9}) {
        const double sign = rate < 0 ? -1 : 1;
        const double inertial = (corrected ? 223.0 / 32 : 9 / std::sqrt(2.0)) * (1 - sign);
        const double centripetal = (corrected ? 75.0 / 32 : 1.5) * (1 - sign);
        const double dv = 4 * rho / r_ch * std::pow(r, 4) * acceleration;
        const double v2 = 32 * rho / (r_ch * r_ch) * std::pow(r, 3) * rate * rate;
        const Regime regime = rate < 0 ? Regime::deflating : Regime::inflating;
        const FlowState<double> state{r, rate, acceleration, p, r_ch, L, rho};
        const ForceParts<double> parts = force_parts(closure, regime, state);
        EXPECT_DOUBLE_EQ(parts.statics, 4 * pi * r * r * p);
        EXPECT_DOUBLE_EQ(parts.channel_inertial, -dv * 4 * pi * L / r_ch);
        EXPECT_DOUBLE_EQ(parts.channel_centripetal, -v2 * pi * L);
        EXPECT_DOUBLE_EQ(parts.balloon_inertial, -dv * inertial);
        EXPECT_DOUBLE_EQ(parts.balloon_centripetal, v2 * centripetal * std::pow(r, 3) / (r_ch * r_ch));
        const double force = 4 * pi * r * r * p - dv * (4 * pi * L / r_ch + inertial) -
                             v2 * (pi * L - centripetal * std::pow(r, 3) / (r_ch * r_ch));
        EXPECT_NEAR(generalized_force(closure, regime, state), force, 1e-14 * (std::abs(dv) + v2) * 1e4);
      }
    }
  }
}

// The force law and the oscillator are two derivations of one balance: 8 pi rho_s r0^2 d0 r'' + 4 pi r0 d0 W' = F - 4
// pi r^2 p_a.
TEST(Closure, ForceAndOscillatorAgree) {
  const auto p = test::paper_balloon<double>(0.02, 0.3);
  for (const Closure closure : {Closure::theoretical, Closure::corrected}) {
    auto balloon = p;
    balloon.closure = closure;
    const Oscillator<double> oscillator(Model::full, balloon, constant_pressure(21e3), test::si_scales(balloon));
    for (const Regime regime : {Regime::inflating, Regime::deflating}) {
      const double R = 1.3;
      const double rate = 0.2 * static_cast<int>(regime);
      const auto c = oscillator.coefficients(regime, R);
      const double acceleration = (c.centripetal * rate * rate + c.area * 21e3 - c.elastic) / c.mass;
      const FlowState<double> state{p.radius * R, p.radius * rate, p.radius * acceleration, 21e3, 0.02, 0.3, 1000};
      const double pi = std::numbers::pi;
      const double wall = 8 * pi * 1000 * p.radius * p.radius * p.thickness * p.radius * acceleration +
                          4 * pi * p.radius * p.thickness * strain_energy(p.material, R).first;
      const double force = generalized_force(closure, regime, state);
      EXPECT_NEAR(wall, force, 1e-11 * 4 * pi * std::pow(p.radius * R, 2) * 21e3);
    }
  }
}

}  // namespace
}  // namespace turgor
