#pragma once
// Liquid and elastic wall together, section 2.5 of the paper, by finite elements.

#include <memory>

#include "turgor/fem/flow_problem.hpp"

namespace turgor {

/// The balloon that a case describes, at rest at t = 0 with the volume of [initial], under the pressure at its inlet:
/// the Navier-Stokes equations in a mesh that follows the wall, which is an elastic membrane with both stretches, with
/// inertia, bending stiffness and damping. One system for liquid and wall: the wall's places follow from its
/// velocities, which are the liquid's there. Needs a FemSession while it lives.
/// @throws InvalidInput when the case cannot be meshed, dictates the radius, or starts with a velocity
[[nodiscard]] std::unique_ptr<FlowProblem> make_coupled_flow(const Case& c);

}  // namespace turgor
