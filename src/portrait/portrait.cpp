#include "turgor/portrait/portrait.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "basins.hpp"

namespace turgor {

std::string_view name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::inflation: return "inflation";
    case CurveKind::deflation: return "deflation";
    case CurveKind::slow_manifold: return "slow-manifold";
    case CurveKind::corrected_slow_manifold: return "corrected-slow-manifold";
    case CurveKind::separatrix: return "separatrix";
  }
  return "";
}

namespace {

/// The ends of the window and the equilibria between them.
std::vector<double> knots(const PhasePlane& plane, double from, double to) {
  std::vector<double> found{from};
  for (const Equilibrium& e : plane.equilibria()) {
    if (e.stretch > from && e.stretch < to) found.push_back(e.stretch);
  }
  found.push_back(to);
  return found;
}

/// `count` stretches spread evenly inside every interval between knots where a force has the sign of `sign`.
std::vector<double> starts_at_rest(const PhasePlane& plane, const PhaseWindow& window, double sign, int count) {
  const std::vector<double> ends = knots(plane, window.least_stretch, window.greatest_stretch);
  std::vector<double> starts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!(sign * plane.force((ends[i] + ends[i + 1]) / 2) > 0)) continue;
    for (int k = 0; k < count; ++k) starts.push_back(ends[i] + (ends[i + 1] - ends[i]) * (k + 0.5) / count);
  }
  return starts;
}

constexpr int rests = 6;  // trajectories that start at rest, for each interval

/// Around the equilibria; without any, around the balloon as it was made.
StretchInterval around_equilibria(const PhasePlane& plane) {
  if (plane.equilibria().empty()) return {0.8, 4};
  const double low = plane.equilibria().front().stretch;
  const double high = plane.equilibria().back().stretch;
  const double span = std::max(high - low, 0.5 * low);
  double least = low - 0.15 * span;
  // Sought with a coarse window: only the first turning points count.
  const PhaseWindow coarse{low, high + span, 1e-300, 1e300};
  for (const PhaseCurve& curve : plane.separatrices(coarse)) {
    const auto turn = std::ranges::find(curve.begin() + 1, curve.end(), 0.0, &PhasePoint::rate);
    constexpr double too_far = 0.5;  // of the span: would squeeze what lies between the equilibria
    if (turn != curve.end() && turn->stretch > low - too_far * span)
      least = std::min(least, turn->stretch - 0.05 * span);
  }
  return {least, high + 0.3 * span};
}

double greatest_inflation(const PhasePlane& plane, const PhaseWindow& window) {
  double greatest = 0;
  std::vector<double> starts = starts_at_rest(plane, window, 1, rests);
  if (plane.force(window.least_stretch) > 0) starts.push_back(window.least_stretch);
  for (const double R : starts) {
    for (const PhasePoint& p : plane.path({R, 0}, Regime::inflating, Course::forward, window, 1)) {
      if (p.stretch <= window.greatest_stretch) greatest = std::max(greatest, p.rate);
    }
  }
  return greatest;
}

double greatest_slow_rate(const PhasePlane& plane, const PhaseWindow& window) {
  double greatest = 0;
  constexpr int points = 400;
  for (int k = 0; k <= points; ++k) {
    const double R = window.least_stretch + (window.greatest_stretch - window.least_stretch) * k / points;
    greatest = std::max(greatest, -plane.slow_rate(R).value_or(0));
  }
  return greatest;
}

}  // namespace

PhaseWindow natural_window(const PhasePlane& plane, const WindowWishes& wishes) {
  const auto wish = [](double wished, double otherwise) { return wished > 0 ? wished : otherwise; };
  const StretchInterval natural = around_equilibria(plane);
  PhaseWindow window{std::max(plane.least_stretch(), wish(wishes.least_stretch, natural.from)),
                     std::min(plane.greatest_stretch(), wish(wishes.greatest_stretch, natural.to)), 1, 1};
  constexpr double margin = 1.08;
  const double rise = margin * greatest_inflation(plane, window);
  const double fall = 1.8 * greatest_slow_rate(plane, window);
  window.inflation = wish(wishes.inflation, rise > 0 ? rise : fall);
  window.deflation = wish(wishes.deflation, fall > 0 ? fall : rise);
  return window;
}

namespace {

/// Calls use(from, to) for the intervals in which slow deflation is allowed: to the last bits of their ends.
template <class Use>
void allowed_intervals(const PhasePlane& plane, const PhaseWindow& window, const Use& use) {
  const std::vector<double> ends = knots(plane, window.least_stretch, window.greatest_stretch);
  const auto allowed = [&](double R) { return plane.slow_rate(R).has_value(); };
  const auto change = [&](double inside, double outside) {
    for (int i = 0; i < 60; ++i) {
      const double middle = (inside + outside) / 2;
      (allowed(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    constexpr int cells = 200;  // within, only a sign of Q can change
    const auto middle_of = [&](int k) { return ends[i] + (ends[i + 1] - ends[i]) * (k + 0.5) / cells; };
    for (int k = 0; k < cells; ++k) {
      if (!allowed(middle_of(k))) continue;
      const double from = k == 0 ? ends[i] : change(middle_of(k), middle_of(k - 1));
      while (k + 1 < cells && allowed(middle_of(k + 1))) ++k;
      use(from, k + 1 == cells ? ends[i + 1] : change(middle_of(k), middle_of(k + 1)));
    }
  }
}

void add_slow_manifolds(const PhasePlane& plane, Portrait& portrait) {
  double last = portrait.window.least_stretch;
  allowed_intervals(plane, portrait.window, [&](double from, double to) {
    if (from > last) portrait.forbidden.push_back({last, from});
    last = to;
    KindOfCurve leading{CurveKind::slow_manifold, {}};
    KindOfCurve corrected{CurveKind::corrected_slow_manifold, {}};
    constexpr int points = 400;
    for (int k = 0; k <= points; ++k) {  // dense at the ends, where the manifolds are vertical
      const double sine = std::sin(std::numbers::pi * k / (2 * points));
      const double R = from + (to - from) * sine * sine;
      leading.points.push_back({R, plane.slow_rate(R).value_or(0)});  // 0 but for rounding at an equilibrium
      if (const auto rate = plane.corrected_slow_rate(R)) corrected.points.push_back({R, *rate});
    }
    portrait.curves.push_back(std::move(leading));
    portrait.curves.push_back(std::move(corrected));
  });
  if (last < portrait.window.greatest_stretch) portrait.forbidden.push_back({last, portrait.window.greatest_stretch});
}

void add_trajectories(const PhasePlane& plane, Portrait& portrait) {
  const PhaseWindow& window = portrait.window;
  const auto add = [&](CurveKind kind, const PhasePoint& start, Regime regime) {
    portrait.curves.push_back({kind, plane.path(start, regime, Course::forward, window, 1)});
  };
  for (const double R : starts_at_rest(plane, window, 1, rests)) add(CurveKind::inflation, {R, 0}, Regime::inflating);
  for (const double R : starts_at_rest(plane, window, -1, rests)) add(CurveKind::deflation, {R, 0}, Regime::deflating);
  constexpr int falls = 16;
  for (int k = 0; k < falls; ++k) {
    const double R = window.least_stretch + (window.greatest_stretch - window.least_stretch) * (k + 0.5) / falls;
    add(CurveKind::deflation, {R, -window.deflation}, Regime::deflating);
  }
}

}  // namespace

Portrait make_portrait(const PhasePlane& plane, const PhaseWindow& window) {
  Portrait portrait{window, {}, {}, {}, {}};
  add_trajectories(plane, portrait);
  add_slow_manifolds(plane, portrait);
  const std::vector<PhaseCurve> separatrices = plane.separatrices(window);
  for (const PhaseCurve& curve : separatrices) portrait.curves.push_back({CurveKind::separatrix, curve});
  portrait.at_rest = fates_at_rest(plane, window, separatrices);
  portrait.basins = basin_strips(plane, window, separatrices);
  return portrait;
}

}  // namespace turgor
