#include "turgor/integrate/rosenbrock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace turgor {
namespace {

/// y' = lambda (y - sin t) + cos t with y = sin t: Prothero & Robinson's test, stiff for large negative lambda.
struct ProtheroRobinson {
  using Value = double;
  static constexpr int size = 1;
  using State = Eigen::Matrix<double, 1, 1>;
  double lambda;

  [[nodiscard]] State rate(double t, const State& y) const {
    return State(lambda * (y[0] - std::sin(t)) + std::cos(t));
  }
  [[nodiscard]] Linearization<double, 1> linearize(double t, const State& y) const {
    return {rate(t, y), State(lambda), State(-lambda * std::cos(t) - std::sin(t))};
  }
  [[nodiscard]] static State exact(double t) { return State(std::sin(t)); }
};

/// y1' = y2, y2' = -y1^3 - t y2: nonlinear, not autonomous, not stiff; no closed solution.
struct Nonlinear {
  using Value = double;
  static constexpr int size = 2;
  using State = Eigen::Matrix<double, 2, 1>;

  [[nodiscard]] State rate(double t, const State& y) const { return {y[1], -y[0] * y[0] * y[0] - t * y[1]}; }
  [[nodiscard]] Linearization<double, 2> linearize(double t, const State& y) const {
    Linearization<double, 2> at{rate(t, y), {}, {0, -y[1]}};
    at.jacobian << 0, 1, -3 * y[0] * y[0], -t;
    return at;
  }
};

/// Solution at t = 1 in n steps, and at theta of the last step.
template <class Flow>
typename Flow::State solve(const Flow& flow, typename Flow::State y, int n, double theta = 1) {
  const double h = 1.0 / n;
  typename Flow::State inside = y;
  for (int i = 0; i < n; ++i) {
    const double t = i * h;
    const auto step = rosenbrock_step(flow, t, y, flow.linearize(t, y), h);
    inside = step.polynomial[4];
    for (std::size_t k = 4; k-- > 0;) inside = inside * theta + step.polynomial[k];
    y = step.end;
  }
  return theta == 1 ? y : inside;
}

double slope(const std::function<double(int)>& error, int n) { return std::log2(error(n) / error(2 * n)); }

// Half an order of slack: n is small enough that rounding stays away, so the next term of the error shows.
TEST(Rodas5P, HasOrderFive) {
  const Nonlinear flow;
  const Nonlinear::State start{1.0, 0.5};
  const Nonlinear::State exact = solve(flow, start, 3000);
  EXPECT_NEAR(slope([&](int n) { return (solve(flow, start, n) - exact).norm(); }, 20), 5, 0.5);
  EXPECT_NEAR(slope([&](int n) { return (solve(flow, start, n) - exact).norm(); }, 40), 5, 0.5);
}

TEST(Rodas5P, ErrorEstimateHasOrderFourPlusOne) {
  const Nonlinear flow;
  const Nonlinear::State start{1.0, 0.5};
  const auto estimate = [&](int n) {
    return rosenbrock_step(flow, 0.2, start, flow.linearize(0.2, start), 1.0 / n).error.norm();
  };
  EXPECT_NEAR(slope(estimate, 20), 5, 0.5);
}

// The dense output is of order 4: its error inside a step is O(h^5), like a local error.
TEST(Rodas5P, DenseOutputIsOfOrderFour) {
  const Nonlinear flow;
  const Nonlinear::State start{1.0, 0.5};
  const auto error = [&](int n) {
    const double theta = 0.4;
    const double h = 1.0 / n;
    const auto step = rosenbrock_step(flow, 0.0, start, flow.linearize(0.0, start), h);
    Nonlinear::State inside = step.polynomial[4];
    for (std::size_t k = 4; k-- > 0;) inside = inside * theta + step.polynomial[k];
    Nonlinear::State y = start;  // the same instant by many small steps
    const int parts = 50;
    for (int i = 0; i < parts; ++i) {
      const double t = i * theta * h / parts;
      y = rosenbrock_step(flow, t, y, flow.linearize(t, y), theta * h / parts).end;
    }
    return (inside - y).norm();
  };
  EXPECT_GT(slope(error, 8), 4.5);
  EXPECT_GT(slope(error, 16), 4.5);
}

// Order reduction: on a stiff problem the error falls like h^3/|lambda| only, which is still small because lambda is
// large.
TEST(Rodas5P, LosesLittleOnStiffProblems) {
  const auto error = [](double lambda, int n) {
    const ProtheroRobinson flow{lambda};
    return std::abs(solve(flow, flow.exact(0), n)[0] - std::sin(1.0));
  };
  EXPECT_NEAR(slope([&](int n) { return error(-1.0, n); }, 4), 5, 0.5);
  EXPECT_GT(slope([&](int n) { return error(-1e3, n); }, 4), 2.8);
  EXPECT_GT(slope([&](int n) { return error(-1e6, n); }, 4), 2.8);
  EXPECT_LT(error(-1e6, 8), 1e-2 * error(-1e3, 8));
}

// L-stability: an infinitely stiff component is gone after one step, not merely bounded. 1e-4 is |R(z)| ~ 1/|z| with
// room.
TEST(Rodas5P, DampsInfinitelyStiffComponents) {
  ProtheroRobinson flow{-1e8};
  const auto step =
      rosenbrock_step(flow, 0.0, ProtheroRobinson::State(1.0), flow.linearize(0.0, ProtheroRobinson::State(1.0)), 1.0);
  EXPECT_LT(std::abs(step.end[0] - std::sin(1.0)), 1e-4);
}

// Systems beyond two unknowns go through LU: two copies of the nonlinear problem must move as the one does.
struct TwoCopies {
  using Value = double;
  static constexpr int size = 4;
  using State = Eigen::Matrix<double, 4, 1>;
  Nonlinear one;

  [[nodiscard]] State rate(double t, const State& y) const {
    State rates;
    rates << one.rate(t, y.head<2>()), one.rate(t, y.tail<2>());
    return rates;
  }
  [[nodiscard]] Linearization<double, 4> linearize(double t, const State& y) const {
    const auto head = one.linearize(t, y.head<2>());
    const auto tail = one.linearize(t, y.tail<2>());
    Linearization<double, 4> at{rate(t, y), Eigen::Matrix4d::Zero(), {}};
    at.jacobian.topLeftCorner<2, 2>() = head.jacobian;
    at.jacobian.bottomRightCorner<2, 2>() = tail.jacobian;
    at.time_derivative << head.time_derivative, tail.time_derivative;
    return at;
  }
};

TEST(Rodas5P, TakesLargerSystems) {
  const Nonlinear::State start{1.0, 0.5};
  TwoCopies::State both;
  both << start, start;
  const auto one = solve(Nonlinear{}, start, 10);
  const auto two = solve(TwoCopies{}, both, 10);
  EXPECT_LT((two.head<2>() - one).norm() + (two.tail<2>() - one).norm(), 1e-14);
}

}  // namespace
}  // namespace turgor
