#pragma once
// The pictures of `turgor verify`.

#include <filesystem>
#include <string>

#include "turgor/run/response_verification.hpp"
#include "turgor/run/verification.hpp"

namespace turgor {

/// Draws verify.{svg,png} into a folder: the dictated motion, normalised, over the force by finite elements and by each
/// closure, over the difference of the latter from the former.
/// @return what went wrong, in words for a warning; empty when all is well
[[nodiscard]] std::string draw_verification(const Case& c, const Verification& verification,
                                            const std::filesystem::path& folder);

/// The same of an elastic balloon: the pressure, over the radius by finite elements and by each model, over the
/// difference of the latter from the former.
[[nodiscard]] std::string draw_verification(const Case& c, const ResponseVerification& verification,
                                            const std::filesystem::path& folder);

}  // namespace turgor
