#include "turgor/material/biaxial.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "samples.hpp"

namespace turgor {
namespace {

using Stretches = std::array<double, 2>;

const std::vector<Stretches> places{{1.0, 1.0},   {1.0, 1.3},  {0.9, 1.1}, {1.0001, 0.9998}, {0.6, 1.9},
                                    {1.7, 0.5},   {2.0, 2.0},  {3.1, 1.2}, {1.1, 4.0},       {4.0, 3.5},
                                    {0.45, 0.95}, {2.6, 0.45}, {0.8, 0.8}};

class EveryMaterialInTwoDirections : public testing::TestWithParam<MaterialEntry> {
 protected:
  Material<double> material = make_material(GetParam().name, sample_constants(GetParam().name));
};

/// The energies as their authors write them, in long double.
long double textbook_energy(std::string_view name, long double l1, long double l2) {
  const MaterialValues values = sample_constants(name);
  const auto c = [&](std::string_view key, std::size_t i = 0) -> long double { return values.find(key)->second[i]; };
  const long double l3 = 1 / (l1 * l2);
  const long double i1 = l1 * l1 + l2 * l2 + l3 * l3;
  const long double i2 = 1 / (l1 * l1) + 1 / (l2 * l2) + 1 / (l3 * l3);
  const auto gent = [&] { return -c("mu") * c("jm") / 2 * std::log(1 - (i1 - 3) / c("jm")); };
  if (name == "mooney-rivlin") return c("s1") * (i1 - 3) + c("s2") * (i2 - 3);
  if (name == "neo-hookean") return c("mu") / 2 * (i1 - 3);
  if (name == "yeoh") return c("c1") * (i1 - 3) + c("c2") * std::pow(i1 - 3, 2.0L) + c("c3") * std::pow(i1 - 3, 3.0L);
  if (name == "gent") return gent();
  if (name == "gent-gent") return gent() + c("c2") * std::log(i2 / 3);
  if (name == "fung") return c("mu") / (2 * c("b")) * (std::exp(c("b") * (i1 - 3)) - 1);
  long double sum = 0;
  if (name == "ogden") {
    for (std::size_t p = 0; p < 3; ++p) {
      const long double a = c("alpha", p);
      sum += c("mu", p) / a * (std::pow(l1, a) + std::pow(l2, a) + std::pow(l3, a) - 3);
    }
    return sum;
  }
  const std::array<long double, 5> series{1.0L / 2, 1.0L / 20, 11.0L / 1050, 19.0L / 7000, 519.0L / 673750};
  for (int i = 1; i <= 5; ++i) {
    sum += c("mu") * series[static_cast<std::size_t>(i - 1)] * std::pow(c("lambda_m"), 2.0L - 2 * i) *
           (std::pow(i1, static_cast<long double>(i)) - std::pow(3.0L, static_cast<long double>(i)));
  }
  return sum;
}

// 2e-15 covers some ten roundings. The textbook form loses digits by cancellation from I1 = 3 on, and its long doubles
// have 3.3 digits more.
TEST_P(EveryMaterialInTwoDirections, HasTheEnergyOfItsAuthors) {
  for (const auto& [l1, l2] : places) {
    const double found = strain_energy(material, l1, l2).value;
    if (std::isinf(found)) continue;
    const auto expected = static_cast<double>(textbook_energy(GetParam().name, l1, l2));
    EXPECT_NEAR(found, expected, 5e-15 * expected + 1e-17 * shear_modulus(material)) << l1 << ", " << l2;
  }
}

// Complex-step differentiation has no cancellation; 1e-13 covers a few operations.
TEST_P(EveryMaterialInTwoDirections, DerivativesAgreeWithTheComplexStep) {
  using Complex = std::complex<double>;
  constexpr double h = 1e-40;
  for (const auto& [l1, l2] : places) {
    const BiaxialJet<double> w = strain_energy(material, l1, l2);
    if (std::isinf(w.value)) continue;
    const BiaxialJet<Complex> along1 = strain_energy(material, Complex(l1, h), Complex(l2));
    const BiaxialJet<Complex> along2 = strain_energy(material, Complex(l1), Complex(l2, h));
    const double tension = 1e-13 * (std::abs(w.d1) + std::abs(w.d2) + w.d11 + w.d22);
    EXPECT_NEAR(w.d1, along1.value.imag() / h, tension) << l1 << ", " << l2;
    EXPECT_NEAR(w.d2, along2.value.imag() / h, tension) << l1 << ", " << l2;
    const double stiffness = 1e-12 * (std::abs(w.d11) + std::abs(w.d22));
    EXPECT_NEAR(w.d11, along1.d1.imag() / h, stiffness) << l1 << ", " << l2;
    EXPECT_NEAR(w.d12, along1.d2.imag() / h, stiffness) << l1 << ", " << l2;
    EXPECT_NEAR(w.d12, along2.d1.imag() / h, stiffness) << l1 << ", " << l2;
    EXPECT_NEAR(w.d22, along2.d2.imag() / h, stiffness) << l1 << ", " << l2;
  }
}

TEST_P(EveryMaterialInTwoDirections, IsTheEquibiaxialOneOnTheDiagonal) {
  for (const double l : {0.5, 0.9, 1.0, 1.00001, 1.4, 2.7, 5.0}) {
    const Jet<double> one = strain_energy(material, l);
    const BiaxialJet<double> two = strain_energy(material, l, l);
    if (std::isinf(one.value)) {
      EXPECT_TRUE(std::isinf(two.value));
      continue;
    }
    const double rounding = 1e-13 * (std::abs(one.first) + one.second);
    EXPECT_NEAR(two.value, one.value, 1e-13 * one.value + 1e-17 * one.second) << l;
    EXPECT_NEAR(two.d1 + two.d2, one.first, rounding) << l;
    EXPECT_NEAR(two.d11 + 2 * two.d12 + two.d22, one.second, 10 * rounding) << l;
  }
}

TEST_P(EveryMaterialInTwoDirections, HasNoPreferredDirection) {
  for (const auto& [l1, l2] : places) {
    const BiaxialJet<double> w = strain_energy(material, l1, l2);
    const BiaxialJet<double> turned = strain_energy(material, l2, l1);
    if (std::isinf(w.value)) continue;
    const double rounding = 1e-14 * (w.value + std::abs(w.d11) + std::abs(w.d22));
    EXPECT_NEAR(w.value, turned.value, rounding);
    EXPECT_NEAR(w.d1, turned.d2, rounding);
    EXPECT_NEAR(w.d11, turned.d22, rounding);
    EXPECT_NEAR(w.d12, turned.d12, rounding);
  }
}

// An incompressible sheet at small strain: E/(1 - nu^2) = 4 mu along, half of it across.
TEST_P(EveryMaterialInTwoDirections, IsAnIncompressibleLinearSheetAtSmallStrain) {
  const BiaxialJet<double> w = strain_energy(material, 1.0, 1.0);
  const double mu = shear_modulus(material);
  EXPECT_EQ(w.value, 0.0);
  EXPECT_EQ(w.d1, 0.0);
  EXPECT_EQ(w.d2, 0.0);
  EXPECT_NEAR(w.d11 / mu, 4.0, 1e-13);
  EXPECT_NEAR(w.d12 / mu, 2.0, 1e-13);
  EXPECT_NEAR(w.d22 / mu, 4.0, 1e-13);
  // The remainder is of the order of the strain, times at most ten.
  const double e = 1e-7;
  const BiaxialJet<double> strained = strain_energy(material, 1 + e, 1 - 2 * e);
  EXPECT_NEAR(strained.value / (mu * e * e), 2 * (1 + 4 - 2), 1e-5);
  EXPECT_NEAR(strained.d1 / (mu * e), 4 - 2 * 2, 1e-5);
}

// E = 3 mu = 9.9 MPa, nu = 1/2, d = 3 mm: 9.9e6 * 2.7e-8/9.
TEST(BendingStiffness, IsThatOfAnIncompressiblePlate) {
  EXPECT_NEAR(bending_stiffness(Material<double>{MooneyRivlin<double>{1.5e6, 1.5e5}}, 3e-3), 0.0297, 1e-15);
}

// Far beyond every limit: infinite throughout or finite throughout, never NaN.
TEST_P(EveryMaterialInTwoDirections, IsInfiniteAndNotNanBeyondItsLimit) {
  for (const auto& [l1, l2] :
       std::vector<Stretches>{{50, 1}, {1, 50}, {30, 30}, {1e-3, 1}, {1e60, 1e-60}, {1e-90, 1}}) {
    const BiaxialJet<double> w = strain_energy(material, l1, l2);
    const std::array<double, 6> all{w.value, w.d1, w.d2, w.d11, w.d12, w.d22};
    for (const double number : all) {
      EXPECT_FALSE(std::isnan(number)) << l1 << ", " << l2;
      EXPECT_EQ(std::isfinite(number), std::isfinite(w.value)) << l1 << ", " << l2;
    }
    if (std::isfinite(stretch_limit(material))) {
      EXPECT_TRUE(std::isinf(w.value)) << l1 << ", " << l2;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMaterialInTwoDirections, testing::ValuesIn(materials_of_two_stretches()),
                         [](const auto& test) {
                           std::string name(test.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace turgor
