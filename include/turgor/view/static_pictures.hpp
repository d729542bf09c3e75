#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "turgor/run/static_study.hpp"

namespace turgor {

/// Draws NAME.{svg,png} into a folder, with its script, in the manner of the paper's figure 7: static pressure
/// against R, stable and unstable, with limit points, bistable window, Maxwell's pressure and the equilibria at the
/// final pressure; below it the potential energy at that pressure.
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_statics(const Case& c, const StaticStudy& study, const std::filesystem::path& folder,
                                       const std::string& name = "statics");

/// Draws over.{svg,png}: equilibria against the key, and the bistable pressures against it. With a second key also
/// plane.{svg,png}: limit points in the plane of both.
/// @param study  of one key or two
[[nodiscard]] std::string draw_over(const Case& c, const StaticStudy& study, const std::filesystem::path& folder);

/// Labels and units of a bistability map.
struct MapLabels {
  std::string title;
  std::string parameter;      ///< label of the horizontal axis, with its unit
  std::string pressure;       ///< label of the vertical axis, with its unit
  double parameter_unit = 1;  ///< in units of the map's parameters
  double pressure_unit = 1;   ///< [Pa]
};

/// A place to mark in a map, in its own units.
struct MapMark {
  double parameter;
  double pressure;
};

/// Draws NAME.{svg,png}: the pressures with two stable states against a parameter, Maxwell's pressure and cusps.
/// @param map   at least one row
/// @param load  a line of marks to draw, such as a case's pressure against the parameter; may be empty
[[nodiscard]] std::string draw_bistability_map(const BistabilityMap& map, const MapLabels& labels,
                                               const std::vector<MapMark>& load, const std::filesystem::path& folder,
                                               const std::string& name);

}  // namespace turgor
