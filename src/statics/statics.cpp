#include "turgor/statics/statics.hpp"

#include <utility>

#include "shape.hpp"

namespace turgor {

StaticPressure Shape::operator()(double R) const {
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

double Shape::least_stretch() const { return std::max(smallest_stretch, kappa / ForceTable::greatest_kappa); }

double Shape::greatest_stretch() const {
  const double most = std::min(largest_stretch, stretch_limit(material) * (1 - 1e-12));
  return kappa > 0 ? std::min(most, kappa / ForceTable::least_kappa) : most;
}

const std::vector<Extremum>& extrema(const Shape& shape) {
  thread_local std::optional<std::pair<Material<double>, double>> last;
  thread_local std::vector<Extremum> found;
  if (!last || last->first != shape.material || last->second != shape.kappa) {
    last.reset();
    found = find_extrema([&](double R) { return shape(R).slope; }, shape.least_stretch(), shape.greatest_stretch());
    last.emplace(shape.material, shape.kappa);
  }
  return found;
}

double pressure_scale(const Parameters<double>& p, double pressure) {
  return std::abs(pressure) + p.thickness / p.radius * strain_energy(p.material, 1.0).second;
}

StaticPressure static_pressure(const Parameters<double>& p, double R) {
  const StaticPressure tension = Shape(p)(R);
  const double factor = p.thickness / p.radius;
  return {factor * tension.value, factor * tension.slope};
}

StretchLimits<double> statics_limits(const Parameters<double>& p) {
  const Shape shape(p);
  return {shape.least_stretch(), shape.greatest_stretch()};
}

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

  const double scale = pressure_scale(p, pressure);
  const auto value = [&](double R) { return static_pressure(p, R).value; };
  std::vector<Equilibrium> found;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {  // monotone in between
    const auto R = stretch_at(value, pressure, ends[i], ends[i + 1], scale);
    const bool known = R && !found.empty() && found.back().stretch == *R;  // a limit point ends two pieces
    if (R && !known) found.push_back({*R, static_pressure(p, *R).slope > 0});
  }
  return found;
}

}  // namespace turgor
