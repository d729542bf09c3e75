#include "turgor/statics/statics.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

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

/// What, besides its units, decides on the shape of the static pressure.
struct Shape {
  const Material<double>& material;
  double kappa;  ///< r_ch/r0; 0 for closures whose area is R^2

  explicit Shape(const Parameters<double>& p)
      : material(p.material), kappa(is_exact(p.closure) ? kappa_at(p, 1.0) : 0) {}

  /// W'(R)/a(R) and its slope, with the area a that the pressure works on.
  [[nodiscard]] StaticPressure operator()(double R) const {
    const Jet<double> w = strain_energy(material, R);
    double area = R * R;
    double log_slope = 2 / R;  // a'/a
    if (kappa > 0) {
      const ChannelFactors<double> h = channel_factors(kappa / R);
      area *= h.area;
      log_slope -= h.area_slope / h.area * kappa / (R * R);
    }
    return {w.first / area, (w.second - log_slope * w.first) / area};
  }

  [[nodiscard]] double least_stretch() const { return std::max(smallest_stretch, kappa / ForceTable::greatest_kappa); }
  [[nodiscard]] double greatest_stretch() const {
    const double most = std::min(largest_stretch, stretch_limit(material) * (1 - 1e-12));
    return kappa > 0 ? std::min(most, kappa / ForceTable::least_kappa) : most;
  }
};

}  // namespace

StaticPressure static_pressure(const Parameters<double>& p, double R) {
  const StaticPressure tension = Shape(p)(R);
  const double factor = p.thickness / p.radius;
  return {factor * tension.value, factor * tension.slope};
}

StretchLimits<double> statics_limits(const Parameters<double>& p) {
  const Shape shape(p);
  return {shape.least_stretch(), shape.greatest_stretch()};
}

namespace {

/// An extremum of the static pressure.
struct Extremum {
  double stretch;
  bool maximum;
};

/// All of them, found on a geometric grid so fine that only two extrema closer than 0.2 % in R can be missed. Stretches
/// at which the tension is not finite are left out.
std::vector<Extremum> find_extrema(const Shape& shape) {
  const auto slope = [&](double R) { return shape(R).slope; };
  constexpr double ratio = 1.001;
  const double to = shape.greatest_stretch();
  std::vector<Extremum> found;
  double left = shape.least_stretch();
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

/// The extrema of a balloon. Those of the last shape are remembered on each thread: the search takes 0.1 ms, and the
/// members of a sweep often share their material. Nothing else has an influence on them.
const std::vector<Extremum>& extrema(const Shape& shape) {
  thread_local std::optional<std::pair<Material<double>, double>> last;
  thread_local std::vector<Extremum> found;
  if (!last || last->first != shape.material || last->second != shape.kappa) {
    last.reset();
    found = find_extrema(shape);
    last.emplace(shape.material, shape.kappa);
  }
  return found;
}

}  // namespace

std::vector<LimitPoint> limit_points(const Parameters<double>& p) {
  std::vector<LimitPoint> points;
  for (const auto& [R, maximum] : extrema(Shape(p))) {
    if (R > 1) points.push_back({R, static_pressure(p, R).value, maximum});
  }
  return points;
}

std::vector<Equilibrium> equilibria(const Parameters<double>& p, double pressure) {
  const Shape shape(p);
  std::vector<double> ends{shape.least_stretch()};
  for (const Extremum& extremum : extrema(shape)) ends.push_back(extremum.stretch);
  ends.push_back(shape.greatest_stretch());

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
