#include "ring.hpp"

#include <complex>
#include <limits>
#include <numbers>

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

/// Sum of the semiaxes of the ellipse with foci at the ends of [0, length] (scaled to [-1, 1]) through i pi/2: Gauss
/// rules of n points converge like its power -2n.
double ellipse(double length) {
  const std::complex<double> singularity(-1, pi / length);
  const std::complex<double> root = std::sqrt(singularity * singularity - 1.0);
  return std::max(std::abs(singularity + root), std::abs(singularity - root));
}

}  // namespace

RingQuadrature::RingQuadrature(double tolerance) : digits_(-std::log(tolerance)) {
  for (const int size : {4, 6, 8, 10, 12, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96, 112, 128}) {
    double shortest = 1e-3;
    double longest = 100;
    for (int i = 0; i < 40; ++i) {
      const double length = std::sqrt(shortest * longest);
      (2 * (size - 3) * std::log(ellipse(length)) >= digits_ ? shortest : longest) = length;
    }
    rules_.push_back({shortest, &gauss_legendre(size)});
  }
  rules_.back().greatest_length = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= most_midpoints; ++n) {
    for (int j = 0; j < n; ++j) {
      const double half_sine = std::sin((j + 0.5) * pi / (2 * n));
      midpoints_[static_cast<std::size_t>(n)].push_back(half_sine * half_sine);
    }
  }
}

const GaussLegendre& RingQuadrature::stretched_rule(double length) const {
  auto rule = rules_.begin();
  while (length > rule->greatest_length) ++rule;
  return *rule->rule;
}

/// Calls add(sin^2(psi/2), weight) at points of the half ring 0 < psi < pi, for integrands that are singular where the
/// squared distance nearest_squared + spread sin^2(psi/2) is zero. From afar the midpoint rule converges geometrically;
/// close by, psi = 2 q sinh w with q the relative distance.
template <class Add>
void RingQuadrature::over_ring(double nearest_squared, double spread, const Add& add) const {
  if (!(spread > 0)) {
    add(0.5, 1.0);  // on the axis or in the centre everything is linear in sin^2(psi/2)
    return;
  }
  const double relative = std::sqrt(nearest_squared / spread);
  const double midpoints = digits_ / (4 * std::asinh(relative)) + 2;  // one more for cos psi in the gradient
  if (midpoints <= most_midpoints && relative > 0.2) {
    const std::vector<double>& squares = midpoints_[static_cast<std::size_t>(midpoints)];
    const double weight = 1 / static_cast<double>(squares.size());
    for (const double square : squares) add(square, weight);
    return;
  }
  const double length = std::asinh(pi / (2 * relative));
  const GaussLegendre& rule = stretched_rule(length);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double e = std::exp(length * rule.node[i]);
    const double half_sine = std::sin(relative * (e - 1 / e) / 2);
    add(half_sine * half_sine, rule.weight[i] * length * relative * (e + 1 / e) / pi);
  }
}

RingField RingQuadrature::average(const RingTarget& target, double difference, double sine) const {
  const double half = std::sin(difference / 2);
  const double apart = 2 * half * half;                     // 1 - cos(difference)
  const double turn = 2 * half * std::cos(difference / 2);  // sin(difference)
  const double nearest = target.depth * target.depth + 2 * target.radius * apart;
  RingField sum;
  over_ring(nearest, 4 * target.radius * target.sine * sine, [&](double square, double weight) {
    const double versine = apart + 2 * target.sine * sine * square;  // 1 - cos gamma
    const double d = std::sqrt(target.depth * target.depth + 2 * target.radius * versine);
    const double per_d = 1 / d;
    const double per_d3 = per_d * per_d * per_d;
    const double denominator = target.depth + target.radius * versine + d;  // 1 - s cos gamma + d
    sum.potential += weight * (per_d - 1 + std::log(2 / denominator) / 2);
    sum.radial +=
        weight * ((target.depth - versine) * per_d3 + (2 * (1 - versine) - target.radius) * per_d / (2 * (1 + d)));
    sum.tangential += weight * (per_d3 + (1 + per_d) / (2 * denominator)) * (-turn - 2 * target.cosine * sine * square);
  });
  return sum;
}

double RingQuadrature::potential(const RingTarget& target, double difference, double sine) const {
  return average(target, difference, sine).potential;
}

}  // namespace turgor
