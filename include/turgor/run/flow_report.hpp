#pragma once
// A snapshot of the flow as text and files; everything in SI units, pressures gauge.

#include <string>
#include <vector>

#include "turgor/run/flow_snapshot.hpp"

namespace turgor {

/// flow.json: the instant, the orifice, forces, profile, mesh.
[[nodiscard]] std::string flow_json(const Case& c, const FlowSnapshot& snapshot, const MeridionalFlow& field);

/// A place on the wall and what the liquid does there.
struct WallPoint {
  double theta;     ///< from the axis [rad]
  double way;       ///< along the wall to the rim [m]
  double distance;  ///< from the axis [m]
  double height;    ///< above the orifice's plane [m]
  double pressure;  ///< gauge [Pa]
  double velocity;  ///< along the wall towards the orifice, relative to the wall [m/s]
};
/// From the pole opposite the orifice to 1e-6 r_ch from the rim.
[[nodiscard]] std::vector<WallPoint> wall_points(const FlowSnapshot& snapshot);

/// wall.csv: the same with the columns theta [rad], s [m], r [m], z [m], p_gauge [Pa], velocity [m/s].
[[nodiscard]] std::string wall_csv(const FlowSnapshot& snapshot);

/// flow.vtu: an unstructured grid of VTK, quadrilaterals in the plane (r, z), z above the orifice's plane. Point data:
/// pressure [Pa], velocity [m/s] seen from the channel and velocity_relative [m/s] seen from the balloon's centre, the
/// potential [m^2/s] and the stream function [m^3/s] of the former.
[[nodiscard]] std::string flow_vtu(const FlowSnapshot& snapshot, const MeridionalFlow& field);

/// A few lines for the screen.
[[nodiscard]] std::string flow_summary(const Case& c, const FlowSnapshot& snapshot);

}  // namespace turgor
