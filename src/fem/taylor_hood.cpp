#include "turgor/fem/taylor_hood.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

namespace turgor {

namespace {

ShapeValues shape_values(const dealii::FE_Q<2>& velocity, const dealii::FE_Q<2>& pressure, const dealii::Point<2>& x,
                         double weight) {
  ShapeValues s;
  s.weight = weight;
  for (unsigned i = 0; i < velocity_nodes; ++i) {
    s.value[i] = velocity.shape_value(i, x);
    const auto gradient = velocity.shape_grad(i, x);
    const auto hessian = velocity.shape_grad_grad(i, x);
    for (unsigned d = 0; d < 2; ++d) s.gradient[d][i] = gradient[d];
    s.hessian[0][i] = hessian[0][0];
    s.hessian[1][i] = hessian[0][1];
    s.hessian[2][i] = hessian[1][1];
  }
  for (unsigned i = 0; i < pressure_nodes; ++i) {
    s.pressure[i] = pressure.shape_value(i, x);
    const auto gradient = pressure.shape_grad(i, x);
    for (unsigned d = 0; d < 2; ++d) s.pressure_gradient[d][i] = gradient[d];
  }
  return s;
}

}  // namespace

TaylorHood::TaylorHood() {
  const dealii::FE_Q<2> velocity(2);
  const dealii::FE_Q<2> pressure(1);
  const dealii::QGauss<2> rule(points_per_direction);
  for (unsigned q = 0; q < rule.size(); ++q) {
    points_.push_back(shape_values(velocity, pressure, rule.point(q), rule.weight(q)));
  }
  for (unsigned i = 0; i < velocity_nodes; ++i) {
    nodes_[i] = {velocity.get_unit_support_points()[i][0], velocity.get_unit_support_points()[i][1]};
  }
  const dealii::FE_Q<1> edge(2);
  const dealii::QGauss<1> edge_rule(points_per_direction);
  for (unsigned q = 0; q < edge_rule.size(); ++q) {
    const auto x = edge_rule.point(q);
    EdgeValues values{.weight = edge_rule.weight(q), .value = {}, .derivative = {}, .pressure = {1 - x[0], x[0]}};
    for (unsigned i = 0; i < 3; ++i) {
      values.value[i] = edge.shape_value(i, x);
      values.derivative[i] = edge.shape_grad(i, x)[0];
    }
    edge_points_.push_back(values);
  }
}

}  // namespace turgor
