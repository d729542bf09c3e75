#pragma once
// How the places of a balloon follow its radius: along circles through which the rim is seen under proportional angles.

#include <array>

namespace turgor {

/// Motion of a mesh with the balloon's radius by toroidal coordinates (tau, sigma) about the rim: tau stays, and
/// pi - sigma, the angle from the orifice's plane, is scaled so that the wall, sigma = asin(a/r), stays the wall.
/// The rim, the orifice's plane and everything below it stay where they are, the axis stays the axis, and the wall
/// remains a part of a sphere that moves along its normal only: with dr/dt (1 + r/z_c cos theta), where theta is the
/// angle at the centre from the axis and z_c = sqrt(r^2 - a^2) the height of the centre.
class ToroidalMotion {
 public:
  /// @param orifice_radius    a > 0 [m]
  /// @param reference_radius  of the sphere in the configuration whose places are given, above a [m]
  /// @throws InvalidInput when these are out of range
  ToroidalMotion(double orifice_radius, double reference_radius);

  /// Where the place X = (distance from the axis, height above the orifice) [m] of the reference configuration is for
  /// a sphere's radius above a [m]. X itself, to rounding, at the reference radius.
  /// @throws InvalidInput when the radius is not above a
  [[nodiscard]] std::array<double, 2> position(std::array<double, 2> X, double radius) const;

  /// Derivative of position() with respect to the radius at fixed X, exact.
  [[nodiscard]] std::array<double, 2> rate(std::array<double, 2> X, double radius) const;

 private:
  /// Angle sigma of the wall.
  [[nodiscard]] double wall_angle(double radius) const;

  double orifice_radius_;
  double reference_wall_;
};

}  // namespace turgor
