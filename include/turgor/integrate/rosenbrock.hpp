#pragma once
// One step of a Rosenbrock method for small stiff systems y' = f(t, y) with analytic Jacobian and time derivative.

#include <array>
#include <cmath>

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
struct Rodas5P {
  static constexpr int stages = 8;
  static constexpr int order = 5;

  static constexpr long double gamma = 0.21193756319429014L;
  static constexpr std::array<std::array<long double, 7>, 8> a{{
      {},
      {3.0L},
      {2.849394379747939L, 0.45842242204463923L},
      {-6.954028509809101L, 2.489845061869568L, -10.358996098473584L},
      {2.8029986275628964L, 0.5072464736228206L, -0.3988312541770524L, -0.04721187230404641L},
      {-7.502846399306121L, 2.561846144803919L, -11.627539656261098L, -0.18268767659942256L, 0.030198172008377946L},
      {-7.502846399306121L, 2.561846144803919L, -11.627539656261098L, -0.18268767659942256L, 0.030198172008377946L,
       1.0L},
      {-7.502846399306121L, 2.561846144803919L, -11.627539656261098L, -0.18268767659942256L, 0.030198172008377946L,
       1.0L, 1.0L},
  }};
  static constexpr std::array<std::array<long double, 7>, 8> c{{
      {},
      {-14.155112264123755L},
      {-17.97296035885952L, -2.859693295451294L},
      {147.12150275711716L, -1.41221402718213L, 71.68940251302358L},
      {165.43517024871676L, -0.4592823456491126L, 42.90938336958603L, -5.961986721573306L},
      {24.854864614690072L, -3.0009227002832186L, 47.4931110020768L, 5.5814197821558125L, -0.6610691825249471L},
      {30.91273214028599L, -3.1208243349937974L, 77.79954646070892L, 34.28646028294783L, -19.097331116725623L,
       -28.087943162872662L},
      {37.80277123390563L, -3.2571969029072276L, 112.26918849496327L, 66.9347231244047L, -40.06618937091002L,
       -54.66780262877968L, -9.48861652309627L},
  }};
  static constexpr std::array<long double, 8> time{
      0.0L, 0.6358126895828704L, 0.4095798393397535L, 0.9769306725060716L, 0.4288403609558664L, 1.0L, 1.0L, 1.0L};
  static constexpr std::array<long double, 8> d{0.21193756319429014L,
                                                -0.42387512638858027L,
                                                -0.3384627126235924L,
                                                1.8046452872882734L,
                                                2.325825639765069L,
                                                0.0L,
                                                0.0L,
                                                0.0L};
  static constexpr std::array<std::array<long double, 8>, 3> dense{{
      {25.948786856663858L, -2.5579724845846235L, 10.433815404888879L, -2.3679251022685204L, 0.524948541321073L,
       1.1241088310450404L, 0.4272876194431874L, -0.17202221070155493L},
      {-9.91568850695171L, -0.9689944594115154L, 3.0438037242978453L, -24.495224566215796L, 20.176138334709044L,
       15.98066361424651L, -6.789040303419874L, -6.710236069923372L},
      {11.419903575922262L, 2.8879645146136994L, 72.92137995996029L, 80.12511834622643L, -52.072871366152654L,
       -59.78993625266729L, -0.15582684282751913L, 4.883087185713722L},
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

/// Takes one Rodas5P step of size h > 0.
/// @param flow  has Scalar, a constant `size`, and rate(t, y) -> y'
/// @param at    linearization of the flow at (t, y)
template <class Flow, class T = typename Flow::Scalar, int N = Flow::size>
[[nodiscard]] RosenbrockStep<T, N> rosenbrock_step(const Flow& flow, const T& t, const Eigen::Matrix<T, N, 1>& y,
                                                   const Linearization<T, N>& at, const T& h) {
  using Method = Rodas5P;
  using State = Eigen::Matrix<T, N, 1>;
  const Eigen::Matrix<T, N, N> shifted =
      Eigen::Matrix<T, N, N>::Identity() / (static_cast<T>(Method::gamma) * h) - at.jacobian;
  const Eigen::PartialPivLU<Eigen::Matrix<T, N, N>> factors(shifted);

  std::array<State, Method::stages> k;
  State offset = State::Zero();
  for (std::size_t i = 0; i < k.size(); ++i) {
    State sum = State::Zero();
    offset.setZero();
    for (std::size_t j = 0; j < i; ++j) {
      offset += static_cast<T>(Method::a[i][j]) * k[j];
      sum += static_cast<T>(Method::c[i][j]) * k[j];
    }
    const State rate = i == 0 ? at.rate : flow.rate(t + static_cast<T>(Method::time[i]) * h, y + offset);
    k[i] = factors.solve(rate + sum / h + (static_cast<T>(Method::d[i]) * h) * at.time_derivative);
  }

  RosenbrockStep<T, N> step;
  const State increment = offset + k.back();
  step.end = y + increment;
  step.error = k.back();
  std::array<State, 3> q;
  for (std::size_t r = 0; r < q.size(); ++r) {
    q[r] = State::Zero();
    for (std::size_t j = 0; j < k.size(); ++j) q[r] += static_cast<T>(Method::dense[r][j]) * k[j];
  }
  step.polynomial = {y, increment + q[0], q[1] - q[0], q[2] - q[1], -q[2]};
  return step;
}

}  // namespace turgor
