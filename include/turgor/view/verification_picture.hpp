#pragma once
// The picture of `turgor verify`.

#include <filesystem>
#include <string>

#include "turgor/run/verification.hpp"

namespace turgor {

/// Draws verify.{svg,png} into a folder: the dictated motion, normalised, over the force by finite elements and by each
/// closure, over the difference of the latter from the former.
/// @return what went wrong, in words for a warning; empty when all is well
[[nodiscard]] std::string draw_verification(const Case& c, const Verification& verification,
                                            const std::filesystem::path& folder);

}  // namespace turgor
