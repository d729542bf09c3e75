#include "turgor/integrate/dense_polynomial.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../support/seed.hpp"

namespace turgor {
namespace {

using test::between;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int depth = 8;

/// factor prod (x - roots[i]); a pair of complex roots where pairs[i] = (re, im).
struct Factors {
  double factor = 1;
  std::vector<double> roots{};
  std::vector<std::pair<double, double>> pairs{};

  [[nodiscard]] DensePolynomial<double> expanded() const {
    std::vector<double> c{factor};
    const auto times = [&](const std::vector<double>& by) {
      std::vector<double> product(c.size() + by.size() - 1, 0.0);
      for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < by.size(); ++j) product[i + j] += c[i] * by[j];
      }
      c = product;
    };
    for (const double root : roots) times({-root, 1});
    for (const auto& [re, im] : pairs) times({re * re + im * im, -2 * re, 1});
    DensePolynomial<double> all{};
    std::copy(c.begin(), c.end(), all.begin());
    return all;
  }
};

double size_of(const DensePolynomial<double>& c) {
  double sum = 0;
  for (const double x : c) sum += std::abs(x);
  return sum;
}

std::optional<double> first_zero(const DensePolynomial<double>& c, double noise = 0) {
  const auto part = first_fall<double>({0.0, 1.0, bernstein(c)}, noise, depth);
  if (!part) return std::nullopt;
  const double root = falling_zero(c, *part);
  EXPECT_GE(root, part->lo);
  EXPECT_LE(root, part->hi);
  return root;
}

DensePolynomial<double> random_polynomial(std::mt19937_64& random) {
  DensePolynomial<double> c;
  for (double& x : c) x = between(random, -1, 1);
  return c;
}

TEST(DensePolynomial, EvaluatesWithItsDerivative) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 100; ++i) {
    const auto c = random_polynomial(random);
    const double x = between(random, 0, 1);
    double value = 0;
    double slope = 0;
    for (std::size_t k = 0; k < c.size(); ++k) {
      value += c[k] * std::pow(x, static_cast<double>(k));
      if (k > 0) slope += static_cast<double>(k) * c[k] * std::pow(x, static_cast<double>(k) - 1);
    }
    EXPECT_NEAR(evaluate(c, x), value, 1e-14);
    EXPECT_NEAR(derivative(c, x), slope, 1e-13);
  }
}

// sum b_i binomial(7, i) x^i (1 - x)^(7 - i) is the same polynomial.
TEST(DensePolynomial, BernsteinFormIsTheSamePolynomial) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 100; ++i) {
    const auto c = random_polynomial(random);
    const auto b = bernstein(c);
    EXPECT_EQ(b.front(), c.front());
    const double x = between(random, 0, 1);
    double sum = 0;
    for (int k = 0; k <= dense_degree; ++k) {
      const double binomial = std::tgamma(8) / (std::tgamma(k + 1) * std::tgamma(8 - k));
      sum += b[static_cast<std::size_t>(k)] * binomial * std::pow(x, k) * std::pow(1 - x, dense_degree - k);
    }
    EXPECT_NEAR(sum, evaluate(c, x), 1e-13);
  }
}

// lower_bound() <= least Bernstein coefficient <= least value, all up to the rounding of eight terms.
TEST(DensePolynomial, BoundsLieBelow) {
  std::mt19937_64 random(test::random_seed());
  int useful = 0;
  for (int i = 0; i < 1000; ++i) {
    auto c = random_polynomial(random);
    c[0] = between(random, 0, 4);
    const auto b = bernstein(c);
    const double hull = *std::min_element(b.begin(), b.end());
    EXPECT_LE(lower_bound(c), hull + 1e-14);
    double least = c[0];
    for (int k = 0; k <= 100; ++k) least = std::min(least, evaluate(c, k / 100.0));
    EXPECT_LE(hull, least + 1e-14);
    useful += lower_bound(c) > 0 ? 1 : 0;
  }
  EXPECT_GT(useful, 100);
}

// One falling root among others outside [0, 1], of any multiplicity there.
TEST(FirstFall, FindsASingleRoot) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    Factors f;
    const double root = between(random, 1e-6, 1 - 1e-6);
    f.roots = {root};
    for (int k = 0; k < 3; ++k) f.roots.push_back(i % 2 == 0 ? between(random, -3, -0.1) : between(random, 1.1, 3));
    f.pairs = {{between(random, -1, 2), between(random, 0.3, 2)}};
    f.factor = Factors{1, f.roots, f.pairs}.expanded()[0] > 0 ? 1 : -1;
    const auto c = f.expanded();
    const auto found = first_zero(c);
    ASSERT_TRUE(found) << "root " << root;
    // as well conditioned as the polynomial is there
    EXPECT_NEAR(*found, root, 32 * epsilon * (size_of(c) / std::abs(derivative(c, root)) + root));
  }
}

// Two roots as close as a thirtieth of the shortest part that is searched: the first falls, the second rises. The
// double root between them touches from above and is none.
TEST(FirstFall, FindsTheFirstOfTwoCloseRoots) {
  std::mt19937_64 random(test::random_seed());
  int found_close = 0;
  int close = 0;
  for (int i = 0; i < 2000; ++i) {
    const double gap = std::pow(10.0, between(random, -4, -1));
    const double middle = between(random, 0.1, 0.9);
    Factors f;
    f.roots = {middle - gap / 2, middle + gap / 2};
    f.pairs = {{between(random, -1, 2), between(random, 0.5, 2)}, {between(random, -1, 2), between(random, 0.5, 2)}};
    const auto c = f.expanded();
    const auto found = first_zero(c);
    if (gap > 1.0 / (1 << depth)) {  // what the search promises
      ASSERT_TRUE(found) << "gap " << gap << " at " << middle;
    } else {
      ++close;
      found_close += found ? 1 : 0;
    }
    if (found) {
      EXPECT_NEAR(*found, f.roots[0], 64 * epsilon * (size_of(c) / std::abs(derivative(c, f.roots[0])) + 1));
    }
    f.roots = {middle, middle};
    auto touching = f.expanded();
    touching[0] += 1e-14 * size_of(touching);
    EXPECT_FALSE(first_zero(touching)) << "double root at " << middle;
    touching[0] -= 1e-12;
    EXPECT_FALSE(first_zero(touching, 1e-11)) << "dips into the noise at " << middle;
  }
  // Narrower dips are found where subdivision happens to cut them.
  EXPECT_GT(found_close, close / 100);
}

// As after an event: exactly zero at the beginning, then positive, then the next root.
TEST(FirstFall, StartingAtExactlyZeroFindsTheNextRoot) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 2000; ++i) {
    const double root = between(random, 1e-3, 0.999);
    Factors f;
    f.factor = -1;
    f.roots = {0, root};
    f.pairs = {{between(random, -1, 2), between(random, 0.3, 2)}, {between(random, -1, 2), between(random, 0.3, 2)}};
    const auto c = f.expanded();
    ASSERT_EQ(c[0], 0.0);
    ASSERT_GT(c[1], 0.0);
    const auto found = first_zero(c);
    ASSERT_TRUE(found) << "root " << root;
    EXPECT_NEAR(*found, root, 64 * epsilon * (size_of(c) / std::abs(derivative(c, root)) + 1));
    f.roots[1] = 1 + root;
    EXPECT_FALSE(first_zero(f.expanded()));
  }
}

// Nothing where there is nothing, whatever the bounds say.
TEST(FirstFall, FindsNothingInAPositivePolynomial) {
  std::mt19937_64 random(test::random_seed());
  int doubtful = 0;
  for (int i = 0; i < 2000; ++i) {
    Factors f;
    for (int k = 0; k < 3; ++k) f.pairs.emplace_back(between(random, 0, 1), between(random, 0.02, 0.5));
    const auto c = f.expanded();
    const auto b = bernstein(c);
    doubtful += *std::min_element(b.begin(), b.end()) < 0 ? 1 : 0;
    EXPECT_FALSE(first_zero(c));
  }
  EXPECT_GT(doubtful, 200);  // else the search was not tried
}

// Negative all the way from an exact zero: it falls at once.
TEST(FirstFall, FallsAtOnce) {
  const DensePolynomial<double> c{0, -1, 0.25};
  const auto found = first_zero(c);
  ASSERT_TRUE(found);
  EXPECT_LT(*found, 1e-15);
}

}  // namespace
}  // namespace turgor
