#pragma once
// A computed flow as a grid for VTK.

#include "turgor/fem/flow_solver.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor {

/// Biquadratic cells in their present configuration, points (distance from the axis, height, 0) [m], with `velocity`
/// [m/s], `pressure` [Pa], `displacement` from the configuration at t = 0 [m], `mesh_velocity` [m/s].
[[nodiscard]] VtuGrid flow_fields(const FlowSolver& solver);

}  // namespace turgor
