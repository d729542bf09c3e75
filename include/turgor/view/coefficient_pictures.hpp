#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "turgor/run/force_study.hpp"

namespace turgor {

/// Draws coefficients.{svg,png} into a folder, with its script: sizes of the relative errors of the paper's fits and of
/// the closer ones against kappa, beside the errors that the paper claims.
/// @param rows  at least two, kappa increasing
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_coefficients(const std::vector<CoefficientRow>& rows,
                                            const std::filesystem::path& folder);

/// Draws profile.{svg,png}: the normalised profile, and the factors against kappa.
/// @return as draw_coefficients()
[[nodiscard]] std::string draw_profile(const ProfileStudy& study, const std::filesystem::path& folder);

}  // namespace turgor
