#pragma once
// The flow in a balloon of dictated motion by finite elements.

#include <memory>

#include "turgor/fem/flow_problem.hpp"

namespace turgor {

/// The flow that a case with a [motion] describes, at rest at t = 0. Needs a FemSession while it lives.
/// @throws InvalidInput when the case cannot be meshed
/// @throws ComputationFailed when it cannot be solved
[[nodiscard]] std::unique_ptr<FlowProblem> make_flow_problem(const Case& c);

}  // namespace turgor
