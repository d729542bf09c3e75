#include "turgor/statics/statics.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

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

std::vector<LimitPoint> limit_points(const Parameters<double>& p) {
  const auto slope = [&](double R) { return static_pressure(p, R).slope; };
  const double end = upper_end(p);
  // A geometric grid fine enough that two extrema closer than 0.2 % in R are the only ones that can be missed.
  constexpr int cells = 4000;
  const double ratio = std::pow(end, 1.0 / cells);
  std::vector<LimitPoint> points;
  double left = 1.0;
  double slope_left = slope(left);
  for (int i = 1; i <= cells; ++i) {
    const double right = i == cells ? end : std::pow(ratio, i);
    const double slope_right = slope(right);
    if (!std::isfinite(slope_right)) break;  // the energy has outgrown the floating-point range
    if ((slope_left > 0) != (slope_right > 0)) {
      const double R = root(slope, left, right);
      points.push_back({R, static_pressure(p, R).value, slope_left > 0});
    }
    left = right;
    slope_left = slope_right;
  }
  return points;
}

std::vector<Equilibrium> equilibria(const Parameters<double>& p, double pressure) {
  std::vector<double> ends{smallest_stretch, 1.0};
  for (const LimitPoint& point : limit_points(p)) ends.push_back(point.stretch);
  ends.push_back(upper_end(p));

  // Beyond locking the tension is infinite, outwards or inwards; the root finder wants numbers.
  const auto excess = [&](double R) {
    constexpr double huge = std::numeric_limits<double>::max();
    const double difference = static_pressure(p, R).value - pressure;
    return std::isnan(difference) ? (R < 1 ? -huge : huge) : std::clamp(difference, -huge, huge);
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
