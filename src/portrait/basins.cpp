#include "basins.hpp"

#include <algorithm>
#include <utility>

namespace turgor {

namespace {

/// Rates at which curves cross a stretch, and the window's, in order.
std::vector<double> cuts(const std::vector<PhaseCurve>& curves, const PhaseWindow& window, double R) {
  std::vector<double> found{-window.deflation, window.inflation};
  for (const PhaseCurve& curve : curves) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const auto& [a, u] = curve[i - 1];
      const auto& [b, v] = curve[i];
      if ((a <= R) == (b <= R)) continue;
      const double rate = u + (v - u) * (R - a) / (b - a);
      if (rate > -window.deflation && rate < window.inflation) found.push_back(rate);
    }
  }
  std::ranges::sort(found);
  return found;
}

bool same(const Fate& a, const Fate& b) { return a.outcome == b.outcome && a.well == b.well; }

/// One column: its parts, neighbours of the same fate joined.
std::vector<std::pair<Fate, BasinColumn>> column(const PhasePlane& plane, const PhaseWindow& window,
                                                 const std::vector<PhaseCurve>& curves, double R) {
  const std::vector<double> rates = cuts(curves, window, R);
  std::vector<std::pair<Fate, BasinColumn>> parts;
  for (std::size_t i = 0; i + 1 < rates.size(); ++i) {
    if (!(rates[i + 1] > rates[i])) continue;
    const Fate fate = plane.final_well(R, (rates[i] + rates[i + 1]) / 2);
    if (!parts.empty() && same(parts.back().first, fate)) {
      parts.back().second.high = rates[i + 1];
    } else {
      parts.push_back({fate, {R, rates[i], rates[i + 1]}});
    }
  }
  return parts;
}

}  // namespace

std::vector<RestInterval> fates_at_rest(const PhasePlane& plane, const PhaseWindow& window,
                                        const std::vector<PhaseCurve>& separatrices) {
  std::vector<double> ends{window.least_stretch, window.greatest_stretch};
  for (const PhaseCurve& curve : separatrices) {
    for (const PhasePoint& p : curve) {
      if (p.rate == 0 && p.stretch > window.least_stretch && p.stretch < window.greatest_stretch) {
        ends.push_back(p.stretch);
      }
    }
  }
  std::ranges::sort(ends);
  std::vector<RestInterval> intervals;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!(ends[i + 1] > ends[i])) continue;
    const Fate fate = plane.final_well((ends[i] + ends[i + 1]) / 2, 0);
    if (!intervals.empty() && same(intervals.back().fate, fate)) {
      intervals.back().stretches.to = ends[i + 1];
    } else {
      intervals.push_back({{ends[i], ends[i + 1]}, fate});
    }
  }
  return intervals;
}

std::vector<BasinStrip> basin_strips(const PhasePlane& plane, const PhaseWindow& window,
                                     const std::vector<PhaseCurve>& separatrices) {
  constexpr int columns = 600;
  const double width = (window.greatest_stretch - window.least_stretch) / columns;
  const double overlap = 0.6 * width;  // columns have a width, and pictures shall show no seams
  std::vector<BasinStrip> strips;
  std::vector<std::size_t> open;  // the strips that the last column belongs to
  for (int k = 0; k < columns; ++k) {
    const double R = window.least_stretch + (k + 0.5) * width;
    const auto parts = column(plane, window, separatrices, R);
    bool goes_on = parts.size() == open.size();
    for (std::size_t i = 0; goes_on && i < parts.size(); ++i) goes_on = same(strips[open[i]].fate, parts[i].first);
    if (!goes_on) open.clear();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      BasinColumn edge = parts[i].second;
      if (!goes_on) {
        open.push_back(strips.size());
        edge.stretch = std::max(window.least_stretch, R - overlap);
        strips.push_back({parts[i].first, {edge}});
      }
      std::vector<BasinColumn>& strip = strips[open[i]].columns;
      strip.push_back(parts[i].second);
    }
  }
  for (BasinStrip& strip : strips) {
    BasinColumn edge = strip.columns.back();
    edge.stretch = std::min(window.greatest_stretch, edge.stretch + overlap);
    strip.columns.push_back(edge);
  }
  return strips;
}

}  // namespace turgor
