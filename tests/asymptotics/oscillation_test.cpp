// (3.18) to (3.20) and one order more, against exact motion.

#include "turgor/asymptotics/oscillation.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "../support/reference.hpp"
#include "motions.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using Long = long double;
using test::middle_pressure;

template <class T>
Oscillator<T> balloon(bool channel) {
  return channel ? test::channel_balloon<T>(T(0.2233), 50, T(middle_pressure))
                 : test::orifice_balloon<T>(T(0.2233), 50, T(middle_pressure));
}

FreeMotion motion(bool channel) { return {balloon<double>(channel), middle_pressure, 1.3}; }

// The reference has alpha = 1; the constants of (3.20) do not depend on the clock.
TEST(Oscillation, ReproducesTheReferenceValues) {
  for (const char* name : {"R_inflation_3.18", "R_inflation_3.19"}) {
    for (const auto& entry : test::reference().at(name)) {
      const bool second = std::string(name).ends_with("19");
      const FreeMotion about(second ? test::channel_balloon(1.0, 500.0) : test::orifice_balloon(1.0, 500.0),
                             middle_pressure, 4.8);
      const Oscillation inflation(about, Regime::inflating);
      const double e = entry.input("R_i") - about.equilibrium();
      const double T = entry.input("T") / inflation.frequency();
      const Estimate R = second ? inflation.second_order(e, T) : inflation.first_order(e, T);
      EXPECT_NEAR(R.value, entry.value, 1e-14) << entry.inputs;
    }
  }
  const auto& entry = test::reference().at("alpha2_tilde").front();
  EXPECT_NEAR(alpha2(FreeMotion(test::channel_balloon(1.0, 500.0), middle_pressure, 4.8)), entry.value, 1e-13);
}

// (3.20b) as the paper writes it.
TEST(Oscillation, Alpha2IsThePapersForMooneyRivlin) {
  const FreeMotion about = motion(true);
  const auto r = [&](int n) { return std::pow(about.equilibrium(), -n); };
  const double alpha1 = 10 * (7 * r(10) - r(4)) + r(2) + 5 * r(8);
  EXPECT_NEAR(alpha2(about), (30 * (7 * r(10) - 2 * r(4)) + 7 * r(2) + 20 * r(8)) / alpha1, 1e-12);
  EXPECT_NEAR(about.frequency(Regime::inflating), std::sqrt(0.2233 * alpha1), 1e-13);
}

/// Slopes of the errors of the three orders when the amplitude is halved, at one time within the first half-cycle.
std::array<double, 3> slopes(bool channel, Regime regime, double amplitude) {
  const Oscillation law(motion(channel), regime);
  const double R_eq = motion(channel).equilibrium();
  const double T = 1.2 / law.frequency();
  const auto errors = [&](double e) {
    const auto start = static_cast<Long>(R_eq) + static_cast<Long>(e);
    const double exact = test::exact_stretch<Long>(balloon<Long>(channel), start, T);
    return std::array{std::abs(law.first_order(e, T).value - exact), std::abs(law.second_order(e, T).value - exact),
                      std::abs(law.third_order(e, T).value - exact)};
  };
  const double sign = regime == Regime::inflating ? -1 : 1;
  const auto coarse = errors(sign * amplitude);
  const auto fine = errors(sign * amplitude / 2);
  std::array<double, 3> order{};
  for (std::size_t i = 0; i < 3; ++i) order[i] = test::order(coarse[i], fine[i], 2);
  return order;
}

TEST(Oscillation, OrdersAreTwoThreeAndFour) {
  for (const bool channel : {false, true}) {
    for (const Regime regime : {Regime::inflating, Regime::deflating}) {
      const auto order = slopes(channel, regime, regime == Regime::inflating ? 1e-3 : 2e-4);
      EXPECT_NEAR(order[0], 2, 0.05) << channel;
      EXPECT_NEAR(order[1], 3, 0.05) << channel;
      EXPECT_NEAR(order[2], 4, 0.2) << channel;
    }
  }
}

// pi/alpha has a relative error O(e^2), in both models and regimes; its coefficient is known.
TEST(Oscillation, HalfPeriodsAreOfSecondOrder) {
  for (const bool channel : {false, true}) {
    for (const Regime regime : {Regime::inflating, Regime::deflating}) {
      const Oscillation law(motion(channel), regime);
      const double R_eq = motion(channel).equilibrium();
      const double sign = regime == Regime::inflating ? -1 : 1;
      const auto exact = [&](double e) {
        return static_cast<double>(
            test::exact_turn<Long>(balloon<Long>(channel), static_cast<Long>(R_eq) + static_cast<Long>(e)).time);
      };
      const double e = sign * (regime == Regime::inflating ? 2e-3 : 2e-4);
      const double coarse = exact(e);
      const double fine = exact(e / 2);
      const double slope = test::order(std::abs(law.half_period(e).value / coarse - 1),
                                       std::abs(law.half_period(e / 2).value / fine - 1), 2);
      EXPECT_NEAR(slope, 2, 0.03) << channel;
      const double corrected = test::order(std::abs(law.corrected_half_period(e).value / coarse - 1),
                                           std::abs(law.corrected_half_period(e / 2).value / fine - 1), 2);
      EXPECT_NEAR(corrected, 3, 0.1) << channel;
      EXPECT_NEAR(law.half_period(e).error / std::abs(law.half_period(e).value - coarse), 1, 0.2) << channel;
    }
  }
}

// Within a quarter of its reach an expansion must not promise too much, nor nothing.
TEST(Oscillation, KnowsItsErrors) {
  for (const bool channel : {false, true}) {
    const Oscillation law(motion(channel), Regime::inflating);
    const double R_eq = motion(channel).equilibrium();
    for (const double part : {0.02, 0.1, 0.25}) {
      const double e = -part * law.reach();
      for (const double angle : {0.3, 1.2, 2.0, 3.0}) {
        const double T = angle / law.frequency();
        const double exact = test::exact_stretch<Long>(balloon<Long>(channel), static_cast<Long>(R_eq + e), T);
        for (const Estimate& R : {law.first_order(e, T), law.second_order(e, T), law.third_order(e, T)}) {
          EXPECT_LT(std::abs(R.value - exact), 1.2 * R.error + 1e-15) << channel << " " << part << " " << angle;
        }
        EXPECT_LT(law.first_order(e, T).error, part * std::abs(e));
      }
    }
  }
}

TEST(Oscillation, RefusesAmplitudesBeyondItsReach) {
  const Oscillation law(motion(true), Regime::deflating);
  EXPECT_NO_THROW((void)law.first_order(0.99 * law.reach(), 1));
  for (const double e : {1.01 * law.reach(), -1.01 * law.reach(), std::nan("")}) {
    EXPECT_THROW((void)law.first_order(e, 1), InvalidInput) << e;
    EXPECT_THROW((void)law.third_order(e, 1), InvalidInput) << e;
  }
  EXPECT_THROW((void)law.second_order(0.1 * law.reach(), -1), InvalidInput);
}

}  // namespace
}  // namespace turgor
