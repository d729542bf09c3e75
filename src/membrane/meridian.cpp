#include "turgor/membrane/meridian.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

Meridian spherical_meridian(double radius, double rim_radius, std::size_t elements, double growth) {
  if (!(radius > 0) || !std::isfinite(radius)) {
    throw InvalidInput("balloon.radius", shortest(radius) + " m", "must be positive and finite");
  }
  if (!(rim_radius >= 0) || rim_radius >= radius) {
    throw InvalidInput("inlet.orifice_radius", shortest(rim_radius) + " m", "out of range",
                       "allowed is from 0, for a closed sphere, to less than its radius " + shortest(radius) + " m");
  }
  if (elements < 1) throw InvalidInput("membrane.elements", "0", "must be at least 1");
  if (!(growth > 0) || !std::isfinite(growth)) {
    throw InvalidInput("membrane.growth", shortest(growth), "must be positive and finite");
  }
  const double start = std::asin(rim_radius / radius);  // angle from the lower pole
  const double ratio = elements > 1 ? std::pow(growth, 1 / static_cast<double>(elements - 1)) : 1.0;
  std::vector<double> sums{0};
  double length = 1;
  for (std::size_t e = 0; e < elements; ++e) {
    sums.push_back(sums.back() + length);
    length *= ratio;
  }
  const double centre = std::sqrt((radius - rim_radius) * (radius + rim_radius));
  const auto place = [&](double share) -> std::array<double, 2> {
    const double angle = start + (std::numbers::pi - start) * share;
    return {radius * std::sin(angle), centre - radius * std::cos(angle)};
  };
  Meridian meridian{{{rim_radius, 0}}};
  for (std::size_t e = 0; e < elements; ++e) {
    meridian.nodes.push_back(place((sums[e] + sums[e + 1]) / 2 / sums.back()));
    meridian.nodes.push_back(place(sums[e + 1] / sums.back()));
  }
  meridian.nodes.back()[0] = 0;
  return meridian;
}

}  // namespace turgor
