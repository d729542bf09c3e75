#include "turgor/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "samples.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

class EveryMaterial : public testing::TestWithParam<MaterialEntry> {
 protected:
  Material<double> material = make_material(GetParam().name, sample_constants(GetParam().name));
};

// Complex-step differentiation has no cancellation, so it is exact to rounding: 1e-13 covers a few operations.
TEST_P(EveryMaterial, DerivativesAgreeWithTheComplexStep) {
  constexpr double h = 1e-40;
  for (const double stretch : {0.4, 0.9, 1.0, 1.0001, 1.3, 2.0, 3.7, 6.5}) {
    if (stretch > 0.98 * stretch_limit(material)) continue;
    const Jet<std::complex<double>> complex = strain_energy(material, std::complex<double>(stretch, h));
    const Jet<double> real = strain_energy(material, stretch);
    const double scale = std::abs(real.second) + std::abs(real.first);
    EXPECT_NEAR(real.first, complex.value.imag() / h, 1e-13 * scale) << "at stretch " << stretch;
    EXPECT_NEAR(real.second, complex.first.imag() / h, 1e-12 * scale) << "at stretch " << stretch;
  }
}

TEST_P(EveryMaterial, IsFreeOfEnergyAndStressWhenUnstretched) {
  const Jet<double> w = strain_energy(material, 1.0);
  EXPECT_EQ(w.value, 0.0);
  EXPECT_EQ(w.first, 0.0);
  EXPECT_GT(w.second, 0.0);
}

TEST_P(EveryMaterial, StoresEnergyAndPullsBackWhenStretched) {
  for (const double stretch : {0.7, 1.2, 2.0, 4.0}) {
    const Jet<double> w = strain_energy(material, stretch);
    EXPECT_GT(w.value, 0.0) << "at stretch " << stretch;
    EXPECT_GT(w.first * (stretch - 1), 0.0) << "at stretch " << stretch;
  }
}

// With W written as W(1) + W''(1) e^2/2 + O(e^3): the small-strain energy keeps its digits only without cancellation.
TEST_P(EveryMaterial, KeepsItsDigitsAtSmallStrain) {
  const double e = 1e-7;
  const Jet<double> w = strain_energy(material, 1 + e);
  const double stiffness = strain_energy(material, 1.0).second;
  EXPECT_NEAR(w.value / (stiffness * e * e / 2), 1.0, 1e-5);  // the O(e) remainder, with its factor of up to ten
  EXPECT_NEAR(w.first / (stiffness * e), 1.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMaterial, testing::ValuesIn(catalogue()), [](const auto& test) {
  std::string name(test.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// Small-strain shear moduli as the literature gives them: equibiaxial W''(1) = 12 mu for an incompressible solid.
TEST(Material, HasTheShearModulusOfItsConstants) {
  const auto modulus = [](std::string_view name) {
    return strain_energy(make_material(name, sample_constants(name)), 1.0).second / 12;
  };
  EXPECT_NEAR(modulus("mooney-rivlin"), 2 * 1.65e6, 1e-6);
  EXPECT_NEAR(modulus("neo-hookean"), 4e5, 1e-6);
  EXPECT_NEAR(modulus("yeoh"), 2 * 2e5, 1e-6);
  EXPECT_NEAR(modulus("gent"), 4e5, 1e-6);
  EXPECT_NEAR(modulus("gent-gent"), 3e5 + 2 * 1.5e5 / 3, 1e-6);
  EXPECT_NEAR(modulus("ogden"), (6.3e5 * 1.3 + 1.2e3 * 5 + 1e4 * 2) / 2, 1e-6);
  EXPECT_NEAR(modulus("fung"), 5e4, 1e-6);
}

// Limits in which one material becomes another.
TEST(Material, ReducesToNeoHookeanInItsLimits) {
  const Material<double> neo_hookean = NeoHookean<double>{4e5};
  const std::vector<Material<double>> limits{Gent<double>{4e5, 1e12},      GentGent<double>{4e5, 1e12, 0.0},
                                             Yeoh<double>{2e5, 0, 0},      Fung<double>{4e5, 1e-12},
                                             Ogden<double>{{4e5}, {2.0}},  MooneyRivlin<double>{2e5, 0},
                                             ArrudaBoyce<double>{4e5, 1e6}};
  for (const double stretch : {0.8, 1.5, 3.0}) {
    const Jet<double> expected = strain_energy(neo_hookean, stretch);
    for (const auto& material : limits) {
      const Jet<double> found = strain_energy(material, stretch);
      EXPECT_NEAR(found.value / expected.value, 1, 1e-9);
      EXPECT_NEAR(found.first / expected.first, 1, 1e-9);
      EXPECT_NEAR(found.second / expected.second, 1, 1e-9);
    }
  }
}

TEST(Material, GentLocksWhereTheInvariantReachesItsLimit) {
  for (const double jm : {0.01, 1.0, 97.2, 1e4}) {
    const Gent<double> gent{1e5, jm};
    const double limit = gent.stretch_limit();
    EXPECT_NEAR(2 * limit * limit + std::pow(limit, -4) - 3, jm, 1e-12 * (1 + jm));
    EXPECT_TRUE(std::isfinite(gent.energy(limit * (1 - 1e-9)).first));
    EXPECT_TRUE(std::isinf(gent.energy(limit * (1 + 1e-9)).first));
  }
}

TEST(Material, RefusesConstantsThatCannotBe) {
  const auto message = [](std::string_view name, const MaterialValues& values) {
    try {
      (void)make_material(name, values);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(message("rubber", {}).find("mooney-rivlin"), std::string::npos);
  EXPECT_NE(message("gent", {{"mu", {1.0}}}).find("material.jm"), std::string::npos);
  EXPECT_NE(message("gent", {{"mu", {-1.0}}, {"jm", {2.0}}}).find("positive"), std::string::npos);
  EXPECT_NE(message("mooney-rivlin", {{"s1", {-1.0}}, {"s2", {0.5}}}).find("unstable"), std::string::npos);
  EXPECT_NE(message("mooney-rivlin", {{"s1", {NAN}}, {"s2", {0.5}}}).find("finite"), std::string::npos);
  EXPECT_NE(message("ogden", {{"mu", {1.0, 2.0}}, {"alpha", {1.0}}}).find("values"), std::string::npos);
  EXPECT_NE(message("ogden", {{"mu", {1.0}}, {"alpha", {-1.0}}}).find("unstable"), std::string::npos);
}

}  // namespace
}  // namespace turgor
