#pragma once
// What the sources of this room share: the static pressure as a curve over R, its extrema and its monotone pieces.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "turgor/statics/statics.hpp"

namespace turgor {

/// Root of a continuous function with a change of sign on [lo, hi], to the last bits of the argument.
template <class Function>
[[nodiscard]] double root(const Function& f, double lo, double hi) {
  const double f_lo = f(lo);
  const double f_hi = f(hi);
  if (f_lo == 0) return lo;
  if (f_hi == 0) return hi;
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(f, lo, hi, f_lo, f_hi,
                                                         boost::math::tools::eps_tolerance<double>(53), iterations);
  return std::abs(f(bracket.first)) <= std::abs(f(bracket.second)) ? bracket.first : bracket.second;
}

/// What, besides its units, decides on the shape of the static pressure.
struct Shape {
  const Material<double>& material;
  double kappa;  ///< r_ch/r0; 0 for closures whose area is R^2

  explicit Shape(const Parameters<double>& p)
      : material(p.material), kappa(has_table(p.closure) ? kappa_at(p, 1.0) : 0) {}

  /// W'(R)/a(R) and its slope, with the area a that the pressure works on.
  [[nodiscard]] StaticPressure operator()(double R) const;

  // Between these stretches everything is sought.
  [[nodiscard]] double least_stretch() const;
  [[nodiscard]] double greatest_stretch() const;
};

/// Ratio of neighbouring stretches on the grid of a search: only two extrema closer than 0.2 % can be missed.
inline constexpr double search_ratio = 1.001;

/// An extremum of a curve over R.
struct Extremum {
  double stretch;
  bool maximum;
};

/// All of them between two stretches, from the curve's slope. Stretches at which it is not finite are left out.
template <class Slope>
[[nodiscard]] std::vector<Extremum> find_extrema(const Slope& slope, double from, double to) {
  std::vector<Extremum> found;
  double left = from;
  double slope_left = slope(left);
  while (left < to) {
    const double right = std::min(left * search_ratio, to);
    const double slope_right = slope(right);
    if (std::isfinite(slope_left) && std::isfinite(slope_right) && (slope_left > 0) != (slope_right > 0)) {
      found.push_back({root(slope, left, right), slope_left > 0});
    }
    left = right;
    slope_left = slope_right;
  }
  return found;
}

/// Extrema of the static pressure. Those of the last shape are remembered on each thread: the search takes 0.1 ms, and
/// the members of a sweep often share their material. Nothing else has an influence on them.
[[nodiscard]] const std::vector<Extremum>& extrema(const Shape& shape);

/// The stretch between two at which a curve, monotone in between, has a value; nothing when it does not reach it.
/// Tensions near locking outgrow every number and the root finder interpolates between numbers, so differences are
/// squeezed into [-1, 1].
/// @param scale  of the curve's ordinary values, > 0
template <class Value>
[[nodiscard]] std::optional<double> stretch_at(const Value& value, double target, double lo, double hi, double scale) {
  const auto excess = [&](double R) {
    const double difference = value(R) - target;
    if (!std::isfinite(difference)) return R < 1 ? -1.0 : 1.0;
    return difference / (std::abs(difference) + scale);
  };
  const double at_lo = excess(lo);
  const double at_hi = excess(hi);
  if ((at_lo > 0 && at_hi > 0) || (at_lo < 0 && at_hi < 0)) return std::nullopt;
  return root(excess, lo, hi);
}

/// A scale of static pressures [Pa]: of the wall, and of a given one.
[[nodiscard]] double pressure_scale(const Parameters<double>& p, double pressure);

}  // namespace turgor
