// Whatever the balloon: an answer in finite numbers, or InvalidInput.

#include <gtest/gtest.h>

#include "../support/seed.hpp"
#include "motions.hpp"
#include "turgor/asymptotics/decay.hpp"
#include "turgor/asymptotics/piecewise_solution.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

void expect_usable(const Estimate& e, const std::string& what) {
  EXPECT_TRUE(std::isfinite(e.value)) << what;
  EXPECT_TRUE(std::isfinite(e.error)) << what;
  EXPECT_GE(e.error, 0) << what;
}

void try_all(const FreeMotion& motion, double start) {
  const std::string where = "from " + std::to_string(start) + " about " + std::to_string(motion.equilibrium());
  for (const Regime regime : {Regime::deflating, Regime::inflating}) {
    const Oscillation law(motion, regime);
    const double e = std::min(std::abs(start - motion.equilibrium()), law.reach());
    expect_usable(law.third_order(e, 1 / law.frequency()), "oscillation " + where);
    expect_usable(law.half_period(start - motion.equilibrium()), "half period " + where);
  }
  if (start > motion.equilibrium()) {
    const Decay decay(motion);
    expect_usable(decay.corrected_undershoot(start - motion.equilibrium()), "undershoot " + where);
    expect_usable(decay.amplitude(start - motion.equilibrium(), 2000), "decay " + where);
  }
  const PiecewiseSolution solution(motion, start, 4, Chain::uniform);
  for (const double part : {0.0, 1e-9, 0.3, 0.7, 1.0})
    expect_usable(solution.at(part * solution.end_time()), "chain " + where);
  if (start > motion.equilibrium()) {
    const MatchedDeflation matched(motion, start);
    for (const double T : {0.0, 1e-6, 1.0, 1e4}) expect_usable(matched.composite(T), "composite " + where);
    expect_usable(matched.transition_time(), "transition " + where);
  }
}

TEST(Asymptotics, AnswersOrRefuses) {
  std::mt19937_64 random(test::random_seed());
  const std::vector<Material<double>> materials{MooneyRivlin<double>{1.5e6, 1.5e5},
                                                NeoHookean<double>{4e5},
                                                Gent<double>{4e5, 30},
                                                Fung<double>{5e4, 0.8},
                                                Ogden<double>{{6.3e5, 1.2e3, -1e4}, {1.3, 5.0, -2.0}},
                                                ArrudaBoyce<double>{3e5, 5.0}};
  int answered = 0;
  for (int i = 0; i < 600; ++i) {
    auto p = test::paper_balloon(std::pow(10, test::between(random, -3, -0.7)), 0.0);
    if (i % 2 == 1) p.channel_length = std::pow(10, test::between(random, -2, 0.5));
    p.material = materials[static_cast<std::size_t>(i) % materials.size()];
    const double pressure = test::between(random, -2, 10);  // of about what these walls hold
    const Oscillator<double> oscillator(i % 2 == 1 ? Model::long_channel : Model::orifice, p, constant_pressure(0.0),
                                        {p.radius, 6000, test::between(random, 1e-3, 10)});
    try {
      const FreeMotion motion(oscillator, pressure, test::between(random, 0.9, 3));
      const double distance = std::pow(10, test::between(random, -6, 0)) * (i % 4 < 2 ? 1 : -0.2);
      try_all(motion, motion.equilibrium() + distance);
      ++answered;
    } catch (const InvalidInput&) {
    }
  }
  EXPECT_GT(answered, 100);  // the others are refused
}

}  // namespace
}  // namespace turgor
