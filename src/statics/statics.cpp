#include "turgor/statics/statics.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

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

/// An extremum of W'(R)/R^2, and so of the static pressure.
struct Extremum {
  double stretch;
  bool maximum;
};

/// All of a material up to a stretch, found on a geometric grid so fine that only two extrema closer than 0.2 % in R
/// can be missed. Stretches at which the tension is not finite are left out.
std::vector<Extremum> find_extrema(const Material<double>& material, double to) {
  const auto slope = [&](double R) {
    const Jet<double> w = strain_energy(material, R);
    return (w.second - 2 * w.first / R) / (R * R);
  };
  constexpr double ratio = 1.001;
  std::vector<Extremum> found;
  double left = smallest_stretch;
  double slope_left = slope(left);
  while (left < to) {
    const double right = std::min(left * ratio, to);
    const double slope_right = slope(right);
    if (std::isfinite(slope_left) && std::isfinite(slope_right) && (slope_left > 0) != (slope_right > 0)) {
      found.push_back({root(slope, left, right), slope_left > 0});
    }
    left = right;
    slope_left = slope_right;
  }
  return found;
}

/// The extrema of a balloon's material. Those of the last material are remembered on each thread: the search takes 0.1
/// ms, and the members of a sweep often share their material. Nothing else has an influence on them.
const std::vector<Extremum>& extrema(const Parameters<double>& p) {
  thread_local std::optional<Material<double>> material;
  thread_local std::vector<Extremum> found;
  if (material != p.material) {
    material.reset();
    found = find_extrema(p.material, upper_end(p));
    material = p.material;
  }
  return found;
}

}  // namespace

std::vector<LimitPoint> limit_points(const Parameters<double>& p) {
  std::vector<LimitPoint> points;
  for (const auto& [R, maximum] : extrema(p)) {
    if (R > 1) points.push_back({R, static_pressure(p, R).value, maximum});
  }
  return points;
}

std::vector<Equilibrium> equilibria(const Parameters<double>& p, double pressure) {
  std::vector<double> ends{smallest_stretch};
  for (const Extremum& extremum : extrema(p)) ends.push_back(extremum.stretch);
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
