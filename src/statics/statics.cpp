#include "turgor/statics/statics.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace turgor {

namespace {

/// Root of a continuous function with a change of sign on [lo, hi], to the last bits of R.
template <class Function>
double root(const Function& f, double lo, double hi) {
  const double f_lo = f(lo);
  const double f_hi = f(hi);
  if (f_lo == 0) return lo;
  if (f_hi == 0) return hi;
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(f, lo, hi, f_lo, f_hi,
                                                         boost::math::tools::eps_tolerance<double>(53), iterations);
  return std::abs(f(bracket.first)) <= std::abs(f(bracket.second)) ? bracket.first : bracket.second;
}

double upper_end(const Parameters<double>& p) {
  return std::min(largest_stretch, stretch_limit(p.material) * (1 - 1e-12));
}

}  // namespace

StaticPressure static_pressure(const Parameters<double>& p, double R) {
  const Jet<double> w = strain_energy(p.material, R);
  const double factor = p.thickness / (p.radius * R * R);
  return {factor * w.first, factor * (w.second - 2 * w.first / R)};
}

namespace {

/// Extrema of the static pressure on [from, to], found on a geometric grid so fine that only two extrema closer than
/// 0.2 % in R can be missed. Stretches at which the tension is not finite are left out.
std::vector<LimitPoint> extrema(const Parameters<double>& p, double from, double to) {
  const auto slope = [&](double R) { return static_pressure(p, R).slope; };
  constexpr double ratio = 1.001;
  std::vector<LimitPoint> points;
  double left = from;
  double slope_left = slope(left);
  while (left < to) {
    const double right = std::min(left * ratio, to);
    const double slope_right = slope(right);
    if (std::isfinite(slope_left) && std::isfinite(slope_right) && (slope_left > 0) != (slope_right > 0)) {
      const double R = root(slope, left, right);
      points.push_back({R, static_pressure(p, R).value, slope_left > 0});
    }
    left = right;
    slope_left = slope_right;
  }
  return points;
}

}  // namespace

std::vector<LimitPoint> limit_points(const Parameters<double>& p) { return extrema(p, 1.0, upper_end(p)); }

std::vector<Equilibrium> equilibria(const Parameters<double>& p, double pressure) {
  std::vector<double> ends{smallest_stretch};
  for (const LimitPoint& point : extrema(p, smallest_stretch, upper_end(p))) ends.push_back(point.stretch);
  ends.push_back(upper_end(p));

  // Difference of pressures, squeezed into [-1, 1]: tensions near locking outgrow every number, and the root finder
  // interpolates between numbers.
  const double scale = std::abs(pressure) + p.thickness / p.radius * strain_energy(p.material, 1.0).second;
  const auto excess = [&](double R) {
    const double difference = static_pressure(p, R).value - pressure;
    if (!std::isfinite(difference)) return R < 1 ? -1.0 : 1.0;
    return difference / (std::abs(difference) + scale);
  };
  std::vector<Equilibrium> found;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {  // monotone in between
    if ((excess(ends[i]) > 0) == (excess(ends[i + 1]) > 0)) continue;
    const double R = root(excess, ends[i], ends[i + 1]);
    found.push_back({R, static_pressure(p, R).slope > 0});
  }
  return found;
}

}  // namespace turgor
