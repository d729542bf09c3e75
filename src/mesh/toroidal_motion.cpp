#include "turgor/mesh/toroidal_motion.hpp"

#include <cmath>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

struct Angles {
  double sigma;  ///< under which the orifice is seen: pi on it, asin(a/r) on the wall
  double rest;   ///< pi - sigma, without loss of digits near the orifice
};

Angles angles(const std::array<double, 2>& X, double a) {
  const auto [r, z] = X;
  const double along = (r - a) * (r + a) + z * z;
  return {std::atan2(2 * a * z, along), std::atan2(2 * a * z, -along)};
}

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

// exp(-tau) = |a - x| / |a + x| for x = distance + i height, and 1 - exp(-2 tau) = 4 a distance / |a + x|^2: no
// difference of nearly equal numbers on the axis, at the rim or far away.
std::array<double, 2> ToroidalMotion::position(std::array<double, 2> X, double radius) const {
  const double wall = wall_angle(radius);
  const auto [r, z] = X;
  const double a = orifice_radius_;
  if (z <= 0) return X;
  const Angles before = angles(X, a);
  const double scale = (pi - wall) / (pi - reference_wall_);
  const double sigma = wall + scale * (before.sigma - reference_wall_);
  const double sine = sigma < pi / 2 ? std::sin(sigma) : std::sin(scale * before.rest);
  const double half = std::sin(sigma / 2);
  const double far = std::hypot(r + a, z);
  const double ratio = std::hypot(r - a, z) / far;
  const double spread = 4 * a * r / (far * far);
  const double gap = spread / (1 + ratio);
  const double denominator = gap * gap + 4 * ratio * half * half;
  return {a * spread / denominator, 2 * a * ratio * sine / denominator};
}

// With x = distance + i height: dx/dsigma = -i (a^2 - x^2)/(2a) at fixed tau.
std::array<double, 2> ToroidalMotion::rate(std::array<double, 2> X, double radius) const {
  const auto [r, z] = position(X, radius);
  if (X[1] <= 0) return {0, 0};
  const double a = orifice_radius_;
  const double wall_rate = a / (radius * std::sqrt((radius - a) * (radius + a)));
  const double angle_rate = wall_rate * angles(X, a).rest / (pi - reference_wall_);
  return {angle_rate * r * z / a, angle_rate * ((a - r) * (a + r) + z * z) / (2 * a)};
}

}  // namespace turgor
