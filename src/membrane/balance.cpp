#include "balance.hpp"

#include <cmath>
#include <numbers>

namespace turgor {

namespace {

/// Rows and columns of a matrix.
Eigen::SparseMatrix<double> part(const Eigen::SparseMatrix<double>& whole, const std::vector<Eigen::Index>& kept) {
  std::vector<int> place(static_cast<std::size_t>(whole.rows()), -1);
  for (std::size_t i = 0; i < kept.size(); ++i) place[static_cast<std::size_t>(kept[i])] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index j = 0; j < whole.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(whole, j); it; ++it) {
      const int row = place[static_cast<std::size_t>(it.row())];
      const int column = place[static_cast<std::size_t>(it.col())];
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, it.value());
    }
  }
  const auto n = static_cast<Eigen::Index>(kept.size());
  Eigen::SparseMatrix<double> out(n, n);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace

Balance balance_of(const Membrane& membrane, const Eigen::VectorXd& places, double pressure,
                   const MembraneForm& volume) {
  std::vector<Eigen::Index> unknowns = membrane.free_unknowns();
  if (membrane.closed()) std::erase(unknowns, Eigen::Index{1});
  const MembraneForm elastic = membrane.elastic(places);
  Eigen::VectorXd force = (elastic.gradient - pressure * volume.gradient)(unknowns);
  const Eigen::SparseMatrix<double> tangent = elastic.hessian - pressure * volume.hessian;
  return {unknowns, std::move(force), part(tangent, unknowns)};
}

MembraneState state_at(const Membrane& membrane, const Eigen::VectorXd& places, double pressure) {
  const double a = membrane.rim_radius();
  return {places, pressure, 2 * std::numbers::pi * membrane.volume(places).value,
          std::sqrt(2 * membrane.area(places) + a * a) / 2};
}

}  // namespace turgor
