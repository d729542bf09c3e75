#pragma once

#include <filesystem>
#include <string>

#include "turgor/run/portrait_report.hpp"

namespace turgor {

/// Draws NAME.{svg,png} into a folder, with its script: dR/dt against R in two panels that join at dR/dt = 0, each
/// on a scale of its own, since inflation can be a hundred thousand times as fast as slow deflation. Both axes go with
/// the square root of the rate, so that motion about all equilibria can be seen.
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_phase_portrait(const Case& c, const PortraitStudy& study,
                                              const std::filesystem::path& folder,
                                              const std::string& name = "portrait");

}  // namespace turgor
