#include "turgor/fem/flow_cell.hpp"

// The loops over a cell's nodes are most of the assembly; compiled for several processors, of which the best is taken
// when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TURGOR_FOR_PROCESSORS __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define TURGOR_FOR_PROCESSORS
#endif

namespace turgor {

TURGOR_FOR_PROCESSORS CellPoint cell_point(const ShapeValues& shape, const NodalVector<double>& position) {
  CellPoint at{};
  std::array<std::array<double, 2>, 2> map{};  // d(r,z)/d(xi,eta)
  std::array<std::array<double, 3>, 2> curved{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      map[c][0] += shape.gradient[0][i] * position[c][i];
      map[c][1] += shape.gradient[1][i] * position[c][i];
      curved[c][0] += shape.hessian[0][i] * position[c][i];
      curved[c][1] += shape.hessian[1][i] * position[c][i];
      curved[c][2] += shape.hessian[2][i] * position[c][i];
    }
  }
  for (std::size_t i = 0; i < velocity_nodes; ++i) at.radius += shape.value[i] * position[0][i];
  at.jacobian = map[0][0] * map[1][1] - map[0][1] * map[1][0];
  if (!(at.jacobian > 0)) return at;
  at.volume = shape.weight * at.jacobian * at.radius;
  // d xi/dr, d xi/dz; d eta/dr, d eta/dz
  const std::array<std::array<double, 2>, 2> inverse{
      {{map[1][1] / at.jacobian, -map[0][1] / at.jacobian}, {-map[1][0] / at.jacobian, map[0][0] / at.jacobian}}};
  at.metric = {inverse[0][0] * inverse[0][0] + inverse[1][0] * inverse[1][0],
               inverse[0][0] * inverse[0][1] + inverse[1][0] * inverse[1][1],
               inverse[0][1] * inverse[0][1] + inverse[1][1] * inverse[1][1]};
  // contravariant metric of the unit square's coordinates: the Laplacian is g^ab (d_a d_b N - d_a d_b x . grad N)
  const double g0 = inverse[0][0] * inverse[0][0] + inverse[0][1] * inverse[0][1];
  const double g1 = inverse[0][0] * inverse[1][0] + inverse[0][1] * inverse[1][1];
  const double g2 = inverse[1][0] * inverse[1][0] + inverse[1][1] * inverse[1][1];
  const std::array<double, 2> bend{g0 * curved[0][0] + 2 * g1 * curved[0][1] + g2 * curved[0][2],
                                   g0 * curved[1][0] + 2 * g1 * curved[1][1] + g2 * curved[1][2]};
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    at.gradient[0][i] = inverse[0][0] * shape.gradient[0][i] + inverse[1][0] * shape.gradient[1][i];
    at.gradient[1][i] = inverse[0][1] * shape.gradient[0][i] + inverse[1][1] * shape.gradient[1][i];
    at.laplacian[i] = g0 * shape.hessian[0][i] + 2 * g1 * shape.hessian[1][i] + g2 * shape.hessian[2][i] -
                      bend[0] * at.gradient[0][i] - bend[1] * at.gradient[1][i] + at.gradient[0][i] / at.radius;
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) {
    at.pressure_gradient[0][i] =
        inverse[0][0] * shape.pressure_gradient[0][i] + inverse[1][0] * shape.pressure_gradient[1][i];
    at.pressure_gradient[1][i] =
        inverse[0][1] * shape.pressure_gradient[0][i] + inverse[1][1] * shape.pressure_gradient[1][i];
  }
  return at;
}

std::array<double, 2> frozen_advection(const ShapeValues& shape, const CellState& cell) {
  std::array<double, 2> a{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      a[c] += shape.value[i] * (cell.frozen[c][i] - cell.mesh_velocity[c][i]);
    }
  }
  return a;
}

Stabilization stabilization(const CellPoint& at, const CellSettings& s, const std::array<double, 2>& a) {
  const auto& g = at.metric;
  const double crossing = 16 * (a[0] * a[0] * g[0] + 2 * a[0] * a[1] * g[1] + a[1] * a[1] * g[2]);
  const double nu = s.viscosity / s.density;
  const double spreading = 16 * 9 * nu * nu * 16 * (g[0] * g[0] + 2 * g[1] * g[1] + g[2] * g[2]);
  const double rate = 2 / s.time_step;
  const double whole = rate * rate + crossing + spreading;
  return {whole > 0 ? s.supg / std::sqrt(whole) : 0.0,
          s.grad_div * s.density * std::sqrt((a[0] * a[0] + a[1] * a[1]) * at.jacobian)};
}

TURGOR_FOR_PROCESSORS void add_tangent(const ShapeValues& shape, const CellPoint& at, const Stabilization& stable,
                                       const CellSettings& s, const PointValues<double>& v, CellTangent& out) {
  constexpr std::size_t n = velocity_nodes;
  // copies, so that the compiler knows that the sums below do not change them
  const std::array<double, n> value = shape.value;
  const std::array<double, n> to_r = at.gradient[0];
  const std::array<double, n> to_z = at.gradient[1];
  const double mu = at.volume * s.viscosity;
  const double gamma = at.volume * stable.grad_div;
  const double tau = at.volume * stable.streamline;
  const double rho = at.volume * s.density;
  std::array<double, n> carried{};  // r rho (rate factor + a.grad) N_j, what the momentum equation makes of N_j
  std::array<double, n> spread{};   // r mu laplace N_j
  std::array<double, n> upwind{};   // tau a.grad N_i
  std::array<double, n> hoop{};     // N/r
  std::array<double, n> radial{};   // divergence of N in radial direction
  for (std::size_t j = 0; j < n; ++j) {
    const double along = v.advection[0] * to_r[j] + v.advection[1] * to_z[j];
    carried[j] = rho * (s.rate_factor * value[j] + along);
    spread[j] = mu * at.laplacian[j];
    upwind[j] = stable.streamline * along;
    hoop[j] = value[j] / at.radius;
    radial[j] = to_r[j] + hoop[j];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double test = value[i] + upwind[i];
    const double gr = to_r[i];
    const double gz = to_z[i];
    const double ring = mu * (2 * hoop[i] + upwind[i] / at.radius);
    const double half = rho / 2 * value[i];
    const double div_r = gamma * radial[i] + half * v.velocity[0];
    const double div_z = gamma * gz + half * v.velocity[1];
    const double opened = half * v.divergence;
    // du/dx_d tested, and the change of the upwinded test function
    const double rr = rho * test * v.gradient[0][0] + tau * gr * v.strong[0];
    const double rz = rho * test * v.gradient[0][1] + tau * gz * v.strong[0];
    const double zr = rho * test * v.gradient[1][0] + tau * gr * v.strong[1];
    const double zz = rho * test * v.gradient[1][1] + tau * gz * v.strong[1];
    for (std::size_t j = 0; j < n; ++j) {
      const double both =
          carried[j] * test + opened * value[j] + mu * (gr * to_r[j] + gz * to_z[j]) - upwind[i] * spread[j];
      out[i][j] += both + rr * value[j] + mu * gr * to_r[j] + div_r * radial[j] + ring * hoop[j];
      out[i][n + j] += rz * value[j] + mu * gz * to_r[j] + div_r * to_z[j];
      out[n + i][j] += zr * value[j] + mu * gr * to_z[j] + div_z * radial[j];
      out[n + i][n + j] += both + zz * value[j] + mu * gz * to_z[j] + div_z * to_z[j];
    }
    for (std::size_t k = 0; k < pressure_nodes; ++k) {
      const double p = at.volume * shape.pressure[k];
      const double push = at.volume * upwind[i];
      out[i][2 * n + k] += push * at.pressure_gradient[0][k] - p * radial[i];
      out[n + i][2 * n + k] += push * at.pressure_gradient[1][k] - p * gz;
      out[2 * n + k][i] -= p * radial[i];
      out[2 * n + k][n + i] -= p * gz;
    }
  }
}

}  // namespace turgor
