// The integrator as a tool for any hybrid system, without balloons: exact solutions of small systems.

#include "turgor/integrate/hybrid.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace turgor {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// What the systems below have in common: one lane, no events, the end at the target, a record of the steps.
template <class Derived, int components, bool may_be_stiff>
struct SystemOf {
  using Value = double;
  static constexpr int size = components;
  static constexpr bool stiff = may_be_stiff;
  using State = Eigen::Matrix<double, components, 1>;

  struct Step {
    double start;
    double duration;
    DenseState<State> dense;
    StepMethod method;
  };
  std::vector<Step> steps;
  long most_steps = 100000;
  bool stalled = false;
  bool exhausted = false;

  template <class Action>
  void with_flow(const Action& action) const {
    action(static_cast<const Derived&>(*this));
  }
  [[nodiscard]] static std::size_t crossings() { return 0; }
  [[nodiscard]] static Crossing<double> crossing(std::size_t) { return {0, -1e100, 1}; }
  template <class Integrator>
  [[nodiscard]] static double noise(const Integrator&, int, std::size_t, double) {
    return 0;
  }
  template <class Integrator>
  void on_event(Integrator&, int, std::size_t) {
    FAIL() << "no event is watched";
  }
  template <class Integrator>
  void on_target(Integrator& integrator, int l) {
    integrator.retire(l);
  }
  template <class Integrator>
  void on_stall(Integrator& integrator, int l) {
    stalled = true;
    integrator.retire(l);
  }
  template <class Integrator>
  void on_method_due(Integrator&, int) {
    FAIL() << "a single lane changes its method by itself";
  }
  template <class Integrator>
  void on_steps(Integrator& integrator, bool, double start, double h, const DenseState<State>& dense) {
    steps.push_back({start, h, dense, integrator.method()});
    if (static_cast<long>(steps.size()) < most_steps) return;
    exhausted = true;
    integrator.retire(0);
  }

  /// Solution at any time that was integrated over.
  [[nodiscard]] State at(double time) const {
    auto step = steps.begin();
    while (step + 1 != steps.end() && (step + 1)->start <= time) ++step;
    const double theta = (time - step->start) / step->duration;
    State sum = step->dense[dense_degree];
    for (std::size_t k = dense_degree; k > 0; --k) sum = sum * theta + step->dense[k - 1];
    return sum;
  }
  [[nodiscard]] long steps_by(StepMethod method) const {
    return std::count_if(steps.begin(), steps.end(), [&](const Step& s) { return s.method == method; });
  }
};

template <class System>
struct Solution {
  typename System::State end;
  double time;
  IntegratorStatistics statistics;
};

template <class System>
Solution<System> solve(System& system, const typename System::State& start, double end, double tolerance,
                       StepMethod method = StepMethod::explicit_pair) {
  HybridIntegrator<System> integrator(system, method, start.size());
  integrator.load(0, 0.0, end, {tolerance, tolerance});
  for (Eigen::Index i = 0; i < start.size(); ++i) integrator.component(0, i) = start[i];
  integrator.run();
  typename System::State last = start;
  for (Eigen::Index i = 0; i < start.size(); ++i) last[i] = integrator.component(i);
  return {last, integrator.time(0), integrator.statistics()};
}

/// A ball that loses a share of its speed at each impact: y = (height, velocity).
struct Ball : SystemOf<Ball, 2, false> {
  double gravity = 9.81;
  double restitution = 0.9;
  std::vector<double> impacts;
  std::size_t most_impacts = 60;

  [[nodiscard]] State rate(double, const State& y) const { return {y[1], -gravity}; }
  [[nodiscard]] static std::size_t crossings() { return 1; }
  [[nodiscard]] static Crossing<double> crossing(std::size_t) { return {0, 0, 1}; }
  template <class Integrator>
  void on_event(Integrator& integrator, int l, std::size_t i) {
    EXPECT_EQ(i, 0U);
    EXPECT_EQ(integrator.component(l, 0), 0.0);
    impacts.push_back(integrator.time(l));
    integrator.component(l, 1) *= -restitution;
    if (impacts.size() >= most_impacts) {
      integrator.retire(l);
    } else {
      integrator.restart(l, -1);
    }
  }
};

// The n-th impact is at t1 (1 + 2 (e + ... + e^(n-1))). A parabola is integrated exactly, so that only the location of
// impacts errs, by rounding. The velocity collects n roundings in n impacts, and the time the sum of them.
TEST(HybridIntegrator, LetsABallBounce) {
  for (const double restitution : {0.9, 0.5, 1.0}) {
    Ball ball;
    ball.restitution = restitution;
    ball.most_impacts = restitution == 0.5 ? 25 : 60;
    (void)solve(ball, {1.5, 0.0}, 1e4, 1e-8);
    ASSERT_EQ(ball.impacts.size(), ball.most_impacts);
    double expected = std::sqrt(2 * 1.5 / ball.gravity);
    double flight = 2 * expected;
    for (std::size_t i = 0; i < ball.impacts.size(); ++i) {
      const auto n = static_cast<double>(i + 1);
      EXPECT_NEAR(ball.impacts[i], expected, 64 * epsilon * n * n) << "impact " << i << ", restitution " << restitution;
      flight *= restitution;
      expected += flight;
    }
  }
}

/// x'' = -w^2 x with w = `up` while x' > 0 and `down` while x' < 0: y = (x, x').
struct TwoSprings : SystemOf<TwoSprings, 2, false> {
  double up = 1;
  double down = 3;
  bool rising = false;
  int kind = -1;
  std::vector<std::pair<double, double>> turns;

  [[nodiscard]] State rate(double, const State& y) const {
    const double w = rising ? up : down;
    return {y[1], -w * w * y[0]};
  }
  [[nodiscard]] static std::size_t crossings() { return 1; }
  [[nodiscard]] Crossing<double> crossing(std::size_t) const { return {1, 0, rising ? 1.0 : -1.0}; }
  template <class Integrator>
  void on_event(Integrator& integrator, int l, std::size_t) {
    EXPECT_EQ(integrator.component(l, 1), 0.0);
    turns.emplace_back(integrator.time(l), integrator.component(l, 0));
    rising = !rising;
    integrator.restart(l, kind < 0 ? -1 : (rising ? 0 : 1));
  }
};

// Half a cycle lasts pi/w and turns x into -x. The error is of order tolerance per half-cycle, linear in their number.
TEST(HybridIntegrator, SwitchesBetweenTwoSprings) {
  for (const int kind : {-1, 0}) {  // first steps chosen afresh, or as the last of their kind
    TwoSprings system;
    system.kind = kind;
    const int turns = 400;
    const double pi = std::numbers::pi;
    const double tolerance = 1e-10;
    const auto solution = solve(system, {1.0, 0.0}, turns / 2 * (pi / system.up + pi / system.down) + 0.1, tolerance);
    ASSERT_EQ(system.turns.size(), static_cast<std::size_t>(turns));
    double time = 0;
    for (int i = 0; i < turns; ++i) {
      time += pi / (i % 2 == 0 ? system.down : system.up);
      const auto [at, x] = system.turns[static_cast<std::size_t>(i)];
      EXPECT_NEAR(at, time, 2 * tolerance * (i + 1)) << "turn " << i;
      EXPECT_NEAR(x, i % 2 == 0 ? -1 : 1, 2 * tolerance * (i + 1)) << "turn " << i;
    }
    EXPECT_EQ(solution.statistics.event_refinements, turns);
    EXPECT_LT(solution.statistics.steps, 15 * turns);
  }
}

// A start exactly at the event's level is not the event, and rest at the level with a motion that sets out is none
// either: the springs above begin with x' = 0, in the regime that the force chooses.
TEST(HybridIntegrator, TheStartAtALevelIsNoEvent) {
  Ball ball;
  ball.most_impacts = 1;
  (void)solve(ball, {0.0, 3.0}, 10.0, 1e-8);
  ASSERT_EQ(ball.impacts.size(), 1U);
  EXPECT_NEAR(ball.impacts[0], 2 * 3.0 / ball.gravity, 1e-14);
}

/// y = (t - a)^2 - d^2, whose zeros are a - d and a + d; both directions are events.
struct Dip : SystemOf<Dip, 1, false> {
  double middle = 1;
  double radius = 0.01;
  double sign = 1;
  std::vector<double> zeros;

  [[nodiscard]] State rate(double t, const State&) const { return State(2 * (t - middle)); }
  [[nodiscard]] static std::size_t crossings() { return 1; }
  [[nodiscard]] Crossing<double> crossing(std::size_t) const { return {0, 0, sign}; }
  template <class Integrator>
  void on_event(Integrator& integrator, int l, std::size_t) {
    zeros.push_back(integrator.time(l));
    sign = -sign;
    integrator.restart(l, -1);
  }
};

TEST(HybridIntegrator, FindsPairsOfZerosInOneStep) {
  for (const double radius : {0.3, 0.1, 0.03, 0.01}) {
    Dip dip;
    dip.radius = radius;
    (void)solve(dip, Dip::State(dip.middle * dip.middle - radius * radius), 2.5, 1e-3);
    ASSERT_EQ(dip.zeros.size(), 2U) << "radius " << radius;
    EXPECT_NEAR(dip.zeros[0], dip.middle - radius, 1e-13 / radius);
    EXPECT_NEAR(dip.zeros[1], dip.middle + radius, 1e-13 / radius);
    EXPECT_LT(dip.steps.front().start + dip.steps.front().duration, dip.middle);  // else it was no pair in one step
  }
}

/// A chain of n equal masses between walls, springs 1, dampers c on the ground: y = (x, x').
struct Chain : SystemOf<Chain, Eigen::Dynamic, true> {
  Eigen::MatrixXd matrix;

  Chain(Eigen::Index n, double damping) : matrix(Eigen::MatrixXd::Zero(2 * n, 2 * n)) {
    matrix.topRightCorner(n, n).setIdentity();
    for (Eigen::Index i = 0; i < n; ++i) {
      matrix(n + i, i) = -2;
      if (i > 0) matrix(n + i, i - 1) = matrix(n + i - 1, i) = 1;
      matrix(n + i, n + i) = -damping;
    }
  }
  [[nodiscard]] State rate(double, const State& y) const { return matrix * y; }
  [[nodiscard]] Linearization<double, Eigen::Dynamic> linearize(double t, const State& y) const {
    return {rate(t, y), matrix, State::Zero(y.size())};
  }
  [[nodiscard]] double stiffness(double, const State&) const {
    const double c = -matrix(matrix.rows() - 1, matrix.rows() - 1);
    return std::max(c, 2.0);  // the undamped chain's greatest frequency is below 2
  }
  [[nodiscard]] State start() const {
    State y = State::Zero(matrix.rows());
    for (Eigen::Index i = 0; i < y.size() / 2; ++i) y[i] = std::sin(0.7 * static_cast<double>(i) + 1);
    return y;
  }
  /// By the modes: eigenvectors of the springs' matrix, each a damped oscillator of its own.
  [[nodiscard]] State exact(double t) const {
    const Eigen::Index n = matrix.rows() / 2;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(-matrix.bottomLeftCorner(n, n));
    const Eigen::VectorXd amplitudes = modes.eigenvectors().transpose() * start().head(n);
    const std::complex<double> c(-matrix(2 * n - 1, 2 * n - 1));
    Eigen::VectorXd x(n);
    Eigen::VectorXd v(n);
    for (Eigen::Index i = 0; i < n; ++i) {  // x = (r2 e^(r1 t) - r1 e^(r2 t))/(r2 - r1), from rest
      const auto root = std::sqrt(c * c / 4.0 - modes.eigenvalues()[i]);
      // the slow root by the product of both, without cancellation
      const auto r1 = -c / 2.0 - root;
      const auto r2 = modes.eigenvalues()[i] / r1;
      x[i] = amplitudes[i] * ((r2 * std::exp(r1 * t) - r1 * std::exp(r2 * t)) / (r2 - r1)).real();
      v[i] = amplitudes[i] * (r1 * r2 * (std::exp(r1 * t) - std::exp(r2 * t)) / (r2 - r1)).real();
    }
    State all(2 * n);
    all << modes.eigenvectors() * x, modes.eigenvectors() * v;
    return all;
  }
};

// Sizes known only at run time, explicit; ten tolerances for the error carried along.
TEST(HybridIntegrator, TakesSystemsOfAnySize) {
  for (const Eigen::Index n : {1, 5, 100}) {
    Chain chain(n, 0.05);
    const auto solution = solve(chain, chain.start(), 20.0, 1e-9);
    EXPECT_EQ(solution.time, 20.0);
    EXPECT_LT((solution.end - chain.exact(20.0)).cwiseAbs().maxCoeff(), 1e-8) << "n = " << n;
    EXPECT_LT((chain.at(7.7) - chain.exact(7.7)).cwiseAbs().maxCoeff(), 1e-8) << "n = " << n;
    EXPECT_EQ(solution.statistics.factorizations, 0);
  }
}

// Damping of 1e5 makes the rates forget their start at once; stability would hold the explicit pair to steps of 6e-5.
TEST(HybridIntegrator, TakesStiffSystemsOfAnySize) {
  for (const Eigen::Index n : {1, 5, 100}) {
    for (const StepMethod first : {StepMethod::explicit_pair, StepMethod::rosenbrock}) {
      Chain chain(n, 1e5);
      const double end = 1e4;
      const auto solution = solve(chain, chain.start(), end, 1e-7, first);
      EXPECT_EQ(solution.time, end);
      EXPECT_LT((solution.end - chain.exact(end)).cwiseAbs().maxCoeff(), 1e-6) << "n = " << n;
      EXPECT_LT(solution.statistics.steps, 300) << "n = " << n;
      EXPECT_GT(solution.statistics.factorizations, 0);
    }
  }
}

/// y' = slopes[i] between knots i and i + 1.
struct Staircase : SystemOf<Staircase, 1, false> {
  std::vector<double> knots{0.5, 0.7, 1.9, 2.0};
  std::vector<double> slopes{1, -30, 0, 1e3};
  std::size_t piece = 0;

  [[nodiscard]] State rate(double t, const State& y) const { return State(slopes[piece] * std::cos(t) + 0 * y[0]); }
  template <class Integrator>
  void on_target(Integrator& integrator, int l) {
    EXPECT_EQ(integrator.time(l), knots[piece]);
    if (++piece == knots.size()) {
      integrator.retire(l);
    } else {
      integrator.aim(l, knots[piece]);
      integrator.restart(l, -1);
    }
  }
};

// Steps end exactly at knots, where the right-hand side jumps: each piece is smooth and costs a step or a few.
TEST(HybridIntegrator, StopsAtKnots) {
  Staircase stairs;
  const auto solution = solve(stairs, Staircase::State(0.25), stairs.knots[0], 1e-10);
  double expected = 0.25;
  double from = 0;
  for (std::size_t i = 0; i < stairs.knots.size(); ++i) {
    expected += stairs.slopes[i] * (std::sin(stairs.knots[i]) - std::sin(from));
    from = stairs.knots[i];
  }
  EXPECT_EQ(stairs.piece, stairs.knots.size());
  EXPECT_EQ(solution.time, stairs.knots.back());
  EXPECT_NEAR(solution.end[0], expected, 1e-8 * 0.1);
  EXPECT_LT(stairs.steps.size(), 60U);
  for (const double knot : stairs.knots) {
    for (const auto& step : stairs.steps) {
      EXPECT_FALSE(step.start < knot - 1e-12 && step.start + step.duration > knot + 1e-12) << "runs over " << knot;
    }
  }
}

/// y' = lambda(t) (y - sin t) + cos t with y = sin t, after Prothero & Robinson; stiff only between t = 1 and t = 2.
struct StiffStretch : SystemOf<StiffStretch, 1, true> {
  double most = 1e6;
  [[nodiscard]] double lambda(double t) const { return -1 - most * std::exp(-std::pow((t - 1.5) / 0.15, 4)); }
  [[nodiscard]] State rate(double t, const State& y) const {
    return State(lambda(t) * (y[0] - std::sin(t)) + std::cos(t));
  }
  [[nodiscard]] Linearization<double, 1> linearize(double t, const State& y) const {
    const double slope = (lambda(t) + 1) * -4 * std::pow((t - 1.5) / 0.15, 3) / 0.15;
    return {rate(t, y), State(lambda(t)), State(slope * (y[0] - std::sin(t)) - lambda(t) * std::cos(t) - std::sin(t))};
  }
  [[nodiscard]] double stiffness(double t, const State&) const { return std::abs(lambda(t)); }
};

TEST(HybridIntegrator, ChangesItsMethodWhereTheFlowIsStiffAndBack) {
  StiffStretch system;
  const auto solution = solve(system, StiffStretch::State(0.0), 6.0, 1e-8);
  ASSERT_FALSE(system.stalled);
  EXPECT_NEAR(solution.end[0], std::sin(6.0), 1e-8);
  EXPECT_EQ(system.steps.front().method, StepMethod::explicit_pair);
  EXPECT_EQ(system.steps.back().method, StepMethod::explicit_pair);
  EXPECT_GT(system.steps_by(StepMethod::rosenbrock), 5);
  EXPECT_LT(solution.statistics.steps, 500);
  for (const auto& step : system.steps) {
    const double middle = step.start + step.duration / 2;
    if (middle > 1.35 && middle < 1.65) {
      EXPECT_EQ(step.method, StepMethod::rosenbrock);
    }
    // The error inside steps of Rodas5P is not controlled; it is of order 4 only, and lower where the flow is stiff.
    EXPECT_NEAR(system.at(middle)[0], std::sin(middle), 1e-6);
  }
}

/// Van der Pol's oscillator x'' = mu (1 - x^2) x' - x: slow branches, stiff, with fast jumps between them.
struct VanDerPol : SystemOf<VanDerPol, 2, true> {
  double mu = 1000;
  [[nodiscard]] State rate(double, const State& y) const { return {y[1], mu * (1 - y[0] * y[0]) * y[1] - y[0]}; }
  [[nodiscard]] Linearization<double, 2> linearize(double t, const State& y) const {
    Linearization<double, 2> at{rate(t, y), {}, State::Zero()};
    at.jacobian << 0, 1, -2 * mu * y[0] * y[1] - 1, mu * (1 - y[0] * y[0]);
    return at;
  }
  [[nodiscard]] double stiffness(double t, const State& y) const {
    const auto jacobian = linearize(t, y).jacobian;
    return std::abs(jacobian(1, 1)) + std::sqrt(std::abs(jacobian(1, 0)));
  }
};

// At mu = 1000 a half-period is about 807 mu^0 and rounds off near the jumps; at t = 2000, on a slow branch after two
// jumps, the error is that of the jump's time, which each tolerance can move by about as much, times x' ~ 1e-3.
TEST(HybridIntegrator, FollowsVanDerPolsStiffOscillator) {
  VanDerPol tight;
  const auto exact = solve(tight, {2.0, 0.0}, 2000.0, 1e-12);
  ASSERT_EQ(exact.time, 2000.0);
  for (const double tolerance : {1e-6, 1e-8}) {
    VanDerPol system;
    const auto solution = solve(system, {2.0, 0.0}, 2000.0, tolerance);
    ASSERT_EQ(solution.time, 2000.0);
    EXPECT_NEAR(solution.end[0], exact.end[0], 1e3 * tolerance);
    EXPECT_LT(solution.statistics.steps, 3000);
    EXPECT_GT(system.steps_by(StepMethod::rosenbrock), system.steps_by(StepMethod::explicit_pair));
  }
}

/// y' = y^2, y = 1/(1 - t).
struct Explosion : SystemOf<Explosion, 1, false> {
  [[nodiscard]] State rate(double, const State& y) const { return State(y[0] * y[0]); }
};

TEST(HybridIntegrator, StallsBeforeASingularity) {
  Explosion explosion;
  const auto solution = solve(explosion, Explosion::State(1.0), 2.0, 1e-8);
  EXPECT_TRUE(explosion.stalled);
  EXPECT_NEAR(solution.time, 1.0, 1e-7);
  EXPECT_TRUE(std::isfinite(solution.end[0]));
  EXPECT_LT(explosion.steps.size(), 1000U);
}

/// y' = sqrt(1 - y), not a number beyond y = 1, which is reached at t = 2: y = 1 - (1 - t/2)^2.
struct Edge : SystemOf<Edge, 1, false> {
  [[nodiscard]] State rate(double, const State& y) const { return State(std::sqrt(1 - y[0])); }
};

TEST(HybridIntegrator, RejectsStepsThatLeaveTheDomain) {
  Edge edge;
  const auto solution = solve(edge, Edge::State(0.0), 1.9, 1e-9);
  EXPECT_FALSE(edge.stalled);
  EXPECT_NEAR(solution.end[0], 1 - 0.05 * 0.05, 1e-8);
}

}  // namespace
}  // namespace turgor
