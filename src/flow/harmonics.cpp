#include "turgor/flow/harmonics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "gauss_legendre.hpp"
#include "legendre.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/force_coefficients.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

void check(double kappa, int count) {
  if (!(kappa > 0 && kappa < 1)) {
    throw InvalidInput("kappa", shortest(kappa), "the orifice must be smaller than the balloon",
                       "kappa = r_ch/r lies between 0 and 1");
  }
  constexpr int most = 100'000'000;
  if (count < 1 || count > most) {
    throw InvalidInput("harmonics", std::to_string(count), "out of range", "allowed are 1 to 1e8");
  }
}

}  // namespace

Harmonics uniform_harmonics(double kappa, int count) {
  check(kappa, count);
  using Real = long double;  // dA_m/deps is a difference of terms 1/eps times as large
  const Real eps = cap_depth(static_cast<Real>(kappa));
  Harmonics a{kappa, std::vector<double>(static_cast<std::size_t>(count)), {}};
  a.change.resize(a.amplitude.size());
  LegendreNearMinusOne<Real, Real> legendre(eps);
  Real before = legendre.integral();  // (-1)^m h_m for m - 1, m, m + 1
  legendre.advance();
  Real sign = -1;
  for (std::size_t i = 0; i < a.amplitude.size(); ++i) {
    const auto m = static_cast<Real>(i + 1);
    const Real here = legendre.integral();
    const Real value = legendre.value();
    legendre.advance();
    const Real after = legendre.integral();
    const Real first_moment = -((m + 1) * after + m * before);  // (-1)^m (2m+1) int x P_m over the cap
    a.amplitude[i] = static_cast<double>(sign * (-(2 * m + 1) * here + 2 / eps * first_moment));
    a.change[i] =
        static_cast<double>(sign * ((2 * m + 1) * (2 * (eps - 1) / eps - 1) * value - 2 / (eps * eps) * first_moment));
    before = here;
    sign = -sign;
  }
  return a;
}

Harmonics profile_harmonics(double kappa, const OutflowProfile& profile, int count) {
  check(kappa, count);
  constexpr int lanes = 16;
  using Lanes = Eigen::Array<double, lanes, 1>;
  const GaussLegendre& rule = gauss_legendre(lanes);
  const PotentialFlow flow(kappa, profile);
  Harmonics a{kappa, std::vector<double>(static_cast<std::size_t>(count), 0), {}};
  a.change = a.amplitude;

  // int (u - 1) P_m over the cap by Gauss rules on panels that the highest harmonic crosses in a phase of 8.
  const auto add_panel = [&](double from, double to) {
    Lanes depth;
    Lanes strength;
    Lanes change;
    for (int j = 0; j < lanes; ++j) {
      const double angle = from + (to - from) * rule.node[static_cast<std::size_t>(j)];
      const double half = std::sin(angle / 2);
      const double weight = (to - from) * rule.weight[static_cast<std::size_t>(j)] * std::sin(angle);
      const auto source = flow.source(angle);
      depth[j] = 2 * half * half;
      strength[j] = weight * source.strength;
      change[j] = weight * source.change;
    }
    LegendreNearMinusOne<Lanes> legendre(depth);
    for (std::size_t i = 0; i < a.amplitude.size(); ++i) {
      legendre.advance();
      a.amplitude[i] += (legendre.value() * strength).sum();
      a.change[i] += (legendre.value() * change).sum();
    }
  };
  const std::vector<double>& knots = profile.knots();
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double from = std::asin(knots[k] * kappa);
    const double to = std::asin(knots[k + 1] * kappa);
    const int panels = static_cast<int>(std::ceil((to - from) * count / 8));
    for (int p = 0; p < panels; ++p) {
      add_panel(from + (to - from) * p / panels, from + (to - from) * (p + 1) / panels);
    }
  }

  const double jump = flow.source(flow.cap_angle()).strength;  // moves with the rim
  LegendreNearMinusOne<double> rim(flow.eps());
  double sign = 1;
  for (std::size_t i = 0; i < a.amplitude.size(); ++i) {
    rim.advance();
    sign = -sign;
    const double factor = sign * (2 * static_cast<double>(i) + 3);
    a.amplitude[i] *= factor;
    a.change[i] = factor * (a.change[i] + jump * rim.value());
  }
  return a;
}

namespace {

/// For two vectors at once, in the real and the imaginary part: sum over n != m of b_n/(m - n).
std::vector<std::complex<double>> divided_differences(std::vector<std::complex<double>> b) {
  const std::size_t count = b.size();
  std::size_t size = 1;
  while (size < 2 * count) size *= 2;
  b.resize(size, 0);
  std::vector<std::complex<double>> kernel(size, 0);
  for (std::size_t j = 1; j < count; ++j) {
    kernel[j] = 1 / static_cast<double>(j);
    kernel[size - j] = -kernel[j];
  }
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> b_hat;
  std::vector<std::complex<double>> kernel_hat;
  fft.fwd(b_hat, b);
  fft.fwd(kernel_hat, kernel);
  for (std::size_t j = 0; j < size; ++j) b_hat[j] *= kernel_hat[j];
  fft.inv(b, b_hat);
  b.resize(count);
  return b;
}

/// int v^2 dx over the wall, v the velocity of the truncated series. With S_m = (1-x0^2) P_m'(x0) the double series is
///
///     1/4 sum_{m != n} A_m A_n (1/m + 1/n) S_m P_n/(m - n) + 1/4 sum A_m^2 (2m+1)/m int P_m^2
///     - 1/4 (sum A_m S_m/m) (sum A_n P_n/n):
///
/// of 1/((m-n)(m+n+1)) in int P_m P_n the second factor cancels when the squares of both components are added.
double wall_speed_squared(const Harmonics& a) {
  const double eps = cap_depth(a.kappa);
  LegendreNearMinusOne<double> legendre(eps);
  std::vector<double> slope(a.amplitude.size());          // A_m S_m
  std::vector<std::complex<double>> value(slope.size());  // A_m P_m and, as imaginary part, A_m P_m/m
  double last = 1;
  double scaled_square = eps;  // (2m+1) int P_m^2 over the cap
  double diagonal = 0;
  double slopes = 0;
  double values = 0;
  double sign = 1;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const auto m = static_cast<double>(i + 1);
    legendre.advance();
    sign = -sign;
    const double p = legendre.value();
    const double d = legendre.last_difference();
    scaled_square += eps * (p * p + last * last) - d * d;
    last = p;
    const double amplitude = a.amplitude[i];
    diagonal += amplitude * amplitude * (2 - scaled_square) / m;
    slope[i] = -sign * amplitude * m * (m + 1) * legendre.integral();
    value[i] = {sign * amplitude * p, sign * amplitude * p / m};
    slopes += slope[i] / m;
    values += value[i].imag();
  }
  const auto divided = divided_differences(std::move(value));
  double off_diagonal = 0;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    off_diagonal += slope[i] * (divided[i].real() / static_cast<double>(i + 1) + divided[i].imag());
  }
  return (off_diagonal + diagonal - slopes * values) / 4;
}

}  // namespace

TruncatedForce truncated_force(const Harmonics& a) {
  const double eps = cap_depth(a.kappa);
  const double height = 1 - eps;
  const double area = 2 - eps;
  const double rate = eps * area / height;
  LegendreNearMinusOne<double> legendre(eps);
  double inertial = 0;
  double centripetal = 0;
  double speed = 0;  // -W
  double power = 1;  // (eps - 1)^(m-1)
  double sign = 1;
  for (std::size_t i = 0; i < a.amplitude.size(); ++i) {
    const auto m = static_cast<double>(i + 1);
    legendre.advance();
    sign = -sign;
    speed += a.amplitude[i] / 2 * power;
    power *= -height;
    const double mean = -sign * legendre.integral() - area * power;  // of (r^m P_m) over the wall, less in the orifice
    inertial += a.amplitude[i] / m * mean;
    centripetal += (a.change[i] * rate + a.amplitude[i] * (m - 1)) / (2 * m) * mean;
  }
  const double first = area * speed * speed / 2;
  const double rest = rate * area * area / (2 * height * height) + centripetal + first;
  return {pi * (area * area / height + inertial), 2 * pi * (rest - wall_speed_squared(a) / 2), 2 * pi * rest,
          2 * pi * first};
}

}  // namespace turgor
