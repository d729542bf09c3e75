#pragma once
// What flows under a dictated motion and with an elastic wall have in common.

#include "turgor/case/case.hpp"
#include "turgor/fem/energy_account.hpp"
#include "turgor/fem/flow_balance.hpp"
#include "turgor/fem/flow_problem.hpp"
#include "turgor/fem/flow_solver.hpp"
#include "turgor/mesh/balloon_mesh.hpp"

namespace turgor {

/// The mesh of a case for a balloon of some radius [m].
/// @throws InvalidInput when it cannot be made
[[nodiscard]] BalloonMesh mesh_of(const Case& c, double radius);

/// The liquid and its inlet; the motion is left open. Refers to the case.
[[nodiscard]] FlowDefinition liquid_of(const Case& c);

[[nodiscard]] FlowSize size_of(const FlowSpace& space);

/// Volume of the channel [m^3].
[[nodiscard]] double channel_volume(const Case& c);

/// The columns of a row that do not depend on what moves the wall.
[[nodiscard]] FlowRow row_of(const Case& c, double time, const FlowBalance& b, const EnergyAccount& energies);

/// When factorisations failed.
[[nodiscard]] std::vector<Warning> factorisation_warnings(const FlowSolver& solver);

}  // namespace turgor
