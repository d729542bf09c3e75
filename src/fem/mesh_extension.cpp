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

}  // namespace

MeshExtension::MeshExtension(const FlowSpace& space, std::vector<int> wall) : wall_(std::move(wall)) {
  constexpr int held = -1;
  const auto nodes = static_cast<std::size_t>(space.node_count());
  std::vector<int> wall_number(nodes, held);
  for (std::size_t k = 0; k < wall_.size(); ++k) wall_number[static_cast<std::size_t>(wall_[k])] = static_cast<int>(k);
  std::vector<bool> stays(nodes, false);
  for (std::size_t i = 0; i < nodes; ++i) stays[i] = space.nodes()[i][1] <= 0;
  for (const int node : space.nodes_on(Side::inlet)) stays[static_cast<std::size_t>(node)] = true;
  const Triplets entries = stiffness(space);
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<bool> given = stays;
    if (c == 0) {
      for (const int node : space.nodes_on(Side::axis)) given[static_cast<std::size_t>(node)] = true;
    }
    Component& part = components_[c];
    std::vector<int> number(nodes, held);
    for (std::size_t i = 0; i < nodes; ++i) {
      if (given[i] || wall_number[i] != held) continue;
      number[i] = static_cast<int>(part.inner.size());
      part.inner.push_back(static_cast<int>(i));
    }
    Triplets inner;
    Triplets to_wall;
    for (const auto& entry : entries) {
      const int i = number[static_cast<std::size_t>(entry.row())];
      if (i == held) continue;
      const int j = number[static_cast<std::size_t>(entry.col())];
      const int k = wall_number[static_cast<std::size_t>(entry.col())];
      if (j != held) inner.emplace_back(i, j, entry.value());
      if (k != held) to_wall.emplace_back(i, k, entry.value());
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
