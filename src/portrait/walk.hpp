#pragma once
// One stroke in either direction of time, from equilibrium to equilibrium.

#include <vector>

#include "../integrate/stroke.hpp"
#include "turgor/portrait/phase_plane.hpp"

namespace turgor {

/// A place on a stroke and the energy there.
struct Held {
  Place<double> place;
  double energy;  ///< k
};

/// Where a walk ends.
struct WalkEnd {
  Held held;
  /// At a zero of the rate, or bounced off a wall that locks, where the energy is that of the next stroke; else at the
  /// end of the way or at the limit of the rate.
  bool turned;
};

class Walk {
 public:
  explicit Walk(const PhasePlane& plane)
      : inflation_(plane.oscillator(), Regime::inflating, drive(plane), evaluations_),
        deflation_(plane.oscillator(), Regime::deflating, drive(plane), evaluations_) {
    const bool exact = plane.oscillator().force_table() != nullptr;
    constexpr double squeezed = 1e-3;  // no wall lets itself be compressed so far
    knots_.push_back({exact ? plane.least_stretch() : squeezed, 0});
    for (const Equilibrium& e : plane.equilibria()) knots_.push_back(at_rest(e.stretch));
    knots_.push_back({plane.greatest_stretch(), 0});
    const bool bursts = plane.greatest_stretch() == plane.max_stretch();
    locks_ = !bursts && stretch_limit(plane.oscillator().parameters().material) < largest_stretch;
  }
  Walk(const Walk&) = delete;
  Walk(Walk&&) = delete;
  Walk& operator=(const Walk&) = delete;
  Walk& operator=(Walk&&) = delete;
  ~Walk() = default;

  [[nodiscard]] const Stroke<double>& stroke(Regime regime) const {
    return regime == Regime::deflating ? deflation_ : inflation_;
  }
  /// An equilibrium with the digits that its stretch cannot hold.
  [[nodiscard]] Place<double> at_rest(double stretch) const {
    const auto drive = inflation_.at({stretch, 0});
    return Place<double>{stretch, 0}.moved(-drive.force / drive.force_slope);
  }
  [[nodiscard]] Held held(Regime regime, const PhasePoint& at) const {
    const Place<double> place{at.stretch, 0};
    return {place, stroke(regime).at(place).mass * at.rate * at.rate};
  }
  [[nodiscard]] PhasePoint point(Regime regime, const Held& at) const {
    const double square = std::max(0.0, at.energy) / stroke(regime).at(at.place).mass;
    return {at.place.stretch, stroke(regime).direction() * std::sqrt(square)};
  }

  /// @param limit  of |dR/dT|, only for deflation backward
  /// @param visit  called for every piece of the way with its ends, the farther of which may be a turning point
  template <class Visit>
  [[nodiscard]] WalkEnd go(Regime regime, Course course, Held at, double limit, const Visit& visit) const {
    const Stroke<double>& way = stroke(regime);
    const bool explodes = regime == Regime::deflating && course == Course::backward;
    const double sign = way.direction() * static_cast<double>(course);
    const auto count = static_cast<std::ptrdiff_t>(knots_.size());
    for (std::ptrdiff_t i = sign > 0 ? 0 : count - 1; i >= 0 && i < count; i += sign > 0 ? 1 : -1) {
      const Place<double>& knot = knots_[static_cast<std::size_t>(i)];
      while (true) {
        double d = (knot.stretch - at.place.stretch) + (knot.rest - at.place.rest);
        if (!(d * sign > 0)) break;
        if (explodes) d = std::min(d, 4 / std::abs(way.at(at.place).damping));
        Held next{at.place.moved(d), way.advanced_far(at.place, d, at.energy)};
        if (explodes && std::abs(point(regime, next).rate) > limit) {
          next = at_limit(at, d, limit);
          visit(at, next);
          return {next, false};
        }
        const bool turns = !(next.energy > 0);
        if (turns) next = {at.place.moved(way.way_to_turn(at.place, at.energy, d).value_or(d)), 0};
        visit(at, next);
        if (turns) return {next, true};
        if (next.place.stretch == at.place.stretch) break;  // closer to the knot than numbers are
        at = next;
      }
    }
    return {at, locks_ && sign > 0};
  }
  [[nodiscard]] WalkEnd go(Regime regime, Held at) const {
    return go(regime, Course::forward, at, 0, [](const Held&, const Held&) {});
  }

 private:
  static double drive(const PhasePlane& plane) { return plane.pressure() / plane.oscillator().scales().pressure; }

  /// Backward in deflation: by bisection where |dR/dT| = limit, between `from` and a way d > 0 later.
  [[nodiscard]] Held at_limit(const Held& from, double d, double limit) const {
    double near = 0;
    double far = d;
    Held best{from.place.moved(d), deflation_.advanced_far(from.place, d, from.energy)};
    for (int i = 0; i < 60 && far - near > 1e-15 * from.place.stretch; ++i) {
      const double middle = (near + far) / 2;
      const Held here{from.place.moved(middle), deflation_.advanced_far(from.place, middle, from.energy)};
      (std::abs(point(Regime::deflating, here).rate) > limit ? far : near) = middle;
      best = here;
    }
    return best;
  }

  long evaluations_ = 0;
  Stroke<double> inflation_;
  Stroke<double> deflation_;
  bool locks_;                        ///< at the upper end, nearer than numbers tell
  std::vector<Place<double>> knots_;  ///< the ends of the way and the equilibria between them
};

}  // namespace turgor
