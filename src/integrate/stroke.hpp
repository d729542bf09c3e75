#pragma once
// Motion in one regime under one constant pressure: the kinetic energy as a function of the stretch, by quadrature.
//
// k = M (dR/dT)^2 obeys dk/dR = D k + 2 f with D = (M' + 2 Q)/M >= 0 and f = a P - E. With
// X(s) = int_s^R D, hence k(R) = k(R0) e^X(R0) + 2 int_{R0}^R f(s) e^X(s) ds. While inflating D is zero, or with an
// exact closure next to zero, and this is conservation of energy, for the fits k/2 - R^3 P/3 + int E = const, whose
// closed form would lose digits to cancellation on short ways.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gauss_rule.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

/// A stretch together with what its digits cannot hold: near an equilibrium the force depends on it.
template <class T>
struct Place {
  T stretch;
  T rest;

  [[nodiscard]] Place moved(const T& way) const {
    const T end = stretch + (rest + way);
    return {end, (stretch - end) + (rest + way)};
  }
};

template <class T>
class Stroke {
 public:
  /// What drives the motion at one stretch.
  struct Drive {
    T mass;
    T damping;      ///< D
    T force;        ///< f
    T force_slope;  ///< df/dR
    T force_size;   ///< what the rounding of f, and of R in it, is relative to
    T centripetal;  ///< Q/M

    /// d2R/dT2 where the kinetic energy is k.
    [[nodiscard]] T acceleration(const T& k) const { return (centripetal * k + force) / mass; }

    /// How fast motion with stretch R and rate v changes [1/time].
    [[nodiscard]] T frequency(const T& R, const T& v) const {
      const T along = damping + 1 / R;
      const T pull = std::abs(acceleration(mass * v * v));
      return std::sqrt(std::abs(force_slope) / mass + along * pull) + along * std::abs(v);
    }
  };

  /// @param oscillator   must outlive the stroke
  /// @param evaluations  counts evaluations of the coefficients; must outlive the stroke
  Stroke(const Oscillator<T>& oscillator, Regime regime, const T& pressure, long& evaluations)
      : oscillator_(&oscillator),
        regime_(regime),
        undamped_(oscillator.conserves_energy(regime)),
        least_(closure_limits(oscillator.parameters()).least),
        pressure_(pressure),
        evaluations_(&evaluations) {}

  [[nodiscard]] T direction() const { return static_cast<T>(static_cast<int>(regime_)); }

  [[nodiscard]] Drive at(const Place<T>& place) const {
    ++*evaluations_;
    const Coefficients<T> c = oscillator_->coefficients(regime_, place.stretch);
    const T slope = c.area_slope * pressure_ - c.elastic_slope;
    return {c.mass,
            (c.mass_slope + 2 * c.centripetal) / c.mass,
            c.area * pressure_ - c.elastic + slope * place.rest,
            slope,
            std::abs(c.area * pressure_) + std::abs(c.elastic) + place.stretch * std::abs(slope),
            c.centripetal / c.mass};
  }

  /// k after a way d, of either sign, over which f varies little; given k at the start.
  [[nodiscard]] T advanced(const Place<T>& from, const T& d, const T& k) const {
    if (undamped_) return over_piece<7>(from, d, k);
    const T end_damping = at(from.moved(d)).damping;
    const T exponent = std::max(at(from).damping, end_damping) * std::abs(d);
    if (exponent <= T(1) || std::isnan(exponent)) return over_piece<7>(from, d, k);
    if (d > T(0)) return in_pieces<7>(from, d, k, std::ceil(exponent));
    // Backwards in R whatever lies more than `memory` decay lengths behind is forgotten.
    constexpr T memory(50);
    const T remembered = memory / end_damping;
    if (remembered >= -d) return in_pieces<15>(from, d, k, std::ceil(exponent / widest));
    return in_pieces<15>(from.moved(d + remembered), -remembered, T(0), std::ceil(memory / widest));
  }

  /// The same over any way within the closure's range: halved until halves agree with the whole but for rounding.
  /// -infinity where the wall has locked.
  [[nodiscard]] T advanced_far(const Place<T>& from, const T& d, const T& k, int depth = 40) const {
    const Drive end = at(from.moved(d));
    if (!std::isfinite(end.force)) return -std::numeric_limits<T>::infinity();
    const Place<T> middle = from.moved(d / 2);
    const T whole = advanced(from, d, k);
    const T half = advanced(from, d / 2, k);
    const T halves = advanced(middle, d / 2, half);
    const T size = std::max(
        {std::abs(k), std::abs(half), std::abs(halves), std::max(at(from).force_size, end.force_size) * std::abs(d)});
    if (depth == 0 || std::abs(whole - halves) <= 16 * std::numeric_limits<T>::epsilon() * size) return halves;
    return advanced_far(middle, d / 2, advanced_far(from, d / 2, k, depth - 1), depth - 1);
  }

  /// Where the motion with kinetic energy k > 0 turns, if it does within `reach`: the way to there. Both are of either
  /// sign; against the direction of the stroke time runs backward.
  [[nodiscard]] std::optional<T> way_to_turn(const Place<T>& from, const T& k, const T& reach) const {
    T inside(0);  // moves on towards the turn; k > 0 there
    T energy = k;
    constexpr int parts = 8;
    for (int i = 1; i <= parts; ++i) {
      const T beyond = reach * static_cast<T>(i) / parts;
      if (!(from.stretch + beyond > least_)) return std::nullopt;
      const T there = advanced_far(from.moved(inside), beyond - inside, energy);
      if (!(there > T(0))) return turn_between(from, inside, energy, beyond);
      inside = beyond;
      energy = there;
    }
    return std::nullopt;
  }

 private:
  /// Newton's method on k, kept between a way with k > 0 and one with k <= 0.
  [[nodiscard]] T turn_between(const Place<T>& from, T inside, T energy, T beyond) const {
    T way = inside;
    T k = energy;
    const T resolution = std::numeric_limits<T>::epsilon() * std::abs(beyond);
    for (int i = 0; i < 200; ++i) {
      const Drive here = at(from.moved(way));
      T next = way - k / (here.damping * k + 2 * here.force);
      if (!((next - inside) * (beyond - next) > T(0))) next = (inside + beyond) / 2;
      if (std::abs(next - way) <= resolution || next == inside || next == beyond) return next;
      way = next;
      k = advanced_far(from.moved(inside), way - inside, energy);
      if (k > T(0)) {
        inside = way;
        energy = k;
      } else {
        beyond = way;
        if (k == T(0)) return way;
      }
    }
    return way;
  }

  template <unsigned N>
  [[nodiscard]] T in_pieces(Place<T> place, const T& d, T k, const T& count) const {
    const T piece = d / count;
    for (auto left = static_cast<long>(count); left > 0; --left) {
      k = over_piece<N>(place, piece, k);
      place = place.moved(piece);
    }
    return k;
  }

  template <unsigned N>
  [[nodiscard]] T over_piece(const Place<T>& from, const T& d, const T& k) const {
    const auto& rule = GaussRule<T, N>::get();
    std::array<T, N> damping;
    std::array<T, N> force;
    for (std::size_t i = 0; i < rule.size; ++i) {
      const Drive drive = at(from.moved(d * rule.node[i]));
      damping[i] = d * drive.damping;
      force[i] = 2 * d * drive.force;
    }
    if (undamped_) return k + sum(rule.weight, force);
    T total = k * std::exp(sum(rule.weight, damping));
    for (std::size_t i = 0; i < rule.size; ++i) {
      total += rule.weight[i] * force[i] * std::exp(sum(rule.tail[i], damping));
    }
    return total;
  }

  template <std::size_t N>
  [[nodiscard]] static T sum(const std::array<T, N>& weights, const std::array<T, N>& values) {
    T total(0);
    for (std::size_t i = 0; i < N; ++i) total += weights[i] * values[i];
    return total;
  }

  /// Exponent that 15 nodes integrate to 1e-20 (7 nodes: 1).
  static constexpr T widest = T(8);

  const Oscillator<T>* oscillator_;
  Regime regime_;
  bool undamped_;  ///< D = 0
  T least_;        ///< stretch below which nothing is known
  T pressure_;
  long* evaluations_;
};

}  // namespace turgor
