#pragma once
// Pictures of computed flows.

#include <filesystem>
#include <string>

#include "turgor/run/vtu.hpp"

namespace turgor {

/// What the picture of a flow says besides the flow.
struct FieldPicture {
  std::string title;
  std::string subtitle;
  double orifice_radius;    ///< [m]
  std::string length_unit;  ///< of the axes
};

/// Draws NAME.{svg,png} into a folder, with its script: the balloon in the meridional plane and its orifice enlarged,
/// the speed as colours over three decades, and streamlines, between any two of which runs the same flux.
/// @param grid  biquadratic cells with points (distance from the axis, height, 0) [m] and the point data `velocity`
/// [m/s]
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_field(const VtuGrid& grid, const FieldPicture& about,
                                     const std::filesystem::path& folder, const std::string& name);

}  // namespace turgor
