#include "turgor/mesh/toroidal_motion.hpp"

#include <cmath>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/mesh/toroidal_coordinates.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

ToroidalMotion::ToroidalMotion(double orifice_radius, double reference_radius) : orifice_radius_(orifice_radius) {
  if (!(orifice_radius > 0 && std::isfinite(orifice_radius))) {
    throw InvalidInput("orifice radius", shortest(orifice_radius), "must be a positive length");
  }
  reference_wall_ = wall_angle(reference_radius);
}

double ToroidalMotion::wall_angle(double radius) const {
  if (!(radius > orifice_radius_ && std::isfinite(radius))) {
    throw InvalidInput("radius", shortest(radius), "no sphere of this radius reaches around the orifice",
                       "allowed are radii above " + shortest(orifice_radius_) + " m");
  }
  return std::asin(orifice_radius_ / radius);
}

std::array<double, 2> ToroidalMotion::position(std::array<double, 2> X, double radius) const {
  const double wall = wall_angle(radius);
  if (X[1] <= 0) return X;
  ToroidalCoordinates at = toroidal_coordinates(X, orifice_radius_);
  const double scale = (pi - wall) / (pi - reference_wall_);
  at.sigma = wall + scale * (at.sigma - reference_wall_);
  at.rest *= scale;
  return toroidal_place(at, orifice_radius_);
}

// With x = distance + i height: dx/dsigma = -i (a^2 - x^2)/(2a) at fixed tau.
std::array<double, 2> ToroidalMotion::rate(std::array<double, 2> X, double radius) const {
  const auto [r, z] = position(X, radius);
  if (X[1] <= 0) return {0, 0};
  const double a = orifice_radius_;
  const double wall_rate = a / (radius * std::sqrt((radius - a) * (radius + a)));
  const double angle_rate = wall_rate * toroidal_coordinates(X, a).rest / (pi - reference_wall_);
  return {angle_rate * r * z / a, angle_rate * ((a - r) * (a + r) + z * z) / (2 * a)};
}

}  // namespace turgor
