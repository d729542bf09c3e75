#include "turgor/oscillator/oscillator.hpp"

#include <gtest/gtest.h>

#include "../support/balloons.hpp"
#include "../support/reference.hpp"
#include "turgor/integrate/exact_flow.hpp"
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
  Closure closure = Closure::corrected;
};

class EveryOscillator : public testing::TestWithParam<Variant> {
 protected:
  Parameters<double> p = test::with_closure(paper_balloon<double>(has_table(GetParam().closure) ? 0.15 : 0.02,
                                                                  GetParam().model == Model::orifice ? 0.0 : 0.4),
                                            GetParam().closure);
  Oscillator<double> oscillator{GetParam().model, p, test::up_hold_down(36e3, 2.0, 4.0, 6.0), {p.radius, 6000.0, 0.3}};

  template <class Flow>
  void expect_linearized(const Flow& flow) const;
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
  const auto numbers = flow_numbers(oscillator, pressure, GetParam().regime);
  const Material<double>& material = oscillator.parameters().material;
  if (has_table(GetParam().closure)) {
    expect_linearized(ExactFlow<double>(numbers, material, *oscillator.force_table(), true));
  } else {
    expect_linearized(OscillatorFlow<double, Solid>(numbers, std::get<Solid>(material), true));
  }
}

template <class Flow>
void EveryOscillator::expect_linearized(const Flow& flow) const {
  using State = typename Flow::State;
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
                    Variant{Model::long_channel, Regime::inflating}, Variant{Model::long_channel, Regime::deflating},
                    Variant{Model::full, Regime::inflating, Closure::potential},
                    Variant{Model::full, Regime::deflating, Closure::potential},
                    Variant{Model::full, Regime::deflating, Closure::calibrated},
                    Variant{Model::orifice, Regime::inflating, Closure::potential},
                    Variant{Model::orifice, Regime::deflating, Closure::profile},
                    Variant{Model::long_channel, Regime::inflating, Closure::profile},
                    Variant{Model::long_channel, Regime::deflating, Closure::potential}),
    [](const auto& test) {
      std::string name(name_of(test.param.model));
      std::replace(name.begin(), name.end(), '-', '_');
      return name + "_" + std::string(name_of(test.param.closure)) +
             (test.param.regime == Regime::inflating ? "_inflating" : "_deflating");
    });

TEST(Scales, NaturalOnesAreTheDeflationClockAtRestAndTheGreatestPressure) {
  for (const Closure closure : {Closure::corrected, Closure::potential}) {
    const auto p = test::with_closure(paper_balloon<double>(0.1, 0.5), closure);
    const auto program = test::up_hold_down(36e3, 2.0, 4.0, 6.0);
    const auto scales = natural_scales(p, program, 10.0);
    EXPECT_DOUBLE_EQ(scales.pressure, 36e3);
    const Oscillator<double> oscillator(Model::full, p, program, scales);
    const auto c = oscillator.coefficients(Regime::deflating, 1.0);
    EXPECT_NEAR(c.elastic_slope / c.mass, 1.0, 1e-12);  // omega t_typ = 1
    EXPECT_GT(natural_scales(p, constant_pressure(0.0), 10.0).pressure, 0);
  }
}

// M, Q and a by hand for each model: the terms of (2.22), (2.23) and (2.25), each with its factor, none of them twice.
TEST(ExactClosure, PutsAFactorOnEachTermOfEveryModel) {
  for (const Model model : {Model::full, Model::orifice, Model::long_channel}) {
    const bool channel = model != Model::orifice;
    const auto p = test::with_closure(paper_balloon<double>(0.15, channel ? 0.4 : 0.0), Closure::potential);
    const Oscillator<double> oscillator(model, p, constant_pressure(0.0), si_scales(p));
    const double R = 1.7;
    const auto h = channel_factors(0.5 / R);
    const auto l = ForceTable::uniform().at(0.5 / R);
    const double K = 0.15 / (2 * 1000 * 0.027);
    const double a0 = 0.15 * 0.003 / 0.09;
    const double b4 = 2 * 0.4 / 0.15 * h.inertial * std::pow(R, 4);
    const double m4 = 2 * l.inertial * std::pow(R, 4);
    const double b3 = -2 * 2 * 0.4 / 0.15 * h.centripetal * std::pow(R, 3);
    const double n6 = 4 * 8 * l.centripetal * std::pow(R, 6);
    const auto in = oscillator.coefficients(Regime::inflating, R);
    const auto out = oscillator.coefficients(Regime::deflating, R);
    const bool full = model == Model::full;
    const auto near = [&](double found, double expected) {
      EXPECT_NEAR(found * K, expected, 1e-13 * std::abs(expected)) << name_of(model);
    };
    near(in.mass, (model == Model::long_channel ? 0 : a0) + (channel ? b4 : 0));
    near(out.mass, (full ? a0 : 0) + (channel ? b4 : 0) + (model == Model::long_channel ? 0 : m4));
    near(in.centripetal, channel ? b3 : 0);
    near(out.centripetal, n6 + (full ? b3 : 0));
    for (const auto& c : {in, out}) EXPECT_DOUBLE_EQ(c.area, h.area * R * R);
    EXPECT_DOUBLE_EQ(oscillator.area(R), in.area);
    EXPECT_EQ(oscillator.conserves_energy(Regime::inflating), !channel);
    EXPECT_FALSE(oscillator.conserves_energy(Regime::deflating));
  }
}

// Inflating, K (M'/2 + Q) = b R^3 eps (1+rho)^3/(16 rho^3): docs/theory.md, section 2.4.
TEST(ExactClosure, GainsALittleEnergyWhileInflatingThroughAChannel) {
  const auto p = test::with_closure(paper_balloon<double>(0.15, 0.4), Closure::potential);
  const Oscillator<double> oscillator(Model::full, p, constant_pressure(0.0), si_scales(p));
  const auto& g = oscillator.dimensionless_groups();
  for (const double R : {0.8, 1.0, 3.0, 40.0}) {
    const auto c = oscillator.coefficients(Regime::inflating, R);
    const double rho = std::sqrt(1 - 0.25 / (R * R));
    const double eps = 0.25 / (R * R) / (1 + rho);
    const double gain = g.b * std::pow(R, 3) * eps * std::pow((1 + rho) / rho, 3) / 16;
    // a difference of two terms of size |Q|
    EXPECT_NEAR(g.K * (c.mass_slope / 2 + c.centripetal), gain, 1e-14 * g.K * std::abs(c.centripetal)) << R;
  }
}

}  // namespace
}  // namespace turgor
