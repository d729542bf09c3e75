#pragma once
// The balance of forces on a membrane at rest, as its solvers share it.

#include "turgor/membrane/equilibrium.hpp"

namespace turgor {

/// Of the unknowns that may change; a closed membrane, which nothing holds, is kept where it is by its first node.
struct Balance {
  std::vector<Eigen::Index> unknowns;
  Eigen::VectorXd force;                ///< elastic less that of the pressure [N/rad]
  Eigen::SparseMatrix<double> tangent;  ///< its derivatives at this pressure [N/m/rad]
};
/// @param volume  membrane.volume(places)
/// @throws ComputationFailed as Membrane::elastic()
[[nodiscard]] Balance balance_of(const Membrane& membrane, const Eigen::VectorXd& places, double pressure,
                                 const MembraneForm& volume);

/// Places with what follows from them.
[[nodiscard]] MembraneState state_at(const Membrane& membrane, const Eigen::VectorXd& places, double pressure);

}  // namespace turgor
