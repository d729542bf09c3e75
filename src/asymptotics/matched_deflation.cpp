#include "turgor/asymptotics/matched_deflation.hpp"

#include <boost/math/special_functions/bernoulli.hpp>
#include <cmath>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr double pi_squared = std::numbers::pi * std::numbers::pi;
constexpr double ln2 = std::numbers::ln2;

/// ln cosh x for x >= 0, neither overflowing nor cancelling.
double log_cosh(double x) {
  if (x < 1) {
    const double half = std::sinh(x / 2);
    return std::log1p(2 * half * half);
  }
  return x + std::log1p(std::exp(-2 * x)) - ln2;
}

/// What the layer's variable x = R_i sqrt(gamma1) tau enters by.
struct Layer {
  double x, tanh, log_cosh, dilogarithm;
  explicit Layer(double at)
      : x(at), tanh(std::tanh(at)), log_cosh(turgor::log_cosh(at)), dilogarithm(dilogarithm_of_layer(at)) {}
};

}  // namespace

Gammas gammas(const FreeMotion& motion, double start) {
  const double C1 = motion.require_deflation().C1;
  const Jet<double> F = motion.force().at(start);
  const double R = start;
  const double r2 = R * R;
  const double r4 = r2 * r2;
  return {C1 * F.value / r4, C1 * (2 * F.value / R - F.first) / (r2 * R),
          C1 * (F.second - 12 * F.first / R + 42 * F.value / r2) / (2 * r4 * r2)};
}

double dilogarithm_of_layer(double x) {
  // Li2(1 - e^w) = -w - w^2/4 - sum B_2k w^(2k+1)/(2k+1)!, here with 0 <= w <= ln 2. The terms fall by (w/2 pi)^2 <=
  // 0.0122 and alternate: what is left out after eight is below 4 (w/2 pi)^18 w < 1e-16 w.
  const double w = std::log1p(std::exp(-2 * x));
  double term = w;  // w^(2k+1)/(2k+1)!
  double sum = 0;
  for (int k = 1; k <= 8; ++k) {
    term *= w * w / (2 * k * (2 * k + 1));
    sum += boost::math::bernoulli_b2n<double>(k) * term;
  }
  return -(w + w * w / 4 + sum);
}

MatchedDeflation::MatchedDeflation(const FreeMotion& motion, double start)
    : uniform_(motion, start),
      start_(start),
      delta_(1 / motion.require_deflation().C2),
      gammas_(gammas(motion, start)) {}

Estimate MatchedDeflation::judged(double value, double T) const {
  return {value, std::abs(value - uniform_.refined_at(T))};
}

Estimate MatchedDeflation::outer(double T) const {
  require_time(T);
  const auto [g1, g2, g3] = gammas_;
  const double R = start_;
  const double rate = std::sqrt(delta_ * g1) / R;                                           // sqrt(delta beta1)
  const double slowing = -std::sqrt(delta_) * (4 * g1 + g2) / (2 * R * R * std::sqrt(g1));  // sqrt(delta) beta2
  const double r2 = R * R;
  const double value = R - rate * T + delta_ * ln2 / r2 + rate * slowing * T * T / 2 -
                       delta_ * slowing * (1 + 2 * ln2) / (2 * r2) * T - rate * delta_ * g3 * power<3>(T) / 6;
  return judged(value, T);
}

Estimate MatchedDeflation::inner(double T) const {
  require_time(T);
  const auto [g1, g2, g3] = gammas_;
  const double r2 = start_ * start_;
  const Layer layer(start_ * std::sqrt(g1 / delta_) * T);
  const double L = layer.log_cosh;
  const double brace = layer.tanh * (layer.dilogarithm + pi_squared / 12 + layer.x * (layer.x + 1 - 2 * ln2)) - 2 * L;
  const double second = layer.x * layer.tanh + L * (L - 2) + g2 / (4 * g1) * brace;
  return judged(start_ - delta_ * L / r2 - delta_ * delta_ * second / (r2 * r2 * start_), T);
}

// (3.16) with Li2(-e^-2x) + Li2(-e^2x) = -pi^2/6 - 2 x^2 put in: its terms in pi^2 and half of those in gamma2 T^2
// cancel.
Estimate MatchedDeflation::composite(double T) const {
  require_time(T);
  const auto [g1, g2, g3] = gammas_;
  const double r2 = start_ * start_;
  const Layer layer(start_ * std::sqrt(g1 / delta_) * T);
  const double L = layer.log_cosh;
  const double first = L / r2 + g2 * layer.tanh * T * T / (4 * start_ * r2);
  const double middle = (3 * (4 * g1 + g2 * (1 - 2 * ln2)) * layer.tanh * T + 2 * start_ * r2 * g1 * g3 * power<3>(T)) /
                        (12 * r2 * r2 * std::sqrt(g1));
  const double second =
      (L * (L - 2) + g2 / (4 * g1) * ((layer.dilogarithm + pi_squared / 12) * layer.tanh - 2 * L)) / (r2 * r2 * start_);
  return judged(start_ - delta_ * (first + std::sqrt(delta_) * middle + delta_ * second), T);
}

Estimate MatchedDeflation::transition_time() const {
  const auto [g1, g2, g3] = gammas_;
  const double slowing = -(4 * g1 + g2);  // R^3 u'
  if (!(slowing > 0)) {
    throw InvalidInput("start", shortest(start_),
                       "(3.17) needs 4 gamma1 + gamma2 < 0: slow deflation does not slow down here",
                       "start closer to the equilibrium, or take the uniform solution");
  }
  const double r3 = power<3>(start_);
  const double product = 8 * r3 * start_ * g1 + 2 * (1 + 2 * ln2) * delta_ * start_ * slowing;
  const double square = slowing * slowing - g3 * product;
  if (square < 0) {
    throw InvalidInput("start", shortest(start_), "(3.17) is complex: the cubic polynomial of (3.16) has no minimum",
                       "start closer to the equilibrium, or take the uniform solution");
  }
  const double value = product / (2 * start_ * start_ * std::sqrt(delta_ * g1) * (slowing + std::sqrt(square)));
  return {value, std::abs(value - uniform_.refined_transition_time())};
}

}  // namespace turgor
