// Walls that are given by a table of their stress: against closed materials, and by themselves.

#include "turgor/material/tabulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/balloons.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/material/material.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

const Material<double> rubber = MooneyRivlin<double>{1.5e6, 1.5e5};

/// The principal nominal stress of a closed material in equal biaxial stretch: dW/dl1 at l1 = l2.
double nominal_stress(const Material<double>& material, double stretch) {
  return strain_energy(material, stretch, stretch).d1;
}

/// So many intervals below 1, from `least` on, and above it.
std::vector<double> stretches(double least, double greatest, int below, int above) {
  std::vector<double> all;
  for (int i = 0; i < below; ++i) all.push_back(least + (1 - least) * i / below);
  for (int i = 0; i <= above; ++i) all.push_back(1 + (greatest - 1) * i / above);
  return all;
}

Tabulated<double> table_of(const Material<double>& material, const std::vector<double>& at) {
  std::vector<double> stress;
  for (const double stretch : at) stress.push_back(stretch == 1 ? 0 : nominal_stress(material, stretch));
  return tabulated(at, stress);
}

// Half a thin sphere is held by p pi r^2 = 2 pi r d (s lambda), the true stress s lambda on the wall's present section
// of thickness d = d0/lambda^2: p = 2 s d0/(r0 lambda^2). No energy is in this balance, so it decides about the factor
// two.
TEST(StressTable, HoldsASphereAsTheBalanceOfForcesSays) {
  Parameters<double> p = test::paper_balloon<double>(0.03, 0);
  const auto at = stretches(0.8, 3, 4, 20);
  p.material = table_of(rubber, at);
  for (const double stretch : at) {
    const double expected = 2 * nominal_stress(rubber, stretch) * p.thickness / (p.radius * stretch * stretch);
    EXPECT_NEAR(static_pressure(p, stretch).value, expected, 1e-12 * std::abs(expected)) << stretch;
  }
  EXPECT_NEAR(strain_energy(p.material, 2.0).first, strain_energy(rubber, 2.0).first, 1e-9 * 1.5e6);
}

struct Errors {
  double energy = 0;
  double stress = 0;
  double slope = 0;
  double curvature = 0;
};

/// Greatest ones from 0.8 to 3, of a table of `n` intervals below 1 and 5 n above.
Errors errors_of(const Material<double>& material, int n) {
  const Tabulated<double> table = table_of(material, stretches(0.8, 3, n, 5 * n));
  Errors worst;
  constexpr double h = 1e-40;
  for (int i = 0; i < 5000; ++i) {  // at the end itself the straight line begins
    const double stretch = 0.8 + 2.2 * i / 5000;
    const Jet<double> exact = strain_energy(material, stretch);
    const Jet<double> found = table.energy(stretch);
    const auto third = [&](const auto& of) { return of(std::complex<double>(stretch, h)).second.imag() / h; };
    const double bend = third([&](const auto& x) { return strain_energy(material, x); });
    worst.energy = std::max(worst.energy, std::abs(found.value - exact.value));
    worst.stress = std::max(worst.stress, std::abs(found.first - exact.first));
    worst.slope = std::max(worst.slope, std::abs(found.second - exact.second));
    worst.curvature = std::max(worst.curvature, std::abs(third([&](const auto& x) { return table.energy(x); }) - bend));
  }
  return worst;
}

// Orders of a cubic spline: 4 for the stress and its integral, 3 for its slope, 2 for its curvature; the slack is for
// coarse tables, whose next orders are not yet small.
TEST(StressTable, ConvergesInTheOrdersOfACubicSpline) {
  for (const Material<double>& material : {rubber, Material<double>(Gent<double>{4e5, 30})}) {
    const Errors coarse = errors_of(material, 16);
    const Errors fine = errors_of(material, 32);
    EXPECT_GT(std::log2(coarse.energy / fine.energy), 3.8);
    EXPECT_GT(std::log2(coarse.stress / fine.stress), 3.8);
    EXPECT_GT(std::log2(coarse.slope / fine.slope), 2.8);
    EXPECT_GT(std::log2(coarse.curvature / fine.curvature), 1.8);
    EXPECT_LT(fine.stress, 1e-6 * strain_energy(material, 1.0).second);
  }
}

/// A polynomial that a cubic spline without knots of its own at the ends has to reproduce.
template <class T>
T cubic(const T& stretch) {
  const T x = stretch - 1;
  return x * (T(7) + x * (T(-5) + x * T(2)));
}
template <class T>
T integral_of_cubic(const T& stretch) {
  const T x = stretch - 1;
  return x * x * (T(7) / 2 + x * (T(-5) / 3 + x / T(2)));
}

// Whatever the points are. Rounding: some ten operations, and a little more where the slope has been made from
// differences; in long double its own.
template <class T>
void expect_cubic(const std::vector<T>& stretch) {
  std::vector<T> stress;
  for (const T& l : stretch) stress.push_back(cubic(l));
  const StressTable<T> table(stretch, stress);
  const T rounding = 1000 * std::numeric_limits<T>::epsilon();
  for (T l = stretch.front(); l < stretch.back(); l += (stretch.back() - stretch.front()) / 97) {
    const Jet<T> w = table.energy(l);
    const T x = l - 1;
    EXPECT_LT(std::abs(w.value - 2 * integral_of_cubic(l)), rounding) << static_cast<double>(l);
    EXPECT_LT(std::abs(w.first - 2 * cubic(l)), rounding) << static_cast<double>(l);
    EXPECT_LT(std::abs(w.second - 2 * (T(7) - T(10) * x + T(6) * x * x)), 10 * rounding) << static_cast<double>(l);
  }
}

TEST(StressTable, ReproducesCubics) {
  expect_cubic<double>({1, 1.25, 1.5, 2});
  expect_cubic<double>({0.25, 0.5, 1, 1.125});
  expect_cubic<double>({0.5, 0.75, 0.875, 1, 1.0625, 1.5, 1.75, 2, 3});
  expect_cubic<long double>({0.5L, 0.7L, 0.9L, 1.0L, 1.1L, 1.5L, 1.7L, 2.0L});
}

const std::vector<double> uneven{0.7, 0.85, 1, 1.05, 1.3, 1.4, 2, 2.1, 2.6};
const std::vector<double> bumpy{-4e5, -1e5, 0, 1e5, 3e5, 2.5e5, 1.5e5, 2e5, 6e5};

// The step control counts on it: within a table the force has two continuous derivatives, beyond it one.
TEST(StressTable, IsSmoothThroughItsPoints) {
  const Tabulated<double> table = tabulated(uneven, bumpy);
  constexpr double h = 1e-40;
  const auto bend = [&](double l) { return table.energy(std::complex<double>(l, h)).second.imag() / h; };
  for (std::size_t i = 0; i < uneven.size(); ++i) {
    const Jet<double> after = table.energy(uneven[i]);
    const double just_below = std::nextafter(uneven[i], 0.0);
    const Jet<double> before = table.energy(just_below);
    EXPECT_NEAR(after.first, 2 * bumpy[i], 1e-9) << i;  // of 1e6
    EXPECT_NEAR(before.first, after.first, 1e-7) << i;
    EXPECT_NEAR(before.value, after.value, 1e-7) << i;
    EXPECT_NEAR(before.second, after.second, 1e-6) << i;
    const bool end = i == 0 || i + 1 == uneven.size();
    EXPECT_EQ(std::abs(bend(just_below) - bend(uneven[i])) < 1e-5, !end) << i;  // of 1e8
  }
}

// Simpson's rule is exact for cubics, so between neighbouring points the energy's difference is the work of the stress;
// and the slope is that of finite differences, whose error of a cubic is its third derivative times h^2.
TEST(StressTable, HasTheEnergyOfItsStressAndTheSlopeOfIt) {
  const Tabulated<double> table = tabulated(uneven, bumpy);
  std::vector<double> ends = uneven;
  ends.insert(ends.begin(), 0.3);
  ends.push_back(5);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double a = ends[i];
    const double b = ends[i + 1];
    const double middle = (a + b) / 2;
    const double work = (b - a) / 6 * (table.energy(a).first + 4 * table.energy(middle).first + table.energy(b).first);
    EXPECT_NEAR(table.energy(b).value - table.energy(a).value, work, 1e-9 * 1e6) << a;
    const double h = 1e-5;
    const double slope = (table.energy(middle + h).first - table.energy(middle - h).first) / (2 * h);
    EXPECT_NEAR(table.energy(middle).second, slope, 1e-8 * 1e7) << middle;
  }
  EXPECT_EQ(table.energy(1.0).value, 0);
  EXPECT_EQ(table.energy(1.0).first, 0);
}

// On both sides of 1, whatever lies beyond: W = W'' e^2/2, of which 1e-8 is the next term.
TEST(StressTable, KeepsTheDigitsOfSmallStrains) {
  const Tabulated<double> table = tabulated(uneven, bumpy);
  const double stiffness = table.energy(1.0).second;
  for (const double stretch : {1 - 1e-9, 1 + 1e-9}) {
    const double e = stretch - 1;
    EXPECT_NEAR(table.energy(stretch).value / (stiffness * e * e / 2), 1, 1e-7);
    EXPECT_NEAR(table.energy(stretch).first / (stiffness * e), 1, 1e-7);
  }
}

TEST(StressTable, GoesOnAlongStraightLines) {
  const Tabulated<double> table = tabulated(uneven, bumpy);
  for (const auto& [end, out] :
       {std::pair{0.7, 0.01}, std::pair{0.7, 0.69}, std::pair{2.6, 2.7}, std::pair{2.6, 100.0}}) {
    const Jet<double> at_end = table.energy(end);
    const Jet<double> w = table.energy(out);
    EXPECT_EQ(w.second, at_end.second) << out;
    EXPECT_NEAR(w.first, at_end.first + (out - end) * at_end.second, 1e-14 * std::abs(w.first) + 1e-9) << out;
    const double mean = (w.first + at_end.first) / 2;
    EXPECT_NEAR(w.value, at_end.value + (out - end) * mean, 1e-14 * std::abs(w.value) + 1e-8) << out;
  }
  // A table that begins at stretch 1 is as stiff in compression as it is there.
  const Tabulated<double> tension = table_of(rubber, stretches(1, 2, 0, 20));
  EXPECT_NEAR(tension.energy(0.99).first, -0.01 * tension.energy(1.0).second, 1e-6);
  EXPECT_EQ(known_stretches(Material<double>(tension)).least, 1);
  EXPECT_EQ(known_stretches(Material<double>(tension)).greatest, 2);
  EXPECT_EQ(known_stretches(rubber).greatest, std::numeric_limits<double>::infinity());
}

TEST(StressTable, MayFall) {
  Parameters<double> p = test::paper_balloon<double>(0.03, 0);
  p.material = tabulated(uneven, bumpy);
  int maxima = 0;
  int minima = 0;
  for (const LimitPoint& point : limit_points(p)) ++(point.maximum ? maxima : minima);
  EXPECT_GE(maxima, 1);
  EXPECT_GE(minima, 1);
}

// Where the pressure is greatest depends on the slope: third order, 1e-6 with 80 points.
TEST(StressTable, HasTheLimitPointsOfTheClosedMaterial) {
  Parameters<double> p = test::paper_balloon<double>(0.03, 0);
  const auto exact = limit_points(p);
  p.material = table_of(rubber, stretches(0.8, 5, 4, 80));
  const auto found = limit_points(p);
  ASSERT_GE(exact.size(), 2U);
  ASSERT_GE(found.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found[i].maximum, exact[i].maximum);
    EXPECT_NEAR(found[i].stretch, exact[i].stretch, 1e-4);
    EXPECT_NEAR(found[i].pressure, exact[i].pressure, 1e-6 * exact[i].pressure);
  }
}

TEST(StressTable, IsSharedByCopiesAndEqualToAnotherOfTheSamePoints) {
  const Tabulated<double> table = tabulated(uneven, bumpy);
  const Tabulated<double> copy = table;  // NOLINT(performance-unnecessary-copy-initialization): what is tested
  EXPECT_EQ(copy.tables[0].get(), table.tables[0].get());
  EXPECT_EQ(copy, table);
  EXPECT_EQ(tabulated(uneven, bumpy), table);
  auto other = bumpy;
  other.back() += 1;
  EXPECT_NE(tabulated(uneven, other), table);
}

TEST(StressTable, RefusesWhatIsNoTable) {
  const auto message = [](const std::vector<double>& stretch, const std::vector<double>& stress) {
    try {
      (void)tabulated(stretch, stress);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto says = [&](const std::vector<double>& stretch, const std::vector<double>& stress,
                        const std::vector<std::string>& words) {
    const std::string text = message(stretch, stress);
    for (const auto& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in " << text;
  };
  says({1, 2, 3}, {0, 1, 2}, {"material.table.stretch", "3 points", "four"});
  says({1, 2, 3, 4}, {0, 1, 2}, {"material.table.stress", "3 values", "has 4"});
  says({1, 2, 2, 4}, {0, 1, 2, 3}, {"material.table.stretch[2]", "not above 2", "increase strictly"});
  says({1, 2, NAN, 4}, {0, 1, 2, 3}, {"material.table.stretch[2]", "nan"});
  says({0, 1, 2, 4}, {0, 0, 2, 3}, {"material.table.stretch[0]", "> 0"});
  says({1, 2, 3, 4}, {0, 1, 2, INFINITY}, {"material.table.stress[3]", "finite"});
  says({1, 2, 3, 4}, {5, 6, 7, 8}, {"material.table.stress[0]", "5 Pa", "must be 0", "subtract"});
  says({1.1, 2, 3, 4}, {0, 1, 2, 3}, {"material.table.stretch", "no point at stretch 1", "not a strain"});
  says({0.1, 0.2, 0.3, 1}, {-3, -2, -1, 0}, {"material.table.stretch", "ends at stretch 1"});
  says({1, 2, 3, 4}, {0, 1e308, -1e308, 1e308}, {"material.table.stress", "numbers can hold"});
  EXPECT_EQ(message({1, 2, 3, 4}, {0, 1, 2, 3}), "accepted");
}

TEST(StressTable, DoesNotPretendToKnowTwoStretches) {
  const Material<double> material = table_of(rubber, stretches(1, 2, 0, 20));
  try {
    (void)strain_energy(material, 1.2, 1.1);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("material.model"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace turgor
