#include "curves.hpp"

#include <algorithm>
#include <cmath>

namespace turgor {

namespace {

constexpr int points_per_step = 8;  // a step is at most a fraction of an oscillation long
constexpr double columns = 3000;    // of a picture, at print resolution

/// Calls use(T, R, dR/dT, gap) along the parts of a trajectory in one regime, or all.
template <class Use>
void walk(const Trajectory<double>& trajectory, std::optional<Regime> regime, const Use& use) {
  bool gap = true;
  for (const auto& step : trajectory.steps) {
    if (regime && step.regime != *regime) {
      gap = true;
      continue;
    }
    for (int i = gap ? 0 : 1; i <= points_per_step; ++i) {
      const double theta = static_cast<double>(i) / points_per_step;
      use(step.start + theta * step.duration, step.stretch_at(theta), step.rate_at(theta), gap && i == 0);
    }
    gap = false;
  }
}

/// Leaves columns of few points as they are. Of a crowded one the first, the lowest, the highest and the last stay,
/// whatever gaps lie between them: what happens inside a column is not seen.
class Envelope {
 public:
  explicit Envelope(double column) : width_(column) {}

  void add(const CurvePoint& point) {
    const double column = std::floor(point.x / width_);
    if (column != column_) flush();
    column_ = column;
    held_.push_back(point);
    constexpr std::size_t crowded = 32;
    if (held_.size() > crowded) thin();
  }
  Curve finish() {
    flush();
    return std::move(curve_);
  }

 private:
  void thin() {
    const auto [low, high] = std::minmax_element(held_.begin() + 1, held_.end() - 1,
                                                 [](const CurvePoint& a, const CurvePoint& b) { return a.y < b.y; });
    Curve kept{held_.front(), *low, *high, held_.back()};
    if (high < low) std::swap(kept[1], kept[2]);
    for (std::size_t i = 1; i < kept.size(); ++i) kept[i].gap = false;
    held_ = std::move(kept);
  }
  void flush() {
    curve_.insert(curve_.end(), held_.begin(), held_.end());
    held_.clear();
  }

  double width_;
  double column_ = -1;
  Curve held_;
  Curve curve_;
};

}  // namespace

Curve stretch_curve(const Trajectory<double>& trajectory, std::optional<Regime> regime, double clock) {
  Envelope envelope(trajectory.last.time * clock / columns);
  walk(trajectory, regime, [&](double time, double R, double, bool gap) { envelope.add({time * clock, R, gap}); });
  return envelope.finish();
}

Curve portrait_curve(const Trajectory<double>& trajectory, Regime regime, double per_second) {
  double least_R = trajectory.last.stretch;
  double greatest_R = least_R;
  double greatest_rate = 0;
  for (const auto& step : trajectory.steps) {
    least_R = std::min(least_R, step.stretch_at(0));
    greatest_R = std::max(greatest_R, step.stretch_at(0));
    greatest_rate = std::max(greatest_rate, std::abs(step.rate_at(0)));
  }
  const double dx = std::max(greatest_R - least_R, 1e-300) / columns;
  const double dy = std::max(greatest_rate, 1e-300) / columns;
  Curve curve;
  CurvePoint pending{};
  bool left_out = false;
  walk(trajectory, regime, [&](double, double R, double rate, bool gap) {
    const CurvePoint point{R, rate * per_second, gap};
    if (gap && left_out) curve.push_back(pending);
    left_out = !gap && !curve.empty() && std::abs(R - curve.back().x) < dx &&
               std::abs(point.y - curve.back().y) < dy * per_second;
    if (!left_out) curve.push_back(point);
    pending = point;
  });
  if (left_out) curve.push_back(pending);
  return curve;
}

std::string picture_pressure_unit(const Case& c) {
  return c.output.pressure_unit == "Pa" ? "kPa" : c.output.pressure_unit;
}

Curve pressure_curve(const Case& c, double time_unit, double pressure_unit) {
  const double end = c.solve.t_end;
  std::vector<double> knots{0};
  for (const double knot : c.pressure.knots()) {
    if (knot > 0 && knot < end) knots.push_back(knot);
  }
  knots.push_back(end);
  Envelope envelope(end / time_unit / columns);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const SmoothPressure<double>& pressure = c.pressure.after(knots[i]);
    double wanted = pressure.is_constant() ? 1 : std::clamp(2 * columns / static_cast<double>(knots.size()), 1.0, 64.0);
    if (const auto* harmonic = std::get_if<HarmonicPressure<double>>(&pressure.form())) {
      wanted = std::clamp(64 * harmonic->frequency * end, 64.0, 1e6);
    }
    const int points = static_cast<int>(wanted);
    for (int k = 0; k <= points; ++k) {
      const double t = knots[i] + (knots[i + 1] - knots[i]) * k / points;
      envelope.add({t / time_unit, pressure(t) / pressure_unit, false});
    }
  }
  return envelope.finish();
}

}  // namespace turgor
