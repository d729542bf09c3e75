#include "turgor/oscillator/oscillator.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "../support/reference.hpp"
#include "turgor/integrate/oscillator_flow.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

using test::paper_balloon;
using test::si_scales;

TEST(Groups, ReproduceTheReferenceValues) {
  const std::map<std::string, double Groups<double>::*> members{
      {"C1", &Groups<double>::C1},
      {"C2", &Groups<double>::C2},
      {"C3", &Groups<double>::C3},
      {"Ct1", &Groups<double>::C1_long},
      {"Ct2", &Groups<double>::C2_long},
      {"222_solid_inertia", &Groups<double>::a0},
      {"222_balloon_inertia_defl=223/(32pi)", &Groups<double>::m},
      {"222_balloon_centripetal_defl", &Groups<double>::n},
      {"222_stiffness_prefactor", &Groups<double>::K},
      {"222_2L/r_ch", &Groups<double>::b},
  };
  for (const auto& [name, member] : members) {
    ASSERT_FALSE(test::reference().at(name).empty());
    for (const auto& entry : test::reference().at(name)) {
      const auto p = paper_balloon<double>(entry.input("r_ch"), entry.input("L_ch"));
      const auto g = groups(p, {p.radius, entry.input("p_typ"), entry.input("t_typ")});
      // A handful of roundings; the reference's own bound is one.
      EXPECT_NEAR(g.*member, entry.value, std::max(entry.error_bound, 1e-14 * std::abs(entry.value)))
          << name << entry.inputs;
    }
  }
}

// (3.6a), (3.6b) and (3.7): the time constants of small motions about an equilibrium, from the oscillator's own
// functions.
TEST(TimeConstants, ReproduceTheReferenceValues) {
  const double pressure = 6000 * test::reference().at("P0_mean").front().value;
  const auto check = [&](const char* name, Model model, Regime regime) {
    ASSERT_FALSE(test::reference().at(name).empty());
    for (const auto& entry : test::reference().at(name)) {
      const auto p = paper_balloon<double>(entry.input("r_ch"), entry.has("L_ch") ? entry.input("L_ch") : 0);
      const auto states = equilibria(p, pressure);
      const double R = entry.text("R_eq") == "small" ? states.front().stretch : states.back().stretch;
      const Oscillator<double> oscillator(model, p, constant_pressure(pressure), si_scales(p));
      const auto c = oscillator.coefficients(regime, R);
      const double time = std::sqrt(c.mass / (c.elastic_slope - c.area_slope * pressure));
      EXPECT_NEAR(time, entry.value, 1e-11 * entry.value)
          << name << entry.inputs;  // the stiffness is a small difference
    }
  };
  check("t_typ_deflation_nochannel[s]", Model::orifice, Regime::deflating);
  check("t_typ_inflation_nochannel[s]", Model::orifice, Regime::inflating);
  check("t_typ_channel[s]", Model::long_channel, Regime::deflating);
}

// The two clocks: C1 = 1/(...) on deflation's, C3 = 1/(...) on inflation's, and what C3 becomes on deflation's.
TEST(TimeConstants, EachRegimeHasItsOwnClock) {
  for (const auto& entry : test::reference().at("C3_on_deflation_clock")) {
    const auto p = paper_balloon<double>(entry.input("r_ch"), 0.0);
    const auto g = groups(p, {p.radius, entry.input("p_typ"), entry.input("t_typ")});
    EXPECT_NEAR(g.C3, entry.value, 1e-13 * entry.value);
    const char* size = entry.text("R_eq") == "small" ? "small" : "large";
    for (const auto& c1 : test::reference().at("C1_3.6a")) {
      if (c1.text("R_eq") == size) {
        EXPECT_NEAR(g.C1, c1.value, 1e-12 * c1.value);
      }
    }
  }
  for (const auto& entry : test::reference().at("C3_3.6b")) {
    for (const auto& time : test::reference().at("t_typ_inflation_nochannel[s]")) {
      if (time.text("R_eq") != entry.text("R_eq")) continue;
      const auto p = paper_balloon<double>(time.input("r_ch"), 0.0);
      EXPECT_NEAR(groups(p, {p.radius, 6000.0, time.value}).C3, entry.value, 1e-12 * entry.value);
    }
  }
}

struct Variant {
  Model model;
  Regime regime;
};

class EveryOscillator : public testing::TestWithParam<Variant> {
 protected:
  Parameters<double> p = paper_balloon<double>(0.02, GetParam().model == Model::orifice ? 0.0 : 0.4);
  Oscillator<double> oscillator{GetParam().model, p, test::up_hold_down(36e3, 2.0, 4.0, 6.0), {p.radius, 6000.0, 0.3}};
};

// Central differences in long steps; the bound is their O(h^2) with third derivatives of the size of the function.
TEST_P(EveryOscillator, CoefficientSlopesAreDerivatives) {
  constexpr double h = 1e-5;
  for (const double R : {0.8, 1.1, 2.4, 5.0}) {
    const auto c = oscillator.coefficients(GetParam().regime, R);
    const auto up = oscillator.coefficients(GetParam().regime, R + h);
    const auto down = oscillator.coefficients(GetParam().regime, R - h);
    const auto check = [&](double value_up, double value_down, double slope, double value) {
      EXPECT_NEAR((value_up - value_down) / (2 * h), slope, 1e-7 * (std::abs(slope) + std::abs(value)));
    };
    check(up.mass, down.mass, c.mass_slope, c.mass);
    check(up.centripetal, down.centripetal, c.centripetal_slope, c.centripetal);
    check(up.area, down.area, c.area_slope, c.area);
    check(up.elastic, down.elastic, c.elastic_slope, c.elastic);
    EXPECT_NEAR((oscillator.elastic_energy(R + h) - oscillator.elastic_energy(R - h)) / (2 * h), c.elastic,
                1e-7 * (std::abs(c.elastic) + c.elastic_slope));
  }
}

TEST_P(EveryOscillator, LinearizationIsTheDerivativeOfTheRate) {
  const SmoothPressure<double>& pressure = oscillator.pressure().after(0);
  using Solid = MooneyRivlin<double>;
  using State = OscillatorFlow<double, Solid>::State;
  const auto numbers = flow_numbers(oscillator, pressure, GetParam().regime);
  const OscillatorFlow<double, Solid> flow(numbers, std::get<Solid>(oscillator.parameters().material), true);
  const double t = 3.1;
  const State y{1.2, 0.3 * static_cast<int>(GetParam().regime)};
  const auto at = flow.linearize(t, y);
  EXPECT_NEAR((at.rate - flow.rate(t, y)).norm(), 0, 1e-14 * at.rate.norm());
  constexpr double h = 1e-6;
  for (int j = 0; j < 2; ++j) {
    State up = y;
    State down = y;
    up[j] += h;
    down[j] -= h;
    const State column = (flow.rate(t, up) - flow.rate(t, down)) / (2 * h);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(column[i], at.jacobian(i, j),
                  1e-7 * (at.jacobian.cwiseAbs().maxCoeff() + at.rate.cwiseAbs().maxCoeff()));
    }
  }
  const State in_time = (flow.rate(t + h, y) - flow.rate(t - h, y)) / (2 * h);
  const auto eigenvalues = at.jacobian.eigenvalues();
  EXPECT_NEAR(flow.stiffness(t, y), eigenvalues.cwiseAbs().maxCoeff(), 0.5 * eigenvalues.cwiseAbs().maxCoeff());
  EXPECT_NEAR(in_time[1], at.time_derivative[1], 1e-6 * std::abs(at.rate[1]));
}

INSTANTIATE_TEST_SUITE_P(
    Models, EveryOscillator,
    testing::Values(Variant{Model::full, Regime::inflating}, Variant{Model::full, Regime::deflating},
                    Variant{Model::orifice, Regime::inflating}, Variant{Model::orifice, Regime::deflating},
                    Variant{Model::long_channel, Regime::inflating}, Variant{Model::long_channel, Regime::deflating}),
    [](const auto& test) {
      std::string name(name_of(test.param.model));
      std::replace(name.begin(), name.end(), '-', '_');
      return name + (test.param.regime == Regime::inflating ? "_inflating" : "_deflating");
    });

TEST(Scales, NaturalOnesAreTheDeflationClockAtRestAndTheGreatestPressure) {
  const auto p = paper_balloon<double>(0.03, 0.5);
  const auto program = test::up_hold_down(36e3, 2.0, 4.0, 6.0);
  const auto scales = natural_scales(p, program, 10.0);
  EXPECT_DOUBLE_EQ(scales.pressure, 36e3);
  const Oscillator<double> oscillator(Model::full, p, program, scales);
  const auto c = oscillator.coefficients(Regime::deflating, 1.0);
  EXPECT_NEAR(c.elastic_slope / c.mass, 1.0, 1e-12);  // omega t_typ = 1
  EXPECT_GT(natural_scales(p, constant_pressure(0.0), 10.0).pressure, 0);
}

}  // namespace
}  // namespace turgor
