#pragma once
// A snapshot of the flow as text and files; everything in SI units, pressures gauge.

#include <string>

#include "turgor/run/flow_snapshot.hpp"

namespace turgor {

/// flow.json: the instant, the orifice, forces, profile, mesh.
[[nodiscard]] std::string flow_json(const Case& c, const FlowSnapshot& snapshot, const MeridionalFlow& field);

/// wall.csv: from the pole opposite the orifice to 1e-6 r_ch from the rim. Columns: theta [rad] from the axis, s [m]
/// the way along the wall to the rim, r [m] the distance from the axis, z [m] the height above the orifice's plane,
/// p_gauge [Pa], velocity [m/s] along the wall towards the orifice, relative to the wall.
[[nodiscard]] std::string wall_csv(const FlowSnapshot& snapshot);

/// flow.vtu: an unstructured grid of VTK, quadrilaterals in the plane (r, z), z above the orifice's plane. Point data:
/// pressure [Pa], velocity [m/s] seen from the channel and velocity_relative [m/s] seen from the balloon's centre, the
/// potential [m^2/s] and the stream function [m^3/s] of the former.
[[nodiscard]] std::string flow_vtu(const FlowSnapshot& snapshot, const MeridionalFlow& field);

/// A few lines for the screen.
[[nodiscard]] std::string flow_summary(const Case& c, const FlowSnapshot& snapshot);

}  // namespace turgor
