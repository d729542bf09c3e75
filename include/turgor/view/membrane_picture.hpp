#pragma once

#include <filesystem>
#include <string>

#include "turgor/run/membrane_study.hpp"

namespace turgor {

/// Draws statics.{svg,png} into a folder, with its script: gauge pressure against R of the membrane, stable and
/// unstable, over that of (3.1), and the difference of both; beside it shapes_of().
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_membrane(const Case& c, const MembraneStudy& study, const std::filesystem::path& folder);

}  // namespace turgor
