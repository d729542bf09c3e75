#include "turgor/asymptotics/slow_deflation.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "../integrate/gauss_rule.hpp"
#include "turgor/asymptotics/decay.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

template <class Function>
double root(const Function& f, double lo, double hi) {
  std::uintmax_t iterations = 100;
  const auto bracket =
      boost::math::tools::toms748_solve(f, lo, hi, boost::math::tools::eps_tolerance<double>(53), iterations);
  return (bracket.first + bracket.second) / 2;
}

/// Refuses starts where the expansion does not hold; see SlowDeflation.
FreeMotion checked(const FreeMotion& motion, double start) {
  (void)motion.require_deflation();
  require_above_equilibrium(motion, start);
  const SlowManifold w = slow_manifold(motion, start);
  if (std::abs(w.next) > 0.1 * w.leading) {  // its part in d2R/dT2 at the start, where w = 0
    throw InvalidInput("start", shortest(start),
                       "is too close to the equilibrium " + shortest(motion.equilibrium()) +
                           " or the next unstable one for an expansion in 1/C2",
                       "start farther away, or take the expansion in the amplitude");
  }
  return motion;
}

}  // namespace

SlowManifold slow_manifold(const FreeMotion& motion, double R) {
  const auto [C1, C2] = motion.require_deflation();
  const Jet<double> F = motion.force().at(R);
  const double r2 = R * R;
  const double factor = C1 / power<3>(r2);
  const double u = factor * F.value;  // w0 = u/C2
  const double slope = factor * (F.first - 6 * F.value / R);
  const double curvature = factor * (F.second - 12 * F.first / R + 42 * F.value / r2);
  const double delta = 1 / C2;
  return {delta * u, delta * delta * slope / (2 * r2),
          power<3>(delta) * (curvature / (4 * r2 * r2) - slope / (2 * r2 * r2 * R))};
}

Estimate SlowManifold::corrected() const { return {leading + correction, std::abs(next)}; }

SlowDeflation::SlowDeflation(const FreeMotion& motion, double start)
    : leading_(checked(motion, start), start, 2), next_(motion, start, 3) {}

Estimate SlowDeflation::at(double T) const {
  require_time(T);
  const double value = leading_.at(T);
  return {value, std::abs(next_.at(T) - value)};
}

double SlowDeflation::refined_at(double T) const {
  require_time(T);
  return next_.at(T);
}

Estimate SlowDeflation::turning_point() const {
  return {leading_.turning_point(), std::abs(next_.turning_point() - leading_.turning_point())};
}

Estimate SlowDeflation::transition_time() const {
  return {leading_.duration(), std::abs(next_.duration() - leading_.duration())};
}

SlowDeflation::Way::Way(const FreeMotion& motion, double start, int terms)
    : motion_(motion),
      C2_(motion.require_deflation().C2),
      start_(start),
      terms_(terms),
      at_start_(manifold(start)),
      end_(find_turning_point()) {
  const double middle = std::sqrt((start_ - end_) / 2);
  add_pieces(true, middle);
  add_pieces(false, middle);
  duration_ = pieces_.back().time + duration(false, pieces_.back().from, pieces_.back().to);
}

double SlowDeflation::Way::manifold(double R) const {
  const SlowManifold w = slow_manifold(motion_, R);
  return w.leading + w.correction + (terms_ > 2 ? w.next : 0.0);
}

double SlowDeflation::Way::squared_rate(double R) const { return (start_ - R) * slope_to_start(start_ - R); }

double SlowDeflation::Way::slope_to_start(double way) const {
  // Closer to the start w is a difference of nearly equal numbers, but a straight line.
  const double straight = 1e-6 / (2 * C2_ * start_ * start_);
  way = std::max(way, straight);
  const double R = start_ - way;
  const double layer = 2 * C2_ / 3 * way * (start_ * start_ + start_ * R + R * R);
  return (manifold(R) - at_start_ - at_start_ * std::expm1(-layer)) / way;
}

double SlowDeflation::Way::find_turning_point() const {
  const double equilibrium = motion_.equilibrium();
  const double expected = Decay(motion_).undershoot(start_ - equilibrium).value;
  const auto w = [&](double R) { return squared_rate(R); };
  double below = equilibrium - 1.5 * expected;
  for (int i = 0; i < 3 && w(below) > 0; ++i) below -= expected;
  if (!(w(equilibrium) > 0) || !(below > 0) || w(below) > 0) {
    throw InvalidInput(
        "start", shortest(start_),
        "the expansion in 1/C2 does not hold: C2 = " + rounded(C2_) + " is too small for this equilibrium",
        "a narrower orifice has a larger C2");
  }
  return root(w, below, equilibrium);
}

void SlowDeflation::Way::add_pieces(bool falling, double greatest) {
  const double layer = 1 / std::sqrt(2 * C2_ * start_ * start_);  // of s
  double time = pieces_.empty() ? 0.0 : pieces_.back().time + duration(true, pieces_.back().from, pieces_.back().to);
  std::vector<double> ends{0};
  while (ends.back() < greatest) {
    const double s = ends.back();
    ends.push_back(std::min(greatest, s + std::max(layer, s - 7 * layer) / 2));
  }
  if (!falling) std::ranges::reverse(ends);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    pieces_.push_back({falling, ends[i], ends[i + 1], time});
    time += duration(falling, ends[i], ends[i + 1]);
  }
}

double SlowDeflation::Way::duration(bool falling, double from, double to) const {
  using Rule = GaussRule<double, 15>;
  const Rule& rule = Rule::get();
  if (from == to) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < Rule::size; ++i) {
    const double s = from + (to - from) * rule.node[i];
    const double way = falling ? s * s : start_ - end_ - s * s;
    const double slope = slope_to_start(way);
    if (!(slope > 0)) {
      throw InvalidInput("start", shortest(start_), "there is no slow deflation all the way to the equilibrium",
                         "start closer to " + shortest(motion_.equilibrium()));
    }
    sum += rule.weight[i] * 2 / std::sqrt(falling ? slope : slope * (way / (s * s)));
  }
  return sum * std::abs(to - from);
}

double SlowDeflation::Way::at(double T) const {
  if (T >= duration_) return end_;
  if (T <= 0) return start_;
  const auto next = std::ranges::upper_bound(pieces_, T, {}, &Piece::time);
  const Piece& piece = *(next - 1);
  const auto lateness = [&](double s) { return piece.time + duration(piece.falling, piece.from, s) - T; };
  double s = piece.to;
  if (lateness(piece.from) >= 0) {
    s = piece.from;
  } else if (lateness(piece.to) > 0) {
    s = root(lateness, std::min(piece.from, piece.to), std::max(piece.from, piece.to));
  }
  return piece.falling ? start_ - s * s : end_ + s * s;
}

}  // namespace turgor
