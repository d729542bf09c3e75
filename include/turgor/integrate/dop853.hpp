#pragma once
// One step of an explicit Runge-Kutta method of high order, for stretches that are not stiff.

#include "turgor/integrate/step.hpp"

namespace turgor {

/// DOP853: 12 stages, order 8 with embedded estimates of order 5 and 3, dense output of order 7 from 3 further stages.
///
/// P. J. Prince & J. R. Dormand, J. Comput. Appl. Math. 7 (1981) 67; method, error estimate and dense output by
/// E. Hairer, S. P. Norsett & G. Wanner, Solving Ordinary Differential Equations I (2nd ed.), section II.10;
/// coefficients as published with it (code DOP853).
template <class T>
struct Dop853 {
  static constexpr std::size_t stages = 12;
  static constexpr std::size_t all_stages = 16;  ///< with the one at the end of the step and three for dense output
  static constexpr int order = 8;

  static constexpr std::array<T, all_stages> time{T(0.0L),
                                                  T(0.526001519587677318785587544488e-01L),
                                                  T(0.789002279381515978178381316732e-01L),
                                                  T(0.118350341907227396726757197510L),
                                                  T(0.281649658092772603273242802490L),
                                                  T(0.333333333333333333333333333333L),
                                                  T(0.25L),
                                                  T(0.307692307692307692307692307692L),
                                                  T(0.651282051282051282051282051282L),
                                                  T(0.6L),
                                                  T(0.857142857142857142857142857142L),
                                                  T(1.0L),
                                                  T(1.0L),
                                                  T(0.1L),
                                                  T(0.2L),
                                                  T(0.777777777777777777777777777778L)};
  /// Row 12 holds the weights of the solution.
  static constexpr std::array<std::array<T, all_stages>, all_stages> a{{
      {},
      {T(5.26001519587677318785587544488e-2L)},
      {T(1.97250569845378994544595329183e-2L), T(5.91751709536136983633785987549e-2L)},
      {T(2.95875854768068491816892993775e-2L), T(0), T(8.87627564304205475450678981324e-2L)},
      {T(2.41365134159266685502369798665e-1L), T(0), T(-8.84549479328286085344864962717e-1L),
       T(9.24834003261792003115737966543e-1L)},
      {T(3.7037037037037037037037037037e-2L), T(0), T(0), T(1.70828608729473871279604482173e-1L),
       T(1.25467687566822425016691814123e-1L)},
      {T(3.7109375e-2L), T(0), T(0), T(1.70252211019544039314978060272e-1L), T(6.02165389804559606850219397283e-2L),
       T(-1.7578125e-2L)},
      {T(3.70920001185047927108779319836e-2L), T(0), T(0), T(1.70383925712239993810214054705e-1L),
       T(1.07262030446373284651809199168e-1L), T(-1.53194377486244017527936158236e-2L),
       T(8.27378916381402288758473766002e-3L)},
      {T(6.24110958716075717114429577812e-1L), T(0), T(0), T(-3.36089262944694129406857109825L),
       T(-8.68219346841726006818189891453e-1L), T(2.75920996994467083049415600797e1L),
       T(2.01540675504778934086186788979e1L), T(-4.34898841810699588477366255144e1L)},
      {T(4.77662536438264365890433908527e-1L), T(0), T(0), T(-2.48811461997166764192642586468L),
       T(-5.90290826836842996371446475743e-1L), T(2.12300514481811942347288949897e1L),
       T(1.52792336328824235832596922938e1L), T(-3.32882109689848629194453265587e1L),
       T(-2.03312017085086261358222928593e-2L)},
      {T(-9.3714243008598732571704021658e-1L), T(0), T(0), T(5.18637242884406370830023853209L),
       T(1.09143734899672957818500254654L), T(-8.14978701074692612513997267357L),
       T(-1.85200656599969598641566180701e1L), T(2.27394870993505042818970056734e1L),
       T(2.49360555267965238987089396762L), T(-3.0467644718982195003823669022L)},
      {T(2.27331014751653820792359768449L), T(0), T(0), T(-1.05344954667372501984066689879e1L),
       T(-2.00087205822486249909675718444L), T(-1.79589318631187989172765950534e1L),
       T(2.79488845294199600508499808837e1L), T(-2.85899827713502369474065508674L),
       T(-8.87285693353062954433549289258L), T(1.23605671757943030647266201528e1L),
       T(6.43392746015763530355970484046e-1L)},
      {T(5.42937341165687622380535766363e-2L), T(0), T(0), T(0), T(0), T(4.45031289275240888144113950566L),
       T(1.89151789931450038304281599044L), T(-5.8012039600105847814672114227L), T(3.1116436695781989440891606237e-1L),
       T(-1.52160949662516078556178806805e-1L), T(2.01365400804030348374776537501e-1L),
       T(4.47106157277725905176885569043e-2L)},
      {T(5.61675022830479523392909219681e-2L), T(0), T(0), T(0), T(0), T(0), T(2.53500210216624811088794765333e-1L),
       T(-2.46239037470802489917441475441e-1L), T(-1.24191423263816360469010140626e-1L),
       T(1.5329179827876569731206322685e-1L), T(8.20105229563468988491666602057e-3L),
       T(7.56789766054569976138603589584e-3L), T(-8.298e-3L)},
      {T(3.18346481635021405060768473261e-2L), T(0), T(0), T(0), T(0), T(2.83009096723667755288322961402e-2L),
       T(5.35419883074385676223797384372e-2L), T(-5.49237485713909884646569340306e-2L), T(0), T(0),
       T(-1.08347328697249322858509316994e-4L), T(3.82571090835658412954920192323e-4L),
       T(-3.40465008687404560802977114492e-4L), T(1.41312443674632500278074618366e-1L)},
      {T(-4.28896301583791923408573538692e-1L), T(0), T(0), T(0), T(0), T(-4.69762141536116384314449447206L),
       T(7.68342119606259904184240953878L), T(4.06898981839711007970213554331L), T(3.56727187455281109270669543021e-1L),
       T(0), T(0), T(0), T(-1.39902416515901462129418009734e-3L), T(2.9475147891527723389556272149L),
       T(-9.15095847217987001081870187138L)},
  }};
  /// Weights of the difference to order 5.
  static constexpr std::array<T, stages> error5{T(0.1312004499419488073250102996e-1L),
                                                T(0),
                                                T(0),
                                                T(0),
                                                T(0),
                                                T(-0.1225156446376204440720569753e+1L),
                                                T(-0.4957589496572501915214079952L),
                                                T(0.1664377182454986536961530415e+1L),
                                                T(-0.3503288487499736816886487290L),
                                                T(0.3341791187130174790297318841L),
                                                T(0.8192320648511571246570742613e-1L),
                                                T(-0.2235530786388629525884427845e-1L)};
  /// Weights of the solution of order 3, in stages 0, 8 and 11.
  static constexpr std::array<T, stages> weights3{T(0.244094488188976377952755905512L),
                                                  T(0),
                                                  T(0),
                                                  T(0),
                                                  T(0),
                                                  T(0),
                                                  T(0),
                                                  T(0),
                                                  T(0.733846688281611857341361741547L),
                                                  T(0),
                                                  T(0),
                                                  T(0.220588235294117647058823529412e-1L)};
  static constexpr std::array<std::array<T, all_stages>, 4> dense{{
      {T(-0.84289382761090128651353491142e+1L), T(0), T(0), T(0), T(0), T(0.56671495351937776962531783590L),
       T(-0.30689499459498916912797304727e+1L), T(0.23846676565120698287728149680e+1L),
       T(0.21170345824450282767155149946e+1L), T(-0.87139158377797299206789907490L),
       T(0.22404374302607882758541771650e+1L), T(0.63157877876946881815570249290L),
       T(-0.88990336451333310820698117400e-1L), T(0.18148505520854727256656404962e+2L),
       T(-0.91946323924783554000451984436e+1L), T(-0.44360363875948939664310572000e+1L)},
      {T(0.10427508642579134603413151009e+2L), T(0), T(0), T(0), T(0), T(0.24228349177525818288430175319e+3L),
       T(0.16520045171727028198505394887e+3L), T(-0.37454675472269020279518312152e+3L),
       T(-0.22113666853125306036270938578e+2L), T(0.77334326684722638389603898808e+1L),
       T(-0.30674084731089398182061213626e+2L), T(-0.93321305264302278729567221706e+1L),
       T(0.15697238121770843886131091075e+2L), T(-0.31139403219565177677282850411e+2L),
       T(-0.93529243588444783865713862664e+1L), T(0.35816841486394083752465898540e+2L)},
      {T(0.19985053242002433820987653617e+2L), T(0), T(0), T(0), T(0), T(-0.38703730874935176555105901742e+3L),
       T(-0.18917813819516756882830838328e+3L), T(0.52780815920542364900561016686e+3L),
       T(-0.11573902539959630126141871134e+2L), T(0.68812326946963000169666922661e+1L),
       T(-0.10006050966910838403183860980e+1L), T(0.77771377980534432092869265740L),
       T(-0.27782057523535084065932004339e+1L), T(-0.60196695231264120758267380846e+2L),
       T(0.84320405506677161018159903784e+2L), T(0.11992291136182789328035130030e+2L)},
      {T(-0.25693933462703749003312586129e+2L), T(0), T(0), T(0), T(0), T(-0.15418974869023643374053993627e+3L),
       T(-0.23152937917604549567536039109e+3L), T(0.35763911791061412378285349910e+3L),
       T(0.93405324183624310003907691704e+2L), T(-0.37458323136451633156875139351e+2L),
       T(0.10409964950896230045147246184e+3L), T(0.29840293426660503123344363579e+2L),
       T(-0.43533456590011143754432175058e+2L), T(0.96324553959188282948394950600e+2L),
       T(-0.39177261675615439165231486172e+2L), T(-0.14972683625798562581422125276e+3L)},
  }};
};

/// The stages of a step of size h from y, enough to judge it.
template <class V, int N>
struct Dop853Step {
  using State = Eigen::Matrix<V, N, 1>;
  std::array<State, Dop853<ScalarOf<V>>::all_stages> k;
  State end;
};

/// Takes one step of size h > 0, without the stages that only dense output needs.
/// @param flow  has Value, a constant `size`, and rate(t, y) -> y'
/// @param rate  y' at (t, y)
template <class Flow, class V = typename Flow::Value, int N = Flow::size>
[[nodiscard]] Dop853Step<V, N> dop853_step(const Flow& flow, const V& t, const Eigen::Matrix<V, N, 1>& y,
                                           const Eigen::Matrix<V, N, 1>& rate, const V& h) {
  using Method = Dop853<ScalarOf<V>>;
  Dop853Step<V, N> step;
  step.k[0] = rate;
  unrolled<1, Method::stages>([&](auto i) {
    constexpr std::size_t stage = decltype(i)::value;
    const auto offset = combination<stage>([](std::size_t j) { return Method::a[stage][j]; }, step.k);
    step.k[stage] = flow.rate(t + V(Method::time[stage]) * h, y + h * offset);
  });
  step.end = y + h * combination<Method::stages>([](std::size_t j) { return Method::a[Method::stages][j]; }, step.k);
  return step;
}

/// Local error relative to the tolerances; at most 1 when the step is good enough, not a number when it went astray.
template <class V, int N>
[[nodiscard]] V error_norm(const Dop853Step<V, N>& step, const Eigen::Matrix<V, N, 1>& y, const V& h,
                           const Tolerances<V>& tolerances) {
  using std::sqrt;
  using Method = Dop853<ScalarOf<V>>;
  const auto error5 = combination<Method::stages>([](std::size_t j) { return Method::error5[j]; }, step.k);
  const auto error3 = combination<Method::stages>(
      [](std::size_t j) { return Method::a[Method::stages][j] - Method::weights3[j]; }, step.k);
  V sum5(0);
  V sum3(0);
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const V unit = V(1) / tolerances.scale(y, step.end, i);
    sum5 += (error5[i] * unit) * (error5[i] * unit);
    sum3 += (error3[i] * unit) * (error3[i] * unit);
  }
  // Section II.10: the estimate of order 5, squared and divided by one of order 3, behaves like order 8. The tiny
  // number only keeps 0/0 away.
  const V denominator = (sum5 + V(ScalarOf<V>(0.01L)) * sum3) * V(static_cast<ScalarOf<V>>(y.size()));
  return h * sum5 / sqrt(denominator + V(std::numeric_limits<ScalarOf<V>>::min()));
}

/// Completes the stages of an accepted step; k[12] becomes y' at its end.
template <class Flow, class V = typename Flow::Value, int N = Flow::size>
[[nodiscard]] DenseState<Eigen::Matrix<V, N, 1>> dense_output(const Flow& flow, const V& t,
                                                              const Eigen::Matrix<V, N, 1>& y, const V& h,
                                                              Dop853Step<V, N>& step) {
  using Method = Dop853<ScalarOf<V>>;
  using State = Eigen::Matrix<V, N, 1>;
  step.k[Method::stages] = flow.rate(t + h, step.end);
  unrolled<Method::stages + 1, Method::all_stages>([&](auto i) {
    constexpr std::size_t stage = decltype(i)::value;
    const auto offset = combination<stage>([](std::size_t j) { return Method::a[stage][j]; }, step.k);
    step.k[stage] = flow.rate(t + V(Method::time[stage]) * h, y + h * offset);
  });

  // y + x (F0 + (1-x) (F1 + x (F2 + (1-x) (F3 + x (F4 + (1-x) (F5 + x F6)))))), (6.6) of section II.6, multiplied out.
  const State rise = step.end - y;
  const State bend = h * step.k[0] - rise;
  std::array<State, dense_degree> f{rise, bend, rise - h * step.k[Method::stages] - bend};
  unrolled<0, 4>([&](auto r) {
    constexpr std::size_t row = decltype(r)::value;
    f[3 + row] = h * combination<Method::all_stages>([](std::size_t j) { return Method::dense[row][j]; }, step.k);
  });
  DenseState<State> p;
  p[0] = f[6];
  unrolled<0, dense_degree>([&](auto i) {
    constexpr std::size_t degree = decltype(i)::value;       // of the polynomial so far
    constexpr std::size_t next = dense_degree - 1 - degree;  // of the next coefficient, f[next - 1] or y
    if constexpr (degree % 2 == 0) {                         // times x
      unrolled<0, degree + 1>([&](auto k) { p[degree + 1 - k] = p[degree - k]; });
      if constexpr (next > 0) {
        p[0] = f[next - 1];
      } else {
        p[0] = y;
      }
    } else {  // times 1 - x
      p[degree + 1] = -p[degree];
      unrolled<1, degree + 1>([&](auto k) { p[degree + 1 - k] -= p[degree - k]; });
      p[0] += f[next - 1];
    }
  });
  return p;
}

}  // namespace turgor
