#include "turgor/flow/force_coefficients.hpp"

#include <cmath>

#include "gauss_legendre.hpp"
#include "turgor/base/power.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

/// At the rim the velocity grows like a logarithm and nothing else happens at a smaller scale than the orifice, so that
/// in the logarithm of the distance from the rim everything is smooth.
FlowIntegrals flow_integrals(const PotentialFlow& flow) {
  const FlowField& orifice = flow.at_orifice();
  FlowIntegrals sum{orifice.potential, orifice.potential_change, -orifice.radial, 0, 0, 0};
  const double nearest = std::log(flow.tolerance() * flow.kappa() / 1000);
  const double farthest = std::log(flow.wall_angle());
  constexpr int points = 12;
  const GaussLegendre& rule = gauss_legendre(points);
  const double reach = 2.5 / std::max(1.0, -std::log10(flow.tolerance()) / 10);  // of one panel
  const int panels = static_cast<int>(std::ceil((farthest - nearest) / reach));
  const double length = (farthest - nearest) / panels;
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t i = 0; i < points; ++i) {
      const double offset = std::exp(nearest + length * (panel + rule.node[i]));
      const double weight = length * rule.weight[i] * offset * std::sin(flow.cap_angle() + offset);
      const FlowField field = flow.on_wall(offset);
      sum.wall_potential += weight * field.potential;
      sum.wall_potential_change += weight * field.potential_change;
      sum.wall_speed_squared += weight * field.tangential * field.tangential;
    }
  }
  return sum;
}

ForceCoefficients channel_coefficients(double eps) {
  const double height = 1 - eps;
  const double g2 = 2 * pi * power<2>(2 - eps) / (eps * height);
  return {2 * pi * (2 - eps), g2, 0, -g2 * (2 - 4 * eps + eps * eps) / (height * height), 0};
}

ForceCoefficients force_coefficients(double eps, const FlowIntegrals& flow) {
  const double height = 1 - eps;
  const double area = 2 - eps;
  const double rate = eps * area / height;  // -deps/dt r/(dr/dt)
  ForceCoefficients g = channel_coefficients(eps);
  g.g3 = 2 * pi * (area * area / (2 * height) + flow.wall_potential - area * flow.potential);
  g.g5 =
      2 * pi *
      (rate * area * area / (2 * height * height) + rate * (flow.wall_potential_change - area * flow.potential_change) +
       area * (1 + height * flow.speed + flow.potential) - flow.wall_potential +
       (area * flow.speed * flow.speed - area - flow.wall_speed_squared) / 2);
  return g;
}

ForceCoefficients force_coefficients(const PotentialFlow& flow) {
  return force_coefficients(flow.eps(), flow_integrals(flow));
}

ForceCoefficients paper_fits(double eps) {
  return {4 * pi, 8 * pi / eps, 36 / std::sqrt(eps), -16 * pi / eps, 24 / (eps * eps)};
}

/// Least squares of the relative error, after the leading terms that expansions of the flow about kappa = 0 give.
ForceCoefficients close_fits(double kappa) {
  const double eps = cap_depth(kappa);
  ForceCoefficients g = channel_coefficients(eps);
  g.g3 = 8 * pi * kappa / eps + 2 * pi * (2 * std::log(2 / kappa) - 5) + (10.6326 - 2.89064 * kappa) * kappa;
  g.g5 =
      8 * pi / (eps * eps) * (1 - std::sqrt(2 * eps) + ((2.91215 * kappa - 3.50821) * kappa + 1.85073) * kappa * kappa);
  return g;
}

}  // namespace turgor
