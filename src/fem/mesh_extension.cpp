#include "turgor/fem/mesh_extension.hpp"

#include "turgor/base/errors.hpp"
#include "turgor/fem/flow_cell.hpp"

namespace turgor {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Stiffness between all nodes.
Triplets stiffness(const FlowSpace& space) {
  Triplets entries;
  for (const auto& cell : space.cells()) {
    NodalVector<double> x{};
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      for (std::size_t c = 0; c < 2; ++c) x[c][i] = space.nodes()[static_cast<std::size_t>(cell.nodes[i])][c];
    }
    double area = 0;
    std::array<std::array<double, velocity_nodes>, velocity_nodes> sum{};
    for (const ShapeValues& shape : space.element().points()) {
      const CellPoint at = cell_point(shape, x);
      const double w = shape.weight * at.jacobian;
      area += w;
      for (std::size_t i = 0; i < velocity_nodes; ++i) {
        for (std::size_t j = 0; j < velocity_nodes; ++j) {
          sum[i][j] += w * (at.gradient[0][i] * at.gradient[0][j] + at.gradient[1][i] * at.gradient[1][j]);
        }
      }
    }
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      for (std::size_t j = 0; j < velocity_nodes; ++j) {
        entries.emplace_back(cell.nodes[i], cell.nodes[j], sum[i][j] / area);
      }
    }
  }
  return entries;
}

constexpr int none = -1;

/// Number of each of some nodes among them, `none` for the others.
std::vector<int> numbers_of(const std::vector<int>& some, std::size_t nodes) {
  std::vector<int> numbers(nodes, none);
  for (std::size_t k = 0; k < some.size(); ++k) numbers[static_cast<std::size_t>(some[k])] = static_cast<int>(k);
  return numbers;
}

/// Nodes that stay where they are in a direction: the orifice, all below it, and to the side those on the axis.
std::vector<bool> held(const FlowSpace& space, std::size_t component) {
  std::vector<bool> stays;
  for (const Point2& X : space.nodes()) stays.push_back(X[1] <= 0);
  if (component == 0) {
    for (const int node : space.nodes_on(Side::axis)) stays[static_cast<std::size_t>(node)] = true;
  }
  return stays;
}

}  // namespace

MeshExtension::MeshExtension(const FlowSpace& space, std::vector<int> wall) : wall_(std::move(wall)) {
  const std::size_t nodes = space.nodes().size();
  const std::vector<int> on_wall = numbers_of(wall_, nodes);
  const Triplets entries = stiffness(space);
  for (std::size_t c = 0; c < 2; ++c) {
    Component& part = components_[c];
    const std::vector<bool> stays = held(space, c);
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!stays[i] && on_wall[i] == none) part.inner.push_back(static_cast<int>(i));
    }
    const std::vector<int> number = numbers_of(part.inner, nodes);
    Triplets inner;
    Triplets to_wall;
    for (const auto& entry : entries) {
      const int i = number[static_cast<std::size_t>(entry.row())];
      const int j = number[static_cast<std::size_t>(entry.col())];
      const int k = on_wall[static_cast<std::size_t>(entry.col())];
      if (i != none && j != none) inner.emplace_back(i, j, entry.value());
      if (i != none && k != none) to_wall.emplace_back(i, k, entry.value());
    }
    const auto n = static_cast<Eigen::Index>(part.inner.size());
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(inner.begin(), inner.end());
    part.to_wall.resize(n, static_cast<Eigen::Index>(wall_.size()));
    part.to_wall.setFromTriplets(to_wall.begin(), to_wall.end());
    part.factors.compute(matrix);
    if (part.factors.info() != Eigen::Success) throw ComputationFailed("the mesh cannot be made to follow its wall");
  }
}

void MeshExtension::add(const Eigen::VectorXd& displacement, std::vector<double>& positions) const {
  const auto count = static_cast<Eigen::Index>(wall_.size());
  for (std::size_t c = 0; c < 2; ++c) {
    const Component& part = components_[c];
    Eigen::VectorXd given(count);
    for (Eigen::Index k = 0; k < count; ++k) given[k] = displacement[2 * k + static_cast<Eigen::Index>(c)];
    const Eigen::VectorXd inner = part.factors.solve(-(part.to_wall * given));
    for (std::size_t i = 0; i < part.inner.size(); ++i) {
      positions[2 * static_cast<std::size_t>(part.inner[i]) + c] += inner[static_cast<Eigen::Index>(i)];
    }
    for (std::size_t k = 0; k < wall_.size(); ++k) {
      positions[2 * static_cast<std::size_t>(wall_[k]) + c] += given[static_cast<Eigen::Index>(k)];
    }
  }
}

}  // namespace turgor
