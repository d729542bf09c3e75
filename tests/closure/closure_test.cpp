#include "turgor/closure/closure.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "../support/reference.hpp"
#include "turgor/base/errors.hpp"

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
  for (const Closure closure : {Closure::theoretical, Closure::corrected}) {
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
  for (const Closure closure : all_closures) {
    const auto balloon = test::with_closure(p, closure);
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
      const double force = generalized_force(closure, regime, state, balloon.outflow.get());
      EXPECT_NEAR(wall, force, 1e-11 * 4 * pi * std::pow(p.radius * R, 2) * 21e3);
    }
  }
}

const std::vector<long double> openings{0x1p-17L, 1e-4L, 1.0L / 200, 1.0L / 30, 0.1L, 0.25L, 0.5L, 0.75L};

/// g1, g2 and g4 as appendix B of the paper has them.
struct Literal {
  long double g1, g2, g4;
  explicit Literal(long double kappa) {
    const long double pi = std::numbers::pi_v<long double>;
    const long double e = kappa * kappa / (1 + std::sqrt(1 - kappa * kappa));
    g1 = 2 * pi * (2 - e);
    g2 = 2 * pi * (2 - e) * (2 - e) / (e * (1 - e));
    g4 = -2 * pi * (2 - e) * (2 - e) * (2 - 4 * e + e * e) / (e * std::pow(1 - e, 3.0L));
  }
};

// A dozen roundings in double.
TEST(ExactClosure, ChannelFactorsAreTheCoefficientsOfAppendixB) {
  const long double pi = std::numbers::pi_v<long double>;
  for (const long double kappa : openings) {
    const auto h = channel_factors(static_cast<double>(kappa));
    const Literal g(static_cast<double>(kappa));
    const double k = static_cast<double>(kappa);
    const auto check = [&](double found, long double expected) {
      EXPECT_NEAR(found / static_cast<double>(expected), 1, 2e-15) << "kappa = " << k;
    };
    check(h.area, g.g1 / (4 * pi));
    check(h.inertial, k * k * g.g2 / (16 * pi));
    check(h.centripetal, -k * k * g.g4 / (32 * pi));
  }
}

// Central differences of order h^2 in long double: 1e-10 of second derivatives below 50.
TEST(ExactClosure, ChannelFactorsHaveTheirDerivatives) {
  for (const long double kappa : openings) {
    const long double h = 1e-6L;
    const auto at = channel_factors(kappa);
    const auto up = channel_factors(kappa + h);
    const auto down = channel_factors(kappa - h);
    const auto check = [&](long double high, long double low, long double slope) {
      EXPECT_NEAR(static_cast<double>((high - low) / (2 * h)), static_cast<double>(slope), 1e-9)
          << "kappa = " << static_cast<double>(kappa);
    };
    check(up.area, down.area, at.area_slope);
    check(up.inertial, down.inertial, at.inertial_slope);
    check(up.centripetal, down.centripetal, at.centripetal_slope);
  }
}

// (2.8) term by term, with g3 = 16 pi h3/kappa and g5 = 32 pi h5/kappa^4 from the table; both left out while inflating.
TEST(ExactClosure, ForceIsThatOfTheSeries) {
  const double pi = std::numbers::pi;
  for (const double kappa : {0.02, 0.2, 0.7}) {
    const FlowState<double> s{0.31, 0.02, -0.4, 20e3, 0.31 * kappa, 0.5, 900};
    const Literal g(kappa);
    const auto h = ForceTable::uniform().at(kappa);
    for (const Regime regime : {Regime::inflating, Regime::deflating}) {
      const double on = regime == Regime::deflating ? 1 : 0;
      const double g3 = on * 16 * pi * h.inertial / kappa;
      const double g5 = on * 32 * pi * h.centripetal / std::pow(kappa, 4);
      const double L = s.channel_length;
      const double r = s.radius;
      const std::array<double, 3> terms{
          static_cast<double>(g.g1) * r * r * s.inlet_pressure,
          -s.fluid_density * (L * static_cast<double>(g.g2) + g3 * r) * r * r * s.radial_accel,
          s.fluid_density * (L * static_cast<double>(g.g4) + g5 * r) * r * s.radial_rate * s.radial_rate};
      const double size = std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]);
      EXPECT_NEAR(generalized_force(Closure::potential, regime, s), terms[0] + terms[1] + terms[2], 1e-14 * size);
    }
  }
}

// Towards a small orifice (2.8) turns into (2.12) with m = 2 and n = 4 (r0/r_ch)^3 for the fitted numbers. The next
// order is kappa in h5, kappa ln(1/kappa)/4 in h3 and kappa^2 in the others.
TEST(ExactClosure, BecomesTheSmallOrificeFormWithItsOwnConstants) {
  const auto limit = constants<double>(Closure::potential);
  EXPECT_EQ(limit.inertial, 2);
  EXPECT_EQ(limit.centripetal, 4);
  for (const double kappa : {1e-2, 1e-3, 1e-4}) {
    const auto p = test::with_closure(test::paper_balloon<double>(0.3 * kappa, 0.3), Closure::potential);
    const auto scales = test::si_scales(p);
    const Oscillator<double> oscillator(Model::full, p, constant_pressure(0.0), scales);
    const auto g = groups(p, scales);
    const double R = 1.3;
    const auto in = oscillator.coefficients(Regime::inflating, R);
    const auto out = oscillator.coefficients(Regime::deflating, R);
    const double R4 = std::pow(R, 4);
    EXPECT_NEAR(in.mass * g.K / (g.a0 + g.b * R4), 1, kappa * kappa);
    EXPECT_NEAR(in.centripetal * g.K / (-2 * g.b * std::pow(R, 3)), 1, kappa * kappa);
    EXPECT_NEAR(out.area / (R * R), 1, kappa * kappa);
    EXPECT_NEAR((out.mass - in.mass) * g.K / (2 * R4), 1, kappa * std::log(1 / kappa) / 2);
    EXPECT_NEAR((out.centripetal - in.centripetal) * g.K / (4 * std::pow(kappa, -3) * std::pow(R, 6)), 1, 2 * kappa);
    EXPECT_NE(out.area, R * R);
    EXPECT_NEAR(g.m, 2, kappa * std::log(1 / kappa));
    EXPECT_NEAR(g.n * std::pow(kappa, 3), 4, 8 * kappa);
  }
}

std::string key_of_refusal(const Parameters<double>& p) {
  try {
    static_cast<void>(force_table(p));
  } catch (const InvalidInput& error) {
    return error.issues().front().key;
  }
  return "";
}

TEST(ExactClosure, RefusesABalloonBeyondItsTable) {
  const auto with_orifice = [](double kappa, Closure closure) {
    return test::with_closure(test::paper_balloon<double>(0.3 * kappa, 0.0), closure);
  };
  EXPECT_EQ(key_of_refusal(with_orifice(0.76, Closure::potential)), "inlet.orifice_radius");
  EXPECT_EQ(key_of_refusal(with_orifice(7e-6, Closure::potential)), "inlet.orifice_radius");
  EXPECT_EQ(key_of_refusal(with_orifice(0.74, Closure::potential)), "");
  EXPECT_EQ(key_of_refusal(with_orifice(0.76, Closure::corrected)), "");
  auto p = with_orifice(0.1, Closure::profile);
  EXPECT_EQ(force_table(p), p.outflow.get());
  EXPECT_EQ(force_table(with_orifice(0.1, Closure::potential)), &ForceTable::uniform());
  EXPECT_EQ(force_table(with_orifice(0.1, Closure::theoretical)), nullptr);
  p.outflow.reset();
  EXPECT_EQ(key_of_refusal(p), "model.closure");
}

}  // namespace
}  // namespace turgor
