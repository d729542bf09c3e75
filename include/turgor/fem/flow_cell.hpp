#pragma once
// Weak form of the incompressible Navier-Stokes equations on one moving axisymmetric cell: residual and tangent.

#include <array>
#include <cmath>
#include <complex>

#include "turgor/fem/taylor_hood.hpp"

namespace turgor {

template <class T>
using NodalVector = std::array<std::array<T, velocity_nodes>, 2>;  ///< [component][node]

/// What a cell is made of at one instant. All nodal values are at the end of the time step.
struct CellState {
  NodalVector<double> position;       ///< [m]
  NodalVector<double> mesh_velocity;  ///< [m/s]
  NodalVector<double> history;        ///< du/dt = rate_factor u + history [m/s^2]
  NodalVector<double> frozen;         ///< velocity that sizes the stabilisation [m/s]
  NodalVector<double> body_force;     ///< [N/m^3]
};

struct CellSettings {
  double density;      ///< [kg/m^3]
  double viscosity;    ///< dynamic [Pa s]
  double rate_factor;  ///< of the time scheme [1/s]
  double time_step;    ///< [s]
  double supg;         ///< factor of the streamline-upwind term: 1, or 0 without it
  double grad_div;     ///< factor of the grad-div term
};

template <class T>
struct CellResidual {
  NodalVector<T> momentum;                   ///< per radian [N/rad]
  std::array<T, pressure_nodes> continuity;  ///< [m^3/s/rad]
};

/// Derivatives of the residual, unknowns as in FlowSpace::unknowns().
using CellTangent = std::array<std::array<double, cell_unknowns>, cell_unknowns>;

/// Geometry of a cell at one quadrature point.
struct CellPoint {
  double radius;                                               ///< [m]
  double volume;                                               ///< r dr dz [m^3/rad]
  double jacobian;                                             ///< determinant of d(r,z)/d(xi,eta) [m^2]
  std::array<std::array<double, velocity_nodes>, 2> gradient;  ///< d/dr, d/dz [1/m]
  std::array<double, velocity_nodes> laplacian;                ///< (d2/dr2 + 1/r d/dr + d2/dz2) [1/m^2]
  std::array<std::array<double, pressure_nodes>, 2> pressure_gradient;
  std::array<double, 3> metric;  ///< of the inverse map: rr, rz, zz [1/m^2]
};
/// @pre the cell is not inverted; a jacobian that is not positive is returned as such and nothing else can be used
[[nodiscard]] CellPoint cell_point(const ShapeValues& shape, const NodalVector<double>& position);

/// Parameters of the stabilisation at a point.
struct Stabilization {
  double streamline;  ///< tau [s]
  double grad_div;    ///< gamma [Pa s]
};
/// tau = [(2/dt)^2 + 16 a.G.a + (144 nu)^2 G:G / 9]^{-1/2}, G the metric of the inverse map, which counts the distance
/// between nodes as the length: Shakib, Hughes & Johan, Comput. Methods Appl. Mech. Eng. 89 (1991) 141.
/// gamma = grad_div rho |a| h with h^2 = the cell's area: Olshanskii, Lube, Heister & Loewe, ibid. 198 (2009) 3975.
[[nodiscard]] Stabilization stabilization(const CellPoint& at, const CellSettings& s, const std::array<double, 2>& a);

/// Values and derivatives of the solution at a point.
template <class T>
struct PointValues {
  std::array<T, 2> velocity{};
  std::array<std::array<T, 2>, 2> gradient{};  ///< [component][direction]
  std::array<T, 2> laplacian{};
  T divergence{};
  T pressure{};
  std::array<T, 2> pressure_gradient{};
  std::array<T, 2> rate{};       ///< du/dt on the moving mesh
  std::array<T, 2> advection{};  ///< velocity relative to the mesh
  std::array<T, 2> strong{};     ///< residual of the momentum equation [N/m^3]
  std::array<double, 2> force{};
};

template <class T>
[[nodiscard]] PointValues<T> point_values(const ShapeValues& shape, const CellPoint& at, const CellSettings& s,
                                          const CellState& cell, const NodalVector<T>& u,
                                          const std::array<T, pressure_nodes>& p) {
  PointValues<T> v;
  for (std::size_t c = 0; c < 2; ++c) {
    T history{};
    T mesh{};
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      v.velocity[c] += shape.value[i] * u[c][i];
      v.gradient[c][0] += at.gradient[0][i] * u[c][i];
      v.gradient[c][1] += at.gradient[1][i] * u[c][i];
      v.laplacian[c] += at.laplacian[i] * u[c][i];
      history += shape.value[i] * cell.history[c][i];
      mesh += shape.value[i] * cell.mesh_velocity[c][i];
      v.force[c] += shape.value[i] * cell.body_force[c][i];
    }
    v.rate[c] = s.rate_factor * v.velocity[c] + history;
    v.advection[c] = v.velocity[c] - mesh;
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) {
    v.pressure += shape.pressure[i] * p[i];
    v.pressure_gradient[0] += at.pressure_gradient[0][i] * p[i];
    v.pressure_gradient[1] += at.pressure_gradient[1][i] * p[i];
  }
  v.divergence = v.gradient[0][0] + v.gradient[1][1] + v.velocity[0] / at.radius;
  v.laplacian[0] -= v.velocity[0] / (at.radius * at.radius);
  for (std::size_t c = 0; c < 2; ++c) {
    const T inertia = s.density * (v.rate[c] + v.advection[0] * v.gradient[c][0] + v.advection[1] * v.gradient[c][1]);
    v.strong[c] = inertia + v.pressure_gradient[c] - s.viscosity * v.laplacian[c] - v.force[c];
  }
  return v;
}

/// Advection that sizes the stabilisation: that of the frozen velocity, so that the residual has an exact tangent.
[[nodiscard]] std::array<double, 2> frozen_advection(const ShapeValues& shape, const CellState& cell);

/// Adds one point's share of
///   integral r dr dz { [rho (du/dt + a.grad u + (div u) u/2) - f].v + 2 mu D(u):D(v) + 2 mu u_r v_r/r^2 - p div v
///                      + gamma div u div v + tau (a.grad v).(strong residual) },   - integral r dr dz q div u,
/// a = u - mesh velocity. The half divergence is Temam's: of a velocity that is solenoidal in the mean only it makes
/// the convection neither gain nor lose energy. div v = dv_r/dr + v_r/r + dv_z/dz. T is double, or complex to check the
/// tangent.
template <class T>
void add_residual(const ShapeValues& shape, const CellPoint& at, const Stabilization& stable, const CellSettings& s,
                  const PointValues<T>& v, CellResidual<T>& out) {
  for (std::size_t i = 0; i < velocity_nodes; ++i) {
    const T upwind = stable.streamline * (v.advection[0] * at.gradient[0][i] + v.advection[1] * at.gradient[1][i]);
    for (std::size_t c = 0; c < 2; ++c) {
      const T inertia = s.density * (v.rate[c] + v.advection[0] * v.gradient[c][0] + v.advection[1] * v.gradient[c][1] +
                                     0.5 * v.divergence * v.velocity[c]) -
                        v.force[c];
      T stress = s.viscosity * ((v.gradient[c][0] + v.gradient[0][c]) * at.gradient[0][i] +
                                (v.gradient[c][1] + v.gradient[1][c]) * at.gradient[1][i]);
      double divergence = at.gradient[c][i];
      if (c == 0) {
        stress += 2 * s.viscosity * v.velocity[0] * shape.value[i] / (at.radius * at.radius);
        divergence += shape.value[i] / at.radius;
      }
      out.momentum[c][i] +=
          at.volume * (inertia * shape.value[i] + stress + (stable.grad_div * v.divergence - v.pressure) * divergence +
                       upwind * v.strong[c]);
    }
  }
  for (std::size_t i = 0; i < pressure_nodes; ++i) out.continuity[i] -= at.volume * shape.pressure[i] * v.divergence;
}

/// Adds one point's share of the tangent, with tau and gamma held.
void add_tangent(const ShapeValues& shape, const CellPoint& at, const Stabilization& stable, const CellSettings& s,
                 const PointValues<double>& v, CellTangent& out);

/// Residual of a cell, and its tangent when asked for.
/// @return the least Jacobian determinant at the quadrature points; when it is not positive nothing else was computed
template <class T>
double integrate_cell(const TaylorHood& element, const CellSettings& s, const CellState& cell, const NodalVector<T>& u,
                      const std::array<T, pressure_nodes>& p, CellResidual<T>& residual, CellTangent* tangent) {
  residual = {};
  if (tangent != nullptr) *tangent = {};
  double least = std::numeric_limits<double>::infinity();
  for (const ShapeValues& shape : element.points()) {
    const CellPoint at = cell_point(shape, cell.position);
    least = std::min(least, at.jacobian);
    if (!(at.jacobian > 0)) return at.jacobian;
    const Stabilization stable = stabilization(at, s, frozen_advection(shape, cell));
    const auto v = point_values(shape, at, s, cell, u, p);
    add_residual(shape, at, stable, s, v, residual);
    if constexpr (std::is_same_v<T, double>) {
      if (tangent != nullptr) add_tangent(shape, at, stable, s, v, *tangent);
    }
  }
  return least;
}

}  // namespace turgor
