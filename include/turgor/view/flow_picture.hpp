#pragma once

#include <filesystem>
#include <string>

#include "turgor/run/flow_snapshot.hpp"

namespace turgor {

/// Draws NAME.{svg,png} into a folder, with its script: the balloon in the meridional plane and its orifice enlarged,
/// the pressure less that of the inlet as colours, and streamlines seen from the channel, between any two of which, and
/// from the axis to the first, runs the same share of the outflow. Colours end at the least pressure farther than a
/// tenth of r_ch from the rim, where it falls without bound.
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_flow(const Case& c, const FlowSnapshot& snapshot, const MeridionalFlow& field,
                                    const std::filesystem::path& folder, const std::string& name = "flow");

}  // namespace turgor
