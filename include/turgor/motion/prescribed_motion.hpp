#pragma once
// Dictated motion: the radius as a given function of time, as section 2.3 of the paper uses it.

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "turgor/base/errors.hpp"
#include "turgor/base/polynomial.hpp"
#include "turgor/base/regime.hpp"
#include "turgor/pressure/program.hpp"

namespace turgor {

/// Where between two times a condition begins to hold that does so once, by bisection to the last digit.
template <class T, class Condition>
[[nodiscard]] T onset(T before, T after, const Condition& holds) {
  while (true) {
    const T middle = (before + after) / 2;
    if (!(before < middle && middle < after)) return after;
    (holds(middle) ? after : before) = middle;
  }
}

/// A radius r(t) whose velocity goes through segments. Velocities are polynomials, so that radius and acceleration are
/// their exact integrals and derivatives.
template <class T>
class PrescribedMotion {
 public:
  /// A part of the motion in one direction, up to the start of the next.
  struct Phase {
    T start;  ///< [s]
    Regime regime;
    Polynomial<T, 5> velocity;      ///< dr/dt [m/s]
    Polynomial<T, 6> displacement;  ///< r - r(0) [m]
  };

  struct State {
    T radius;        ///< r [m]
    T rate;          ///< dr/dt [m/s]
    T acceleration;  ///< d2r/dt2 [m/s^2]
    Regime regime;   ///< where dr/dt is zero, the direction in which the motion goes on
  };

  /// @param radius    r at t = 0 [m]
  /// @param velocity  dr/dt [m/s], at least one segment
  /// @throws InvalidInput when the velocity jumps, which takes an infinite acceleration
  PrescribedMotion(const T& radius, const SegmentList<T>& velocity) : radius_(radius), end_(velocity.end()) {
    if (velocity.jumps()) throw InvalidInput("velocity", "", "jumps, which takes an infinite acceleration");
    const std::vector<Polynomial<T, 5>> pieces = velocity.pieces();
    T displacement(0);  // apart from r(0), whose rounding is coarser
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const bool last = i + 1 == pieces.size();
      append(pieces[i], displacement, last ? pieces[i].coefficients[0] : pieces[i + 1].coefficients[0]);
      displacement = phases_.back().displacement(pieces[i].start + pieces[i].duration);
    }
  }

  /// State at time t >= 0 [s]; where the acceleration jumps, the one after it.
  [[nodiscard]] State at(const T& t) const {
    const auto next = std::upper_bound(phases_.begin() + 1, phases_.end(), t,
                                       [](const T& time, const Phase& phase) { return time < phase.start; });
    return within(*(next - 1), t);
  }

  /// State in a phase; at its end, the one before whatever jumps there.
  [[nodiscard]] State within(const Phase& phase, const T& t) const {
    return {radius_ + phase.displacement(t), phase.velocity(t), phase.velocity.derivative(1, t), phase.regime};
  }

  /// A phase as far as it lies before some end.
  struct Interval {
    const Phase& phase;
    T begin;  ///< [s]
    T end;    ///< [s]
  };
  /// The phases from t = 0 to t_end > 0 [s]; they refer to this motion.
  [[nodiscard]] std::vector<Interval> intervals(const T& t_end) const {
    std::vector<Interval> parts;
    for (std::size_t i = 0; i < phases_.size() && phases_[i].start < t_end; ++i) {
      const T end = i + 1 < phases_.size() ? std::min(phases_[i + 1].start, t_end) : t_end;
      parts.push_back({phases_[i], phases_[i].start, end});
    }
    return parts;
  }

  /// End of the last segment [s].
  [[nodiscard]] const T& end() const { return end_; }

 private:
  /// A monotone piece of the velocity, cut where it changes its sign.
  /// @param last  the velocity it ends with, free of the polynomial's rounding
  void append(const Polynomial<T, 5>& velocity, const T& displacement, const T& last) {
    const T& first = velocity.coefficients[0];
    const Polynomial<T, 6> way = velocity.integral(displacement);
    phases_.push_back({velocity.start, direction(first != T(0) ? first : last), velocity, way});
    const bool turns = (first < T(0) && last > T(0)) || (first > T(0) && last < T(0));
    if (!turns) return;
    const T turn = onset(velocity.start, velocity.start + velocity.duration,
                         [&](const T& t) { return (velocity(t) > T(0)) == (last > T(0)); });
    phases_.push_back({turn, direction(last), velocity, way});
  }

  [[nodiscard]] static Regime direction(const T& velocity) {
    if (velocity == T(0)) return Regime::rest;
    return velocity > T(0) ? Regime::inflating : Regime::deflating;
  }

  T radius_;
  T end_;
  std::vector<Phase> phases_;  ///< in order of time, at least one; the last goes on for ever
};

/// Least and greatest radius [m] from t = 0 to t_end, and when they are reached first [s].
template <class T>
struct RadiusRange {
  T least;
  T least_time;
  T greatest;
  T greatest_time;
};
template <class T>
[[nodiscard]] RadiusRange<T> range_of(const PrescribedMotion<T>& motion, const T& t_end) {
  const T start = motion.at(T(0)).radius;
  RadiusRange<T> range{start, T(0), start, T(0)};
  for (const auto& interval : motion.intervals(t_end)) {  // the radius is monotone within
    const T& t = interval.end;
    const T radius = motion.at(t).radius;
    if (radius < range.least) std::tie(range.least, range.least_time) = std::tie(radius, t);
    if (radius > range.greatest) std::tie(range.greatest, range.greatest_time) = std::tie(radius, t);
  }
  return range;
}

/// First time up to t_end at which the radius is not above a level [m]; nothing when it always is.
template <class T>
[[nodiscard]] std::optional<T> first_time_not_above(const PrescribedMotion<T>& motion, const T& level, const T& t_end) {
  const auto reached = [&](const T& t) { return !(motion.at(t).radius > level); };
  if (reached(T(0))) return T(0);
  for (const auto& interval : motion.intervals(t_end)) {
    if (reached(interval.end)) return onset(interval.begin, interval.end, reached);
  }
  return std::nullopt;
}

}  // namespace turgor
