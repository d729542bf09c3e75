#include "turgor/fem/flow_cell.hpp"

// The loops over a cell's nodes are most of the assembly; compiled for several processors, of which the best is taken
// when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TURGOR_FOR_PROCESSORS __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define TURGOR_FOR_PROCESSORS
#endif

namespace turgor {

TURGOR_FOR_PROCESSORS CellPoint cell_point(const ShapeValues& shape, const NodalVector<double>& x) {
  CellPoint at{};
  double map[2][2] = {};  // d(r,z)/d(xi,eta)
  double curved[2][3] = {};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      map[c][0] += shape.gradient[0][i] * x[c][i];
      map[c][1] += shape.gradient[1][i] * x[c][i];
      curved[c][0] += shape.hessian[0][i] * x[c][i];
      curved[c][1] += shape.hessian[1][i] * x[c][i];
      curved[c][2] += shape.hessian[2][i] * x[c][i];
    }
  }
  for (std::size_t i = 0; i < velocity_nodes; ++i) at.radius += shape.value[i] * x[0][i];
  at.jacobian = map[0][0] * map[1][1] - map[0][1] * map[1][0];
  if (!(at.jacobian > 0)) return at;
  at.volume = shape.weight * at.jacobian * at.radius;
  // d xi/dr, d xi/dz; d eta/dr, d eta/dz
  const double inverse[2][2] = {{map[1][1] / at.jacobian, -map[0][1] / at.jacobian},
                                {-map[1][0] / at.jacobian, map[0][0] / at.jacobian}};
  at.metric = {inverse[0][0] * inverse[0][0] + inverse[1][0] * inverse[1][0],
               inverse[0][0] * inverse[0][1] + inverse[1][0] * inverse[1][1],
               inverse[0][1] * inverse[0][1] + inverse[1][1] * inverse[1][1]};
  // contravariant metric of the unit square's coordinates: the Laplacian is g^ab (d_a d_b N - d_a d_b x . grad N)
  const double g0 = inverse[0][0] * inverse[0][0] + inverse[0][1] * inverse[0][1];
  const double g1 = inverse[0][0] * inverse[1][0] + inverse[0][1] * inverse[1][1];
  const double g2 = inverse[1][0] * inverse[1][0] + inverse[1][1] * inverse[1][1];
  const double bend[2] = {g0 * curved[0][0] + 2 * g1 * curved[0][1] + g2 * curved[0][2],
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
                                       const CellSettings& s, const detail::PointValues<double>& v, CellTangent& out) {
  constexpr std::size_t n = velocity_nodes;
  std::array<double, n>
      carried{};                   // rho (rate factor + a.grad) N_j, what the momentum equation makes of a velocity N_j
  std::array<double, n> upwind{};  // tau a.grad N_i
  std::array<double, n> hoop{};    // N/r
  std::array<double, n> radial{};  // its divergence when radial
  for (std::size_t j = 0; j < n; ++j) {
    const double along = v.advection[0] * at.gradient[0][j] + v.advection[1] * at.gradient[1][j];
    carried[j] = s.density * (s.rate_factor * shape.value[j] + along);
    upwind[j] = stable.streamline * along;
    hoop[j] = shape.value[j] / at.radius;
    radial[j] = at.gradient[0][j] + hoop[j];
  }
  const auto& axial = at.gradient[1];
  const double w = at.volume;
  for (std::size_t i = 0; i < n; ++i) {
    const double test = shape.value[i] + upwind[i];
    const double gr = at.gradient[0][i];
    const double gz = at.gradient[1][i];
    for (std::size_t j = 0; j < n; ++j) {
      const double hr = at.gradient[0][j];
      const double hz = at.gradient[1][j];
      const double stress = s.viscosity * (gr * hr + gz * hz);
      const double both = w * (carried[j] * test + stress - s.viscosity * upwind[i] * at.laplacian[j]);
      const double turned = w * s.density * test * shape.value[j];  // rho N_j d u/dx_d tested
      const double bent = w * stable.streamline * shape.value[j];   // change of the test function
      const double mu = w * s.viscosity;
      const double gamma = w * stable.grad_div;
      const double ring = mu * hoop[j] * (2 * hoop[i] + upwind[i] / at.radius);
      out[i][j] += both + turned * v.gradient[0][0] + bent * gr * v.strong[0] + mu * gr * hr +
                   gamma * radial[i] * radial[j] + ring;
      out[i][n + j] +=
          turned * v.gradient[0][1] + bent * gz * v.strong[0] + mu * gz * hr + gamma * radial[i] * axial[j];
      out[n + i][j] +=
          turned * v.gradient[1][0] + bent * gr * v.strong[1] + mu * gr * hz + gamma * axial[i] * radial[j];
      out[n + i][n + j] +=
          both + turned * v.gradient[1][1] + bent * gz * v.strong[1] + mu * gz * hz + gamma * axial[i] * axial[j];
    }
    for (std::size_t k = 0; k < pressure_nodes; ++k) {
      const double p = w * shape.pressure[k];
      out[i][2 * n + k] += w * upwind[i] * at.pressure_gradient[0][k] - p * radial[i];
      out[n + i][2 * n + k] += w * upwind[i] * at.pressure_gradient[1][k] - p * axial[i];
      out[2 * n + k][i] -= p * radial[i];
      out[2 * n + k][n + i] -= p * axial[i];
    }
  }
}

}  // namespace turgor
