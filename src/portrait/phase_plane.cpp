#include "turgor/portrait/phase_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "walk.hpp"

namespace turgor {

PhasePlane::PhasePlane(const Oscillator<double>& oscillator, double pressure, double max_stretch)
    : oscillator_(oscillator),
      pressure_(pressure),
      drive_(pressure / oscillator.scales().pressure),
      max_stretch_(max_stretch),
      least_(statics_limits(oscillator.parameters()).least),
      greatest_(statics_limits(oscillator.parameters()).greatest) {
  if (!std::isfinite(pressure)) throw InvalidInput("pressure", shortest(pressure), "is not finite");
  if (max_stretch > 0) greatest_ = std::min(greatest_, max_stretch);
  equilibria_ = turgor::equilibria(oscillator.parameters(), pressure);
  std::erase_if(equilibria_, [&](const Equilibrium& e) { return e.stretch >= greatest_; });
}

double PhasePlane::force(double R) const { return oscillator_.force_at_rest(R, drive_); }

int PhasePlane::well_of(double R) const {
  return 1 + static_cast<int>(
                 std::ranges::count_if(equilibria_, [&](const Equilibrium& e) { return !e.stable && e.stretch < R; }));
}

std::optional<double> PhasePlane::first_integral(const PhasePoint& at) const {
  if (oscillator_.force_table() != nullptr) return std::nullopt;
  const double mass = oscillator_.flow_coefficients(Regime::inflating, at.stretch).mass;
  return mass * at.rate * at.rate + 2 * oscillator_.elastic_energy(at.stretch) - 2 * power<3>(at.stretch) * drive_ / 3;
}

std::optional<double> PhasePlane::slow_rate(double R) const {
  const auto c = oscillator_.coefficients(Regime::deflating, R);
  const double w = (c.elastic - c.area * drive_) / c.centripetal;
  if (!(w >= 0) || !std::isfinite(w)) return std::nullopt;
  return -std::sqrt(w);
}

std::optional<double> PhasePlane::corrected_slow_rate(double R) const {
  const auto c = oscillator_.coefficients(Regime::deflating, R);
  const double w0 = (c.elastic - c.area * drive_) / c.centripetal;
  const double slope = (c.elastic_slope - c.area_slope * drive_ - w0 * c.centripetal_slope) / c.centripetal;
  const double w = w0 + c.mass * slope / (2 * c.centripetal);
  if (!(w0 >= 0) || !(w >= 0) || !std::isfinite(w)) return std::nullopt;
  return -std::sqrt(w);
}

void PhasePlane::require_state(double R, double rate) const {
  if (!(R >= least_ && R <= greatest_)) {
    throw InvalidInput("R", shortest(R), "out of range",
                       "allowed are " + shortest(least_) + " to " + shortest(greatest_));
  }
  constexpr double fastest = 1e100;  // its square is still a number
  if (!(std::abs(rate) <= fastest)) throw InvalidInput("dR/dT", shortest(rate), "is not a finite rate");
}

namespace {

Regime opposite(Regime regime) { return regime == Regime::inflating ? Regime::deflating : Regime::inflating; }

/// A zero of the rate, and the well it lies in.
struct Turn {
  Place<double> place;
  int well = 0;
};

/// Whether a turning point is no farther out than an earlier one on the same side, but for rounding.
bool has_not_grown(const Turn& turn, const Turn& earlier, Regime before) {
  const double way = (turn.place.stretch - earlier.place.stretch) + (turn.place.rest - earlier.place.rest);
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return way * static_cast<double>(static_cast<int>(before)) <= rounding * turn.place.stretch;
}

/// The stable equilibrium of a well; null when it has none.
const Equilibrium* resident(const PhasePlane& plane, int well) {
  const auto& all = plane.equilibria();
  const auto found =
      std::ranges::find_if(all, [&](const Equilibrium& e) { return e.stable && plane.well_of(e.stretch) == well; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

Fate PhasePlane::final_well(double R, double rate) const {
  require_state(R, rate);
  if (rate == 0) {
    const auto here = std::ranges::find(equilibria_, R, &Equilibrium::stretch);
    if (here != equilibria_.end()) return {Outcome::at_rest, here->stable ? well_of(R) : 0, R, 0};
  }
  const Walk walk(*this);
  Regime regime = (rate == 0 ? force(R) : rate) > 0 ? Regime::inflating : Regime::deflating;
  Held at = walk.held(regime, {R, rate});
  std::array<Turn, 2> last;  // from deflation, from inflation
  constexpr long most = 1'000'000;
  for (long n = 1; n <= most; ++n) {
    const WalkEnd end = walk.go(regime, at);
    if (!end.turned) {
      const bool at_top = regime == Regime::inflating;
      const Outcome top = max_stretch_ > 0 && greatest_ == max_stretch_ ? Outcome::burst : Outcome::runaway;
      return {at_top ? top : Outcome::closure_end, 0, end.held.place.stretch, n};
    }
    const Turn turn{end.held.place, well_of(end.held.place.stretch)};
    Turn& earlier = last[regime == Regime::inflating ? 1 : 0];
    const Turn& between = last[regime == Regime::inflating ? 0 : 1];
    if (earlier.well == turn.well && between.well == turn.well && has_not_grown(turn, earlier, regime)) {
      if (const Equilibrium* rest = resident(*this, turn.well)) return {Outcome::at_rest, turn.well, rest->stretch, n};
    }
    earlier = turn;
    regime = opposite(regime);
    at = end.held;
  }
  return {Outcome::max_events, 0, at.place.stretch, most};
}

namespace {

/// Adds the points of one piece of a stroke to a curve, its beginning left out.
class Drawing {
 public:
  Drawing(const Walk& walk, Regime regime, const PhaseWindow& window, PhaseCurve& curve)
      : walk_(walk), regime_(regime), window_(window), curve_(curve) {}

  void add(const Held& from, const Held& to, int depth = 0) {
    const double way = (to.place.stretch - from.place.stretch) + (to.place.rest - from.place.rest);
    const Held middle = part(from, way / 2);
    const std::array<PhasePoint, 5> points{point(from), point(part(from, way / 4)), point(middle),
                                           point(part(middle, way / 4)), point(to)};
    constexpr int deepest = 45;
    if (depth == deepest || is_straight(points)) {
      curve_.push_back(points.back());
      return;
    }
    add(from, middle, depth + 1);
    add(middle, to, depth + 1);
  }

 private:
  struct Spot {
    double x, y;
  };
  /// On the picture, whose width and halves' heights are 1; what lies far outside is drawn less finely.
  [[nodiscard]] Spot spot(const PhasePoint& p) const {
    const double x = (p.stretch - window_.least_stretch) / (window_.greatest_stretch - window_.least_stretch);
    return {std::clamp(x, -1.0, 2.0), std::clamp(window_.height(p.rate), -2.0, 2.0)};
  }
  [[nodiscard]] bool is_straight(const std::array<PhasePoint, 5>& points) const {
    const Spot p = spot(points.front());
    const Spot q = spot(points.back());
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    constexpr double longest = 1.0 / 60;
    constexpr double off = 1e-4;
    return length <= longest && std::ranges::all_of(points, [&](const PhasePoint& inner) {
             const Spot m = spot(inner);
             const double across = std::abs((q.x - p.x) * (m.y - p.y) - (q.y - p.y) * (m.x - p.x));
             return across <= off * length && std::hypot(m.x - p.x, m.y - p.y) <= longest;
           });
  }
  [[nodiscard]] PhasePoint point(const Held& at) const { return walk_.point(regime_, at); }
  [[nodiscard]] Held part(const Held& from, double way) const {
    return {from.place.moved(way), walk_.stroke(regime_).advanced_far(from.place, way, from.energy)};
  }

  const Walk& walk_;
  Regime regime_;
  const PhaseWindow& window_;
  PhaseCurve& curve_;
};

PhaseCurve follow(const Walk& walk, Held at, Regime regime, Course course, const PhaseWindow& window, int strokes) {
  PhaseCurve curve{walk.point(regime, at)};
  for (int i = 0; i < strokes; ++i) {
    Drawing drawing(walk, regime, window, curve);
    const WalkEnd end =
        walk.go(regime, course, at, window.deflation, [&](const Held& from, const Held& to) { drawing.add(from, to); });
    if (!end.turned) break;
    regime = opposite(regime);
    at = end.held;
  }
  return curve;
}

}  // namespace

PhaseCurve PhasePlane::path(const PhasePoint& from, Regime regime, Course course, const PhaseWindow& window,
                            int strokes) const {
  require_state(from.stretch, from.rate);
  const Walk walk(*this);
  if (from.rate != 0) regime = from.rate > 0 ? Regime::inflating : Regime::deflating;
  return follow(walk, walk.held(regime, from), regime, course, window, strokes);
}

std::vector<PhaseCurve> PhasePlane::separatrices(const PhaseWindow& window) const {
  const Walk walk(*this);
  constexpr int strokes = 64;
  std::vector<PhaseCurve> curves;
  const auto add = [&](const Place<double>& place, Regime regime) {
    curves.push_back(follow(walk, {place, 0}, regime, Course::backward, window, strokes));
  };
  for (const Equilibrium& e : equilibria_) {
    if (e.stable) continue;
    for (const Regime regime : {Regime::inflating, Regime::deflating}) add(walk.at_rest(e.stretch), regime);
  }
  if (max_stretch_ > 0 && greatest_ == max_stretch_ && force(greatest_) < 0) add({greatest_, 0}, Regime::inflating);
  if (oscillator_.force_table() != nullptr && force(least_) > 0) add({least_, 0}, Regime::deflating);
  return curves;
}

}  // namespace turgor
