#pragma once
// A sphere of radius r through the rim of an orifice of radius a, cut off by the orifice's plane.

#include <cmath>
#include <numbers>

namespace turgor {

/// Volume [m^3].
inline double cap_volume(double r, double a) {
  const double height = r + std::sqrt((r - a) * (r + a));
  return std::numbers::pi * height * height * (3 * r - height) / 3;
}

/// Its derivative with respect to r [m^2].
inline double cap_volume_rate(double r, double a) {
  const double centre = std::sqrt((r - a) * (r + a));
  const double height = r + centre;
  const double height_rate = 1 + r / centre;
  return std::numbers::pi * (2 * height * height_rate * (3 * r - height) + height * height * (3 - height_rate)) / 3;
}

}  // namespace turgor
