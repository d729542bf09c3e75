#include "ring_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {

namespace {

/// Columns on the plane through the sphere's centre, over its radius: closest at the axis, where the jet is.
double column_share(double t) { return t * (0.65 + t * (0.9 - 0.55 * t)); }

double smooth_step(double t) { return t * t * (3 - 2 * t); }

}  // namespace

Place BipolarMap::place(const std::complex<double>& w) const {
  const std::complex<double> y = radius * std::tanh(w / 2.0);
  return {y.imag(), centre + y.real()};
}

std::complex<double> BipolarMap::strip(const Place& place) const {
  return 2.0 * std::atanh(std::complex<double>{place.imag() - centre, place.real()} / radius);
}

double core_outline(double turn, double opening) {
  constexpr double straight = 0.7;  // the outer corner opens to about 135 degrees, inside and outside alike
  const double nearest = std::min(turn, opening - turn);
  return 1 + straight * (1 / std::cos(nearest) - 1);
}

RingMap::RingMap(const MeshLayout& layout, const std::vector<Place>& first)
    : map_{layout.centre, layout.request.radius} {
  for (const Place& place : first) first_.push_back(map_.strip(place));
  first_.front() = first_.front().real();
  first_.back() = {first_.back().real(), std::numbers::pi / 2};
  bottom_ = std::ranges::max(first_, {}, [](const auto& w) { return w.real(); }).real();
  const MeshRequest& q = layout.request;
  const double far = std::min(3 * q.orifice_radius, layout.centre);
  free_ = std::max(map_.strip({0, far}).real(), bottom_ + 0.6);
  const double cap = static_cast<double>(layout.ring()) / 2 * q.wall / (2 * q.radius);
  top_ = -std::log(std::min(cap, 0.2));
}

Place RingMap::place(double level, std::size_t column) const {
  const double t = static_cast<double>(column) / static_cast<double>(first_.size() - 1);
  const double passed = std::min(1.0, (level - bottom_) / (free_ - bottom_));
  const double even = std::numbers::pi / 2 * t;
  const double in_cap = smooth_step(std::clamp(level - top_ + 1, 0.0, 1.0));
  double u = level + (first_[column].real() - bottom_) * (1 - passed);
  double v = std::lerp(first_[column].imag(), 2 * std::atan(column_share(t)), passed * (2 - passed));
  u -= in_cap * std::log(core_outline(even, std::numbers::pi / 2));
  v = std::lerp(v, even, in_cap);
  return map_.place({u, v});
}

}  // namespace turgor
