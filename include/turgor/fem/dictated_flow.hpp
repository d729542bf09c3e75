#pragma once
// The flow in a balloon whose radius is dictated, section 2.3 of the paper, by finite elements.

#include <memory>

#include "turgor/fem/flow_problem.hpp"

namespace turgor {

/// The flow that a case with a [motion] describes, at rest at t = 0, by the Navier-Stokes equations on a mesh that
/// follows the balloon: a spherical wall through the fixed rim that moves along its normal, the channel's walls, and
/// the inlet with its mean normal traction. Needs a FemSession while it lives.
/// @throws InvalidInput when the case cannot be meshed
[[nodiscard]] std::unique_ptr<FlowProblem> make_dictated_flow(const Case& c);

}  // namespace turgor
