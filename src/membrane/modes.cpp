#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include "balance.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {

using Eigen::MatrixXd;
using Eigen::VectorXd;

UnstableModes unstable_modes(const Membrane& membrane, const MembraneState& state) {
  const MembraneForm volume = membrane.volume(state.places);
  const Balance balance = balance_of(membrane, state.places, state.pressure, volume);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(balance.tangent);
  if (factors.info() != Eigen::Success || !factors.vectorD().allFinite()) {
    throw ComputationFailed("the membrane's tangent is singular: its stability is neutral here");
  }
  const auto negative = static_cast<int>((factors.vectorD().array() < 0).count());  // Sylvester's law of inertia
  // Volume gained per pressure. Held at its volume, the membrane's tangent is that on the plane normal to the load,
  // which has one negative eigenvalue less where the volume falls with rising pressure.
  const VectorXd load = volume.gradient(balance.unknowns);
  const double compliance = load.dot(factors.solve(load));
  return {negative, negative - (compliance < 0 ? 1 : 0)};
}

Eigen::SparseMatrix<double> tangent_at_pressure(const Membrane& membrane, const MembraneState& state) {
  return membrane.elastic(state.places).hessian - state.pressure * membrane.volume(state.places).hessian;
}

std::vector<ShapeMode> shape_modes(const Membrane& membrane, const MembraneState& state, const MatrixXd& added_mass,
                                   std::size_t count) {
  const auto& free = membrane.free_unknowns();
  const MatrixXd tangent = tangent_at_pressure(membrane, state);
  const MatrixXd mass = MatrixXd(membrane.mass()) + added_mass;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(tangent(free, free), mass(free, free));
  if (solver.info() != Eigen::Success || !solver.eigenvalues().allFinite()) {
    throw ComputationFailed("the eigenvalue solver found no shape modes of the membrane");
  }
  std::vector<ShapeMode> modes;
  for (Eigen::Index i = 0; i < solver.eigenvalues().size() && modes.size() < count; ++i) {
    VectorXd shape = VectorXd::Zero(tangent.rows());
    shape(free) = solver.eigenvectors().col(i);
    modes.push_back({solver.eigenvalues()(i), shape});
  }
  return modes;
}

}  // namespace turgor
