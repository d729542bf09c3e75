#include "flow_timings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "stopwatch.hpp"
#include "turgor/flow/force_table.hpp"
#include "turgor/flow/harmonics.hpp"

namespace turgor::bench {

namespace {

constexpr double kappa = 0.1;
constexpr double pi = std::numbers::pi;

double median(const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < 7; ++i) seconds.push_back(processor_seconds(work));
  std::ranges::nth_element(seconds, seconds.begin() + 3);
  return seconds[3];
}

std::vector<FlowPoint> places(const PotentialFlow& flow) {
  constexpr int along = 200;
  std::vector<FlowPoint> points;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < along; ++j) {
      // Up to the wall; what lies beyond the orifice is drawn back to its plane.
      const double theta = pi * (j + 0.5) / along;
      const double border = std::min(1.0, theta > pi / 2 ? (1 - flow.eps()) / -std::cos(theta) : 1.0);
      points.push_back({border * (i + 0.5) / along, theta});
    }
  }
  return points;
}

/// (2.6), cut where its terms have fallen below 1e-8 or after as many as reach everywhere but the rim.
FlowField series(const Harmonics& a, const FlowPoint& point) {
  const double x = std::cos(point.theta);
  const double sine = std::sin(point.theta);
  FlowField sum{};
  double before = 1;
  double p = x;
  double slope = 1;
  double power = 1;
  for (int m = 1; m <= a.count() && power > 1e-11; ++m) {
    const double amplitude = a.amplitude[static_cast<std::size_t>(m - 1)] * power / 2;
    sum.potential += amplitude / m * point.radius * p;
    sum.potential_change += a.change[static_cast<std::size_t>(m - 1)] * power / (2 * m) * point.radius * p;
    sum.radial += amplitude * p;
    sum.tangential -= amplitude / m * slope * sine;
    const double after = ((2 * m + 1) * x * p - m * before) / (m + 1);
    slope = x * slope + (m + 1) * p;
    before = p;
    p = after;
    power *= point.radius;
  }
  return sum;
}

double greatest_error(const PotentialFlow& flow, const std::vector<FlowPoint>& points) {
  const PotentialFlow exact(kappa, OutflowProfile::uniform(), 1e-15);
  double greatest = 0;
  for (const FlowPoint& point : points) {
    const double from_rim =
        std::hypot(point.radius * std::sin(point.theta) - kappa, point.radius * std::cos(point.theta) + 1 - flow.eps());
    if (from_rim < kappa / 10) continue;
    const FlowField a = flow.at(point);
    const FlowField b = exact.at(point);
    const double error = std::hypot(a.radial - b.radial, a.tangential - b.tangential);
    greatest = std::max(greatest, error / std::hypot(b.radial, b.tangential));
  }
  return greatest;
}

/// The double series as it stands, with v^2 integrated over the wall term by term from the velocities at as many points
/// as make it exact.
double by_terms(int count) {
  const Harmonics a = uniform_harmonics(kappa, count);
  double sum = 0;
  for (int i = 0; i < 2 * count; ++i) {
    const double theta = (pi - std::asin(kappa)) * (i + 0.5) / (2 * count);
    const FlowField v = series(a, {1, theta});
    sum += std::sin(theta) * (v.radial * v.radial + v.tangential * v.tangential);
  }
  return sum;
}

}  // namespace

nlohmann::ordered_json flow_timings() {
  volatile double sink = 0;  // what is computed is used
  constexpr int many = 100000;
  const double table = median([&] {
    for (int i = 0; i < many; ++i) sink = ForceTable::uniform().coefficients(0.05 + i * 1e-7).g5;
  });
  const double direct = median([&] { sink = force_coefficients(PotentialFlow(kappa)).g5; });
  constexpr int harmonics = 20000;
  const double truncated = median([&] { sink = truncated_force(uniform_harmonics(kappa, harmonics)).g5; });
  constexpr int fewer = 2000;
  const double terms = processor_seconds([&] { sink = by_terms(fewer); }) * (harmonics / fewer) * (harmonics / fewer);

  const PotentialFlow flow(kappa, OutflowProfile::uniform(), 1e-10);
  const std::vector<FlowPoint> points = places(flow);
  const double field = median([&] {
    for (const FlowPoint& point : points) sink = flow.at(point).radial;
  });
  const double by_series = processor_seconds([&] {
    const Harmonics a = uniform_harmonics(kappa, 10000);
    for (const FlowPoint& point : points) sink = series(a, point).radial;
  });
  return {{"table_coefficients_s", table / many},
          {"direct_coefficients_s", direct},
          {"truncated_s", truncated},
          {"truncated_by_terms_s", terms},
          {"field_s", field},
          {"field_error", greatest_error(flow, points)},
          {"field_by_series_s", by_series}};
}

}  // namespace turgor::bench
