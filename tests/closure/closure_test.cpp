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
