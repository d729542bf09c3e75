#pragma once
// Motion in one regime under one constant pressure: the kinetic energy as a function of the stretch, by quadrature.
//
// k = M (dR/dT)^2 obeys dk/dR = D k + 2 f with D = (M' + 2 Q)/M >= 0, zero while inflating, and f = a P - E. With
// X(s) = int_s^R D, hence k(R) = k(R0) e^X(R0) + 2 int_{R0}^R f(s) e^X(s) ds. While inflating this is conservation of
// energy, k/2 - R^3 P/3 + int E = const, whose closed form would lose digits to cancellation on short ways.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gauss_rule.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

template <class T>
class Stroke {
 public:
  /// What drives the motion at one stretch.
  struct Drive {
    T mass;
    T damping;     ///< D
    T force;       ///< f
    T force_size;  ///< of the terms whose difference f is: its rounding is relative to that
  };

  /// @param oscillator   must outlive the stroke
  /// @param evaluations  counts evaluations of the coefficients; must outlive the stroke
  Stroke(const Oscillator<T>& oscillator, Regime regime, const T& pressure, long& evaluations)
      : oscillator_(&oscillator), regime_(regime), pressure_(pressure), evaluations_(&evaluations) {}

  [[nodiscard]] T direction() const { return static_cast<T>(static_cast<int>(regime_)); }

  [[nodiscard]] Drive at(const T& R) const {
    ++*evaluations_;
    const Coefficients<T> c = oscillator_->coefficients(regime_, R);
    return {c.mass, (c.mass_slope + 2 * c.centripetal) / c.mass, c.area * pressure_ - c.elastic,
            std::abs(c.area * pressure_) + std::abs(c.elastic)};
  }

  /// d2R/dT2 where the kinetic energy is k.
  [[nodiscard]] T acceleration(const T& R, const T& k) const {
    ++*evaluations_;
    const Coefficients<T> c = oscillator_->coefficients(regime_, R);
    return (c.centripetal * k / c.mass + c.area * pressure_ - c.elastic) / c.mass;
  }

  /// How fast the motion changes at stretch R and rate v [1/time]: what a first panel is to resolve.
  [[nodiscard]] T frequency(const T& R, const T& v) const {
    ++*evaluations_;
    const Coefficients<T> c = oscillator_->coefficients(regime_, R);
    const T pull = std::abs(acceleration(R, c.mass * v * v));
    const T damping = at(R).damping;
    const T stiffness = std::abs(c.area_slope * pressure_ - c.elastic_slope) / c.mass;
    return std::sqrt(stiffness + (damping + 1 / R) * pull) + (damping + 1 / R) * std::abs(v);
  }

  /// k at R + d, given k at R, where f varies little from R to R + d; d may have either sign.
  [[nodiscard]] T advanced(const T& R, const T& d, const T& k) const {
    const T damping = std::max(at(R).damping, at(R + d).damping);
    const T exponent = damping * std::abs(d);
    if (exponent <= T(1)) return over_piece<7>(R, d, k);
    if (d > T(0)) return in_pieces<7>(R, d, k, std::ceil(exponent));
    // Backwards in R whatever lies more than `memory` decay lengths behind is forgotten.
    constexpr T memory(50);
    const T remembered = memory / at(R + d).damping;
    if (remembered >= -d) return in_pieces<15>(R, d, k, std::ceil(exponent / widest));
    return in_pieces<15>(R + d + remembered, -remembered, T(0), std::ceil(memory / widest));
  }

  /// The same over any way: halved until halves agree with the whole but for rounding. -infinity beyond where the wall
  /// locks.
  [[nodiscard]] T advanced_far(const T& R, const T& d, const T& k, int depth = 20) const {
    const T whole = advanced(R, d, k);
    const T middle = advanced(R, d / 2, k);
    const T halves = advanced(R + d / 2, d / 2, middle);
    if (!std::isfinite(whole) || !std::isfinite(halves)) return -std::numeric_limits<T>::infinity();
    const T size = std::max({std::abs(k), std::abs(middle), std::abs(halves), at(R).force_size * std::abs(d)});
    if (depth == 0 || std::abs(whole - halves) <= 16 * std::numeric_limits<T>::epsilon() * size) return halves;
    return advanced_far(R + d / 2, d / 2, advanced_far(R, d / 2, k, depth - 1), depth - 1);
  }

  /// Where the motion from R with kinetic energy k > 0 turns, if it does within `reach` of R: the way to there.
  [[nodiscard]] std::optional<T> way_to_turn(const T& R, const T& k, const T& reach) const {
    T inside(0);  // moves on towards the turn; k > 0 there
    T energy = k;
    constexpr int parts = 8;
    for (int i = 1; i <= parts; ++i) {
      const T beyond = direction() * reach * static_cast<T>(i) / parts;
      if (!(R + beyond > T(0))) return std::nullopt;
      const T there = advanced_far(R + inside, beyond - inside, energy);
      if (!(there > T(0))) return turn_between(R, inside, energy, beyond);
      inside = beyond;
      energy = there;
    }
    return std::nullopt;
  }

 private:
  /// Newton's method on k(R), kept between a way with k > 0 and one with k <= 0.
  [[nodiscard]] T turn_between(const T& R, T inside, T energy, T beyond) const {
    T way = inside;
    T k = energy;
    const T resolution = std::numeric_limits<T>::epsilon() * R / 4;
    for (int i = 0; i < 200; ++i) {
      const Drive here = at(R + way);
      T next = way - k / (here.damping * k + 2 * here.force);
      if (!((next - inside) * (beyond - next) > T(0))) next = (inside + beyond) / 2;
      if (std::abs(next - way) <= resolution || next == inside || next == beyond) return next;
      way = next;
      k = advanced_far(R + inside, way - inside, energy);
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
  [[nodiscard]] T in_pieces(T R, const T& d, T k, const T& count) const {
    const T piece = d / count;
    for (T i(0); i < count; i += 1) {
      k = over_piece<N>(R, piece, k);
      R += piece;
    }
    return k;
  }

  template <unsigned N>
  [[nodiscard]] T over_piece(const T& R, const T& d, const T& k) const {
    const auto& rule = GaussRule<T, N>::get();
    std::array<T, N> damping;
    std::array<T, N> force;
    for (std::size_t i = 0; i < rule.size; ++i) {
      const Drive drive = at(R + d * rule.node[i]);
      damping[i] = d * drive.damping;
      force[i] = 2 * d * drive.force;
    }
    if (regime_ == Regime::inflating) return k + sum(rule.weight, force);
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
  T pressure_;
  long* evaluations_;
};

}  // namespace turgor
