#pragma once
// One step of a Rosenbrock method for small stiff systems y' = f(t, y) with analytic Jacobian and time derivative.

#include <array>
#include <type_traits>

#include <Eigen/Dense>

namespace turgor {

/// f, df/dy and df/dt at the start of a step; shared by every attempt to step from there.
template <class T, int N>
struct Linearization {
  Eigen::Matrix<T, N, 1> rate;
  Eigen::Matrix<T, N, N> jacobian;
  Eigen::Matrix<T, N, 1> time_derivative;
};

/// Rodas5P: 8 stages, order 5 with an embedded order 4, L-stable and stiffly accurate, dense output of order 4.
///
/// G. Steinebach, "Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia
/// Differential Equations package", BIT Numer. Math. 63 (2023) 27; coefficients as published there, in the transformed
/// form of E. Hairer & G. Wanner, Solving Ordinary Differential Equations II, section IV.7, eq. (7.25).
template <class T>
struct Rodas5P {
  static constexpr int stages = 8;
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

/// A completed step of size h from y: the new state, an estimate of its local error, and the solution in between as a
/// polynomial in theta = (t - t_start)/h, monomial coefficients from degree 0 to 4.
template <class T, int N>
struct RosenbrockStep {
  Eigen::Matrix<T, N, 1> end;
  Eigen::Matrix<T, N, 1> error;
  std::array<Eigen::Matrix<T, N, 1>, 5> polynomial;
};

/// Solves linear systems with one small matrix: by its inverse in closed form where there is one, by LU else.
template <class T, int N>
class SmallSolver {
 public:
  using Matrix = Eigen::Matrix<T, N, N>;
  using Vector = Eigen::Matrix<T, N, 1>;

  explicit SmallSolver(const Matrix& matrix) : factors_(factorized(matrix)) {}
  [[nodiscard]] Vector solve(const Vector& right) const {
    if constexpr (closed_form) {
      return factors_ * right;
    } else {
      return factors_.solve(right);
    }
  }

 private:
  static constexpr bool closed_form = N != Eigen::Dynamic && N <= 2;
  using Factors = std::conditional_t<closed_form, Matrix, Eigen::PartialPivLU<Matrix>>;

  static Factors factorized(const Matrix& matrix) {
    if constexpr (closed_form) {
      return matrix.inverse();
    } else {
      return Factors(matrix);
    }
  }

  Factors factors_;
};

/// Takes one Rodas5P step of size h > 0.
/// @param flow  has Scalar, a constant `size`, and rate(t, y) -> y'
/// @param at    linearization of the flow at (t, y)
template <class Flow, class T = typename Flow::Scalar, int N = Flow::size>
[[nodiscard]] RosenbrockStep<T, N> rosenbrock_step(const Flow& flow, const T& t, const Eigen::Matrix<T, N, 1>& y,
                                                   const Linearization<T, N>& at, const T& h) {
  using Method = Rodas5P<T>;
  using State = Eigen::Matrix<T, N, 1>;
  const SmallSolver<T, N> shifted(Eigen::Matrix<T, N, N>::Identity() / (Method::gamma * h) - at.jacobian);

  std::array<State, Method::stages> k;
  State offset = State::Zero();
  for (std::size_t i = 0; i < k.size(); ++i) {
    State sum = State::Zero();
    offset.setZero();
    for (std::size_t j = 0; j < i; ++j) {
      offset += Method::a[i][j] * k[j];
      sum += Method::c[i][j] * k[j];
    }
    const State rate = i == 0 ? at.rate : flow.rate(t + Method::time[i] * h, y + offset);
    k[i] = shifted.solve(rate + sum / h + (Method::d[i] * h) * at.time_derivative);
  }

  RosenbrockStep<T, N> step;
  const State increment = offset + k.back();
  step.end = y + increment;
  step.error = k.back();
  std::array<State, 3> q;
  for (std::size_t r = 0; r < q.size(); ++r) {
    q[r] = State::Zero();
    for (std::size_t j = 0; j < k.size(); ++j) q[r] += Method::dense[r][j] * k[j];
  }
  step.polynomial = {y, increment + q[0], q[1] - q[0], q[2] - q[1], -q[2]};
  return step;
}

}  // namespace turgor
