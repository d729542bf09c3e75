#pragma once
// The flow in a balloon the instant after rest, against the potential flow that it must be.

#include <cstddef>

namespace turgor {

/// What the finite elements are off, relative to the root mean square of the exact flow, or to its force.
struct RestFlowErrors {
  double cell;  ///< size at the rim over the orifice's radius
  double velocity;
  double pressure;
  double force;  ///< on the wall
  double
      outflow;  ///< greatest, of means of u_z over edges within 0.9 of the orifice's radius, over the channel's speed
};

/// A balloon of radius 1 with an orifice kappa that begins to shrink. The wall has the velocity of the potential flow
/// of uniform outflow (2.5), tangential part included, and the plane of the orifice has its pressure: the uniform
/// outflow itself is for the solver to find.
/// @param fineness  over the usual one of docs/fem-mesh.md
[[nodiscard]] RestFlowErrors rest_flow_errors(double kappa, double fineness);

}  // namespace turgor
