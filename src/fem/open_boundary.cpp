#include "turgor/fem/open_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace turgor {

namespace {

/// Calls visit(place in the plane's list of each of the edge's nodes, shape values, r dr) for every quadrature point.
template <class Visit>
void for_points(const FlowSpace& space, const std::vector<int>& nodes, const std::vector<const FlowSpace::Edge*>& edges,
                const Visit& visit) {
  for (const FlowSpace::Edge* edge : edges) {
    std::array<std::size_t, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = static_cast<std::size_t>(std::ranges::lower_bound(nodes, edge->nodes[k]) - nodes.begin());
    }
    for (const EdgeValues& q : space.element().edge_points()) {
      double r = 0;
      double stretch = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = space.nodes()[static_cast<std::size_t>(edge->nodes[k])][0];
        r += q.value[k] * x;
        stretch += q.derivative[k] * x;
      }
      visit(at, q, q.weight * r * std::abs(stretch));
    }
  }
}

}  // namespace

OpenBoundary::OpenBoundary(const FlowSpace& space, const std::vector<bool>& free)
    : space_(space), nodes_(space.nodes_on(Side::inlet)) {
  for (const auto& edge : space.edges()) {
    if (edge.side == Side::inlet) edges_.push_back(&edge);
  }
  const std::size_t n = nodes_.size();
  std::vector<double> mass(n * n, 0.0);
  weight_.assign(n, 0.0);
  for_points(space_, nodes_, edges_, [&](const auto& at, const EdgeValues& q, double w) {
    for (std::size_t k = 0; k < 3; ++k) {
      weight_[at[k]] += w * q.value[k];
      for (std::size_t l = 0; l < 3; ++l) mass[at[k] * n + at[l]] += w * q.value[k] * q.value[l];
    }
    area_ += w;
  });
  // the deviation is u - m(u) psi with psi the sum of the free nodes' shape functions and m(u) = int u / int psi, so
  // that it vanishes for a uniform profile over the free nodes, and so does its share of the mean traction
  free_weight_.assign(n, 0.0);
  std::vector<double> row(n, 0.0);
  double total = 0;
  double square = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_free = free[static_cast<std::size_t>(nodes_[i])];
    if (is_free) {
      free_weight_[i] = weight_[i];
      total += weight_[i];
    }
    for (std::size_t j = 0; j < n; ++j) {
      if (!free[static_cast<std::size_t>(nodes_[j])]) continue;
      row[i] += mass[i * n + j];
      if (is_free) square += mass[i * n + j];
    }
  }
  axial_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      axial_[i * n + j] = mass[i * n + j] - (row[i] * weight_[j] + weight_[i] * row[j]) / total +
                          weight_[i] * weight_[j] * square / (total * total);
    }
  }
}

double OpenBoundary::inflow(const std::vector<double>& solution) const {
  double flux = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    flux += weight_[i] * solution[static_cast<std::size_t>(space_.velocity(nodes_[i], 1))];
  }
  return flux;
}

double OpenBoundary::entering_speed(const std::vector<double>& velocity) const {
  double speed = mean_inflow(velocity);
  for (const int node : nodes_) speed = std::max(speed, velocity[static_cast<std::size_t>(space_.velocity(node, 1))]);
  return speed;
}

OpenBoundary::Powers OpenBoundary::powers(const std::vector<double>& velocity,
                                          const std::vector<double>& frozen) const {
  Powers sum{};
  const std::size_t n = nodes_.size();
  const auto u = [&](std::size_t i, int component) {
    return velocity[static_cast<std::size_t>(space_.velocity(nodes_[i], component))];
  };
  for_points(space_, nodes_, edges_, [&](const auto& at, const EdgeValues& q, double w) {
    Point2 v{};
    for (std::size_t k = 0; k < 3; ++k) {
      v[0] += q.value[k] * u(at[k], 0);
      v[1] += q.value[k] * u(at[k], 1);
    }
    sum.kinetic += w * v[1] * (v[0] * v[0] + v[1] * v[1]) / 2;
  });
  const double speed = entering_speed(frozen);
  const std::vector<double> sideways = tangential(frozen);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      sum.penalty += speed * axial(i, j) * u(i, 1) * u(j, 1) + sideways[i * n + j] * u(i, 0) * u(j, 0);
    }
  }
  return sum;
}

std::vector<double> OpenBoundary::tangential(const std::vector<double>& velocity) const {
  const std::size_t n = nodes_.size();
  std::vector<double> matrix(n * n, 0.0);
  for_points(space_, nodes_, edges_, [&](const auto& at, const EdgeValues& q, double w) {
    double entering = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      entering += q.value[k] * velocity[static_cast<std::size_t>(space_.velocity(nodes_[at[k]], 1))];
    }
    if (entering <= 0) return;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) matrix[at[k] * n + at[l]] += w * entering * q.value[k] * q.value[l];
    }
  });
  return matrix;
}

}  // namespace turgor
