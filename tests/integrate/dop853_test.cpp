#include "turgor/integrate/dop853.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "turgor/integrate/dense_polynomial.hpp"

namespace turgor {
namespace {

/// y1' = y2, y2' = -y1^3 - t y2: nonlinear, not autonomous; no closed solution.
template <class T>
struct Nonlinear {
  using Value = T;
  static constexpr int size = 2;
  using State = Eigen::Matrix<T, 2, 1>;

  [[nodiscard]] State rate(const T& t, const State& y) const { return {y[1], -y[0] * y[0] * y[0] - t * y[1]}; }
  [[nodiscard]] static State start() { return {T(1), T(0.5L)}; }
};

template <class T>
typename Nonlinear<T>::State solve(const T& end, int n) {
  const Nonlinear<T> flow;
  auto y = flow.start();
  const T h = end / static_cast<T>(n);
  for (int i = 0; i < n; ++i) {
    const T t = static_cast<T>(i) * h;
    y = dop853_step(flow, t, y, flow.rate(t, y), h).end;
  }
  return y;
}

template <class T>
struct Dense {
  Dop853Step<T, 2> step;
  DenseState<typename Nonlinear<T>::State> polynomial;

  explicit Dense(const T& h) {
    const Nonlinear<T> flow;
    const auto y = flow.start();
    step = dop853_step(flow, T(0), y, flow.rate(T(0), y), h);
    polynomial = dense_output(flow, T(0), y, h, step);
  }
  [[nodiscard]] DensePolynomial<T> component(Eigen::Index i) const {
    DensePolynomial<T> c;
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = polynomial[k][i];
    return c;
  }
  [[nodiscard]] typename Nonlinear<T>::State at(const T& theta) const {
    return {evaluate(component(0), theta), evaluate(component(1), theta)};
  }
};

template <class Error>
auto slope(const Error& error, int n) {
  return static_cast<double>(std::log2(error(n) / error(2 * n)));
}

template <class T>
class Dop853Of : public testing::Test {
 protected:
  static constexpr T epsilon = std::numeric_limits<T>::epsilon();
  /// Steps over the unit interval: so many that the leading error term rules, so few that rounding does not.
  static constexpr int coarse = sizeof(T) > sizeof(double) ? 8 : 4;
};
using Types = testing::Types<double, long double>;
TYPED_TEST_SUITE(Dop853Of, Types);

// The coefficients are of size 40 and there are 12 of them: a few dozen roundings. In long double that is 1e-17, so the
// published digits are right to that; a wrong digit in the last place of any of them would show.
TYPED_TEST(Dop853Of, RowsSumToTheirTimes) {
  using T = TypeParam;
  using Method = Dop853<T>;
  for (std::size_t i = 0; i < Method::all_stages; ++i) {
    T sum(0);
    for (const T& a : Method::a[i]) sum += a;
    EXPECT_NEAR(static_cast<double>(sum - Method::time[i]), 0, static_cast<double>(50 * this->epsilon)) << "row " << i;
    for (std::size_t j = i; j < Method::all_stages; ++j) EXPECT_EQ(Method::a[i][j], T(0)) << "not explicit";
  }
}

// Quadrature conditions of order 8: sum b c^k = 1/(k + 1) for k < 8, and not beyond. The embedded methods of order 5
// and 3 share them up to their order.
TYPED_TEST(Dop853Of, WeightsIntegratePowers) {
  using T = TypeParam;
  using Method = Dop853<T>;
  const auto moment = [](const auto& weights, int k) {
    T sum(0);
    for (std::size_t j = 0; j < Method::stages; ++j) {
      T power(1);
      for (int i = 0; i < k; ++i) power *= Method::time[j];
      sum += weights[j] * power;
    }
    return static_cast<double>(sum);
  };
  const auto& b = Method::a[Method::stages];
  const double rounding = static_cast<double>(50 * this->epsilon);
  for (int k = 0; k < 8; ++k) {
    EXPECT_NEAR(moment(b, k), static_cast<double>(1 / static_cast<long double>(k + 1)), std::max(rounding, 1e-16));
    T sum(0);  // the same to all digits of T
    for (std::size_t j = 0; j < Method::stages; ++j) {
      T power(1);
      for (int i = 0; i < k; ++i) power *= Method::time[j];
      sum += b[j] * power;
    }
    EXPECT_NEAR(static_cast<double>(sum - 1 / static_cast<T>(k + 1)), 0, rounding) << "k = " << k;
  }
  EXPECT_GT(std::abs(moment(b, 8) - 1.0 / 9), 1e-7);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(moment(Method::error5, k), 0, rounding) << "k = " << k;
  EXPECT_GT(std::abs(moment(Method::error5, 5)), 1e-7);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(moment(Method::weights3, k), 1.0 / (k + 1), std::max(rounding, 1e-16));
  EXPECT_GT(std::abs(moment(Method::weights3, 3) - 1.0 / 4), 1e-4);
}

// Half an order of slack, for the next term of the error.
TYPED_TEST(Dop853Of, HasOrderEight) {
  using T = TypeParam;
  const auto exact = solve<long double>(1, 400);
  const auto error = [&](int n) { return (solve<T>(T(1), n).template cast<long double>() - exact).norm(); };
  EXPECT_NEAR(slope(error, this->coarse), 8, 0.5);
  EXPECT_NEAR(slope(error, 3 * this->coarse / 2), 8, 0.5);
}

// err = |err5|^2/sqrt(|err5|^2 + 0.01 |err3|^2) is h^12/h^4 where the steps are short: a local error of order 7.
TYPED_TEST(Dop853Of, ErrorEstimateAsUsedHasOrderSevenPlusOne) {
  using T = TypeParam;
  const auto estimate = [](int n) {
    const Nonlinear<T> flow;
    const auto y = flow.start();
    const T h = 1 / static_cast<T>(n);
    return error_norm(dop853_step(flow, T(0.2L), y, flow.rate(T(0.2L), y), h), y, h, Tolerances<T>{T(0), T(1)});
  };
  EXPECT_NEAR(slope(estimate, 4), 8, 0.5);
  EXPECT_NEAR(slope(estimate, 8), 8, 0.5);
}

// The estimate is relative to atol + rtol |y|, whose larger end counts, in the root of the mean square of components.
TEST(Dop853, ErrorEstimateIsRelativeToTheTolerances) {
  const Nonlinear<double> flow;
  const auto y = flow.start();
  const double h = 0.5;
  const auto step = dop853_step(flow, 0.0, y, flow.rate(0.0, y), h);
  const auto norm = [&](double rtol, double atol) { return error_norm(step, y, h, Tolerances<double>{rtol, atol}); };
  EXPECT_NEAR(norm(0, 1e-6) / norm(0, 1e-3), 1e3, 1e-6);
  EXPECT_GT(norm(0, 1e-6), norm(1e-6, 1e-6));
  // y1 lies within [0.75, 1.3], y2 below 0.51, on this step
  EXPECT_LT(norm(1e-6, 0.0), norm(0, 0.2e-6));
  EXPECT_GT(norm(1e-6, 0.0), norm(0, 1.3e-6));
}

TYPED_TEST(Dop853Of, DenseOutputIsOfOrderSeven) {
  using T = TypeParam;
  for (const T theta : {T(0.15L), T(0.5L), T(0.85L)}) {
    const auto error = [&](int n) {
      const long double h = 1 / static_cast<long double>(n);
      const auto exact = solve<long double>(static_cast<long double>(theta) * h, 20);
      return (Dense<T>(static_cast<T>(h)).at(theta).template cast<long double>() - exact).norm();
    };
    EXPECT_NEAR(slope(error, 2 * this->coarse), 8, 0.5) << "theta = " << static_cast<double>(theta);
  }
}

// 1000 roundings: the dense output's coefficients are of size 500.
TYPED_TEST(Dop853Of, DenseOutputMeetsValuesAndRatesAtBothEnds) {
  using T = TypeParam;
  const Nonlinear<T> flow;
  const T h = T(0.3L);
  const Dense<T> dense(h);
  const auto rounding = static_cast<double>(1000 * this->epsilon);
  const auto rate_at = [&](const T& theta, const auto& y) { return flow.rate(theta * h, y); };
  for (Eigen::Index i = 0; i < 2; ++i) {
    const auto c = dense.component(i);
    EXPECT_EQ(evaluate(c, T(0)), flow.start()[i]);
    EXPECT_NEAR(static_cast<double>(evaluate(c, T(1)) - dense.step.end[i]), 0, rounding);
    EXPECT_NEAR(static_cast<double>(derivative(c, T(0)) - h * rate_at(T(0), flow.start())[i]), 0, rounding);
    EXPECT_NEAR(static_cast<double>(derivative(c, T(1)) - h * rate_at(T(1), dense.step.end)[i]), 0, rounding);
    EXPECT_EQ(dense.step.k[Dop853<T>::stages][i], rate_at(T(1), dense.step.end)[i]);
  }
}

}  // namespace
}  // namespace turgor
