#pragma once
// One step of a Rosenbrock method for small stiff systems y' = f(t, y) with analytic Jacobian and time derivative.

#include <type_traits>

#include "turgor/integrate/step.hpp"

namespace turgor {

/// Rodas5P: 8 stages, order 5 with an embedded order 4, L-stable and stiffly accurate, dense output of order 4.
///
/// G. Steinebach, "Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia
/// Differential Equations package", BIT Numer. Math. 63 (2023) 27; coefficients as published there, in the transformed
/// form of E. Hairer & G. Wanner, Solving Ordinary Differential Equations II, section IV.7, eq. (7.25).
template <class T>
struct Rodas5P {
  static constexpr std::size_t stages = 8;
  static constexpr int order = 5;

  static constexpr T gamma = T(0.21193756319429014L);
  static constexpr std::array<std::array<T, 7>, 8> a{{
      {},
      {T(3.0L)},
      {T(2.849394379747939L), T(0.45842242204463923L)},
      {T(-6.954028509809101L), T(2.489845061869568L), T(-10.358996098473584L)},
      {T(2.8029986275628964L), T(0.5072464736228206L), T(-0.3988312541770524L), T(-0.04721187230404641L)},
      {T(-7.502846399306121L), T(2.561846144803919L), T(-11.627539656261098L), T(-0.18268767659942256L),
       T(0.030198172008377946L)},
      {T(-7.502846399306121L), T(2.561846144803919L), T(-11.627539656261098L), T(-0.18268767659942256L),
       T(0.030198172008377946L), T(1.0L)},
      {T(-7.502846399306121L), T(2.561846144803919L), T(-11.627539656261098L), T(-0.18268767659942256L),
       T(0.030198172008377946L), T(1.0L), T(1.0L)},
  }};
  static constexpr std::array<std::array<T, 7>, 8> c{{
      {},
      {T(-14.155112264123755L)},
      {T(-17.97296035885952L), T(-2.859693295451294L)},
      {T(147.12150275711716L), T(-1.41221402718213L), T(71.68940251302358L)},
      {T(165.43517024871676L), T(-0.4592823456491126L), T(42.90938336958603L), T(-5.961986721573306L)},
      {T(24.854864614690072L), T(-3.0009227002832186L), T(47.4931110020768L), T(5.5814197821558125L),
       T(-0.6610691825249471L)},
      {T(30.91273214028599L), T(-3.1208243349937974L), T(77.79954646070892L), T(34.28646028294783L),
       T(-19.097331116725623L), T(-28.087943162872662L)},
      {T(37.80277123390563L), T(-3.2571969029072276L), T(112.26918849496327L), T(66.9347231244047L),
       T(-40.06618937091002L), T(-54.66780262877968L), T(-9.48861652309627L)},
  }};
  static constexpr std::array<T, 8> time{T(0.0L),
                                         T(0.6358126895828704L),
                                         T(0.4095798393397535L),
                                         T(0.9769306725060716L),
                                         T(0.4288403609558664L),
                                         T(1.0L),
                                         T(1.0L),
                                         T(1.0L)};
  static constexpr std::array<T, 8> d{T(0.21193756319429014L),
                                      T(-0.42387512638858027L),
                                      T(-0.3384627126235924L),
                                      T(1.8046452872882734L),
                                      T(2.325825639765069L),
                                      T(0.0L),
                                      T(0.0L),
                                      T(0.0L)};
  static constexpr std::array<std::array<T, 8>, 3> dense{{
      {T(25.948786856663858L), T(-2.5579724845846235L), T(10.433815404888879L), T(-2.3679251022685204L),
       T(0.524948541321073L), T(1.1241088310450404L), T(0.4272876194431874L), T(-0.17202221070155493L)},
      {T(-9.91568850695171L), T(-0.9689944594115154L), T(3.0438037242978453L), T(-24.495224566215796L),
       T(20.176138334709044L), T(15.98066361424651L), T(-6.789040303419874L), T(-6.710236069923372L)},
      {T(11.419903575922262L), T(2.8879645146136994L), T(72.92137995996029L), T(80.12511834622643L),
       T(-52.072871366152654L), T(-59.78993625266729L), T(-0.15582684282751913L), T(4.883087185713722L)},
  }};
};

/// A completed step of size h from y: the new state, an estimate of its local error, and the solution in between.
template <class V, int N>
struct RosenbrockStep {
  using State = Eigen::Matrix<V, N, 1>;
  State end;
  State error;
  DenseState<State> polynomial;  ///< of degree 4
};

/// Solves linear systems with one small matrix: by its inverse in closed form where there is one, by LU else.
template <class V, int N>
class SmallSolver {
 public:
  using Matrix = Eigen::Matrix<V, N, N>;
  using Vector = Eigen::Matrix<V, N, 1>;

  explicit SmallSolver(const Matrix& matrix) : factors_(factorized(matrix)) {}
  [[nodiscard]] Vector solve(const Vector& right) const {
    if constexpr (closed_form) {
      return factors_ * right;
    } else {
      return factors_.solve(right);
    }
  }

 private:
  static constexpr bool closed_form = N == 1 || N == 2;
  using Factors = std::conditional_t<closed_form, Matrix, Eigen::PartialPivLU<Matrix>>;

  static Factors factorized(const Matrix& m) {
    if constexpr (N == 1) {
      return Matrix(V(1) / m(0, 0));
    } else if constexpr (N == 2) {
      const V scale = V(1) / (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0));
      Matrix inverse;
      inverse << m(1, 1) * scale, -m(0, 1) * scale, -m(1, 0) * scale, m(0, 0) * scale;
      return inverse;
    } else {
      return Factors(m);
    }
  }

  Factors factors_;
};

/// Takes one Rodas5P step of size h > 0.
/// @param flow  has Value, a constant `size` (or Eigen::Dynamic), and rate(t, y) -> y'
/// @param at    linearization of the flow at (t, y)
template <class Flow, class V = typename Flow::Value, int N = Flow::size>
[[nodiscard]] RosenbrockStep<V, N> rosenbrock_step(const Flow& flow, const V& t, const Eigen::Matrix<V, N, 1>& y,
                                                   const Linearization<V, N>& at, const V& h) {
  using Method = Rodas5P<ScalarOf<V>>;
  using State = Eigen::Matrix<V, N, 1>;
  const V per_step = V(1) / h;
  Eigen::Matrix<V, N, N> shifted = -at.jacobian;
  for (Eigen::Index i = 0; i < y.size(); ++i) shifted(i, i) += V(1 / Method::gamma) * per_step;
  const SmallSolver<V, N> solver(shifted);

  std::array<State, Method::stages> k;
  k[0] = solver.solve(at.rate + (V(Method::d[0]) * h) * at.time_derivative);
  State end;
  unrolled<1, Method::stages>([&](auto i) {
    constexpr std::size_t stage = decltype(i)::value;
    end = y + combination<stage>([](std::size_t j) { return Method::a[stage][j]; }, k);
    const State sum = combination<stage>([](std::size_t j) { return Method::c[stage][j]; }, k);
    const State right = flow.rate(t + V(Method::time[stage]) * h, end) + per_step * sum;
    if constexpr (Method::d[stage] != 0) {
      k[stage] = solver.solve(right + (V(Method::d[stage]) * h) * at.time_derivative);
    } else {
      k[stage] = solver.solve(right);
    }
  });

  RosenbrockStep<V, N> step;
  step.end = end + k.back();
  step.error = k.back();
  std::array<State, 3> q;
  unrolled<0, 3>([&](auto r) {
    constexpr std::size_t row = decltype(r)::value;
    q[row] = combination<Method::stages>([](std::size_t j) { return Method::dense[row][j]; }, k);
  });
  step.polynomial[0] = y;
  step.polynomial[1] = step.end - y + q[0];
  step.polynomial[2] = q[1] - q[0];
  step.polynomial[3] = q[2] - q[1];
  step.polynomial[4] = -q[2];
  for (std::size_t degree = 5; degree <= dense_degree; ++degree) {
    step.polynomial[degree] = State::Constant(y.size(), V(0));
  }
  return step;
}

/// Local error relative to the tolerances, in the component where it is worst; at most 1 when the step is good enough,
/// not a number when it went astray.
template <class V, int N>
[[nodiscard]] V error_norm(const RosenbrockStep<V, N>& step, const Eigen::Matrix<V, N, 1>& y,
                           const Tolerances<V>& tolerances) {
  using std::abs;
  V norm(0);
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const V ratio = abs(step.error[i]) / tolerances.scale(y, step.end, i);
    norm = select(ratio <= norm, norm, ratio);  // lets a NaN through
  }
  return norm;
}

}  // namespace turgor
