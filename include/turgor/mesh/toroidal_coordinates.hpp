#pragma once
// Toroidal coordinates in the meridian, about the rim of an orifice.

#include <array>

namespace turgor {

/// tau = ln(d2/d1), with the distances d1 and d2 from the rim (a, 0) and from its mirror image (-a, 0): 0 on the axis,
/// infinite at the rim. sigma is the angle under which the orifice's diameter is seen: pi on the orifice, 0 in its
/// plane outside. It and pi - sigma are both here because each is small, and has digits that matter, where the other is
/// not.
struct ToroidalCoordinates {
  double tau;
  double sigma;
  double rest;  ///< pi - sigma
};

/// Of a place (distance from the axis, height above the orifice) [m], rest in (-pi/2, 3/2 pi]: negative below the
/// orifice.
/// @param a  radius of the orifice, > 0 [m]
[[nodiscard]] ToroidalCoordinates toroidal_coordinates(std::array<double, 2> place, double a);

/// The place, inverse of toroidal_coordinates().
[[nodiscard]] std::array<double, 2> toroidal_place(const ToroidalCoordinates& at, double a);

}  // namespace turgor
