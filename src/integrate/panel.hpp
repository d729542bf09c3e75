#pragma once
// A short part of a stroke with its time by quadrature and its dense output.
//
// The stretch is parametrised by a ballistic path, R = R_b + speed tau + pull tau^2/2, close to the motion itself:
// then dT = (dR/dtau) dtau/sqrt(k/M) has an integrand near 1 that stays smooth at a turning point, where numerator and
// denominator vanish together. A path from a turning point is anchored there, and k is integrated from it, which keeps
// all digits of the small k nearby.

#include <optional>

#include "stroke.hpp"
#include "turgor/integrate/trajectory.hpp"

namespace turgor {

/// The way from a base at tau = 0, speed tau + pull tau^2/2.
template <class T>
struct BallisticPath {
  T speed;
  T pull;

  [[nodiscard]] T way(const T& from, const T& to) const { return (to - from) * (speed + pull * (from + to) / 2); }
  [[nodiscard]] T slope(const T& tau) const { return speed + pull * tau; }
};

template <class T>
class Panel {
 public:
  /// Points along tau: the eight Chebyshev-Lobatto nodes that the dense output interpolates, and in their middle the
  /// one at which it is judged.
  static constexpr std::size_t points = 9;
  static constexpr std::size_t middle = 4;

  struct Ends {
    Place<T> place;  ///< at tau_from
    T energy;        ///< k there
    T tau_from;
    T tau_to;
    bool turns;  ///< the path's base is the turning point that the stroke runs into, at tau = 0 >= tau_to
  };

  /// Nothing when the path leaves the stretches that the motion reaches.
  [[nodiscard]] static std::optional<Panel> make(const Stroke<T>& stroke, const BallisticPath<T>& path,
                                                 const Ends& ends) {
    Panel panel(stroke, path, ends);
    if (!panel.fill()) return std::nullopt;
    panel.interpolate();
    return panel;
  }

  [[nodiscard]] const T& duration() const { return time_[points - 1]; }
  [[nodiscard]] const Place<T>& end() const { return place_[points - 1]; }
  [[nodiscard]] const T& end_rate() const { return rate_[points - 1]; }
  /// From the first to the last place: exact where the difference of their stretches is rounded.
  [[nodiscard]] T way() const { return path_.way(ends_.tau_from, ends_.tau_to); }
  [[nodiscard]] bool ends_at_turn() const { return ends_.turns && ends_.tau_to == T(0); }

  /// How far the dense output may be from the quadrature.
  struct Tolerance {
    T relative;
    T absolute;
  };

  /// Distance of the dense output from the quadrature in the middle of the panel, over what is allowed.
  [[nodiscard]] T error(const Tolerance& tolerance) const {
    constexpr T epsilon = std::numeric_limits<T>::epsilon();
    const T part = std::pow(epsilon, T(0.625));  // 1.6e-10, 1.2e-12: makes the quadrature itself exact to rounding
    const T theta = time_[middle] / duration();
    const TrajectoryStep<T> step = dense(T(0), duration());
    const T extent = std::abs(way());
    T fastest(0);
    for (const T& v : rate_) fastest = std::max(fastest, std::abs(v));
    // A path anchored at the start does not smooth a turning point near the end, and the middle would not show it.
    if (!ends_.turns && 3 * std::abs(end_rate()) < fastest) return std::numeric_limits<T>::infinity();
    // The rounding of the force moves the rates, as far back as the motion remembers it.
    const auto drive = stroke_.at(place_[middle]);
    const T memory = extent / (1 + drive.damping * extent);
    const T shaken = 2 * epsilon * drive.force_size * memory / (drive.mass * fastest);
    const auto allowed = [&](const T& value, const T& scale, const T& rounding) {
      return std::min(tolerance.absolute + tolerance.relative * std::abs(value), part * scale) + rounding;
    };
    const T of_stretch =
        std::abs(step.stretch_at(theta) - place_[middle].stretch) /
        allowed(place_[middle].stretch, extent, 4 * epsilon * place_[middle].stretch + shaken * extent / fastest);
    const T of_rate = std::abs(step.rate_at(theta) - rate_[middle]) / allowed(fastest, fastest, shaken);
    return of_stretch > of_rate || !(of_rate >= T(0)) ? of_stretch : of_rate;
  }

  [[nodiscard]] TrajectoryStep<T> dense(const T& start, const T& duration) const {
    return {start, duration, stroke_.direction() > T(0) ? Regime::inflating : Regime::deflating, stretch_polynomial_,
            rate_polynomial_};
  }

  /// The panel cut short after `elapsed` < duration().
  [[nodiscard]] std::optional<Panel> cut(const T& elapsed) const {
    std::size_t j = 0;
    while (j + 2 < points && time_[j + 1] < elapsed) ++j;
    Ends ends = ends_;
    ends.tau_to = tau_at(j, elapsed);
    return make(stroke_, path_, ends);
  }

  /// The panel cut short where R = stretch, which it passes.
  [[nodiscard]] std::optional<Panel> cut_at(const T& stretch) const {
    const T speed = path_.slope(ends_.tau_from);
    const T way = stretch - ends_.place.stretch - ends_.place.rest;
    const T square = std::max(T(0), speed * speed + 2 * path_.pull * way);
    Ends ends = ends_;
    ends.tau_to = ends.tau_from + 2 * way / (speed + stroke_.direction() * std::sqrt(square));
    return make(stroke_, path_, ends);
  }

 private:
  Panel(const Stroke<T>& stroke, const BallisticPath<T>& path, const Ends& ends)
      : stroke_(stroke), path_(path), ends_(ends) {
    for (std::size_t j = 0; j < points; ++j) tau_[j] = ends.tau_from + share(j) * (ends.tau_to - ends.tau_from);
    tau_.back() = ends.tau_to;
  }

  /// Of the way along tau, point j.
  [[nodiscard]] static T share(std::size_t j) {
    if (j == middle) return T(1) / 2;
    const std::size_t node = j < middle ? j : j - 1;
    const T sine = std::sin(std::numbers::pi_v<T> * static_cast<T>(node) / (2 * (points - 2)));
    return sine * sine;
  }

  struct Passage {
    T time;
    Place<T> place;
    T energy;
  };

  /// From tau, where the state is known, to another tau in either direction; a negative energy when there is none.
  [[nodiscard]] Passage pass(const T& from, const T& to, Place<T> place, T energy) const {
    const auto& rule = GaussRule<T, 7>::get();
    T time(0);
    T tau = from;
    const auto move = [&](const T& next) {
      const T way = path_.way(tau, next);
      energy = place.stretch + way > T(0) ? stroke_.advanced(place, way, energy) : T(-1);
      place = place.moved(way);
      tau = next;
    };
    for (std::size_t i = 0; i < rule.size; ++i) {
      move(from + (to - from) * rule.node[i]);
      if (!(energy > T(0))) return {time, place, T(-1)};
      time += rule.weight[i] * std::abs(path_.slope(tau)) / std::sqrt(energy / stroke_.at(place).mass);
    }
    move(to);
    return {time * std::abs(to - from), place, energy};
  }

  bool fill() {
    set(0, ends_.place, ends_.energy);
    const std::size_t last = points - 1;
    std::array<T, points - 1> elapsed;  // between neighbouring points
    const std::size_t forward = ends_.turns ? middle : last;
    for (std::size_t j = 0; j < forward; ++j) {
      const Passage p = pass(tau_[j], tau_[j + 1], place_[j], energy_[j]);
      if (!(p.energy > T(0))) return false;
      elapsed[j] = p.time;
      set(j + 1, p.place, p.energy);
    }
    if (ends_.turns) {
      const Place<T> turn = ends_.place.moved(path_.way(ends_.tau_from, T(0)));
      const T back = path_.way(T(0), ends_.tau_to);
      set(last, turn.moved(back), back == T(0) ? T(0) : stroke_.advanced_far(turn, back, T(0)));
    }
    for (std::size_t j = last; j > forward; --j) {
      const Passage p = pass(tau_[j], tau_[j - 1], place_[j], energy_[j]);
      if (!(p.energy > T(0))) return false;
      elapsed[j - 1] = p.time;
      if (j - 1 > middle) set(j - 1, p.place, p.energy);
    }
    time_[0] = T(0);
    for (std::size_t j = 0; j < last; ++j) time_[j + 1] = time_[j] + elapsed[j];
    return std::isfinite(duration());
  }

  void set(std::size_t j, const Place<T>& place, const T& energy) {
    place_[j] = place;
    energy_[j] = energy;
    rate_[j] = stroke_.direction() * std::sqrt(std::max(T(0), energy) / stroke_.at(place).mass);
  }

  /// tau at a time between points j and j + 1: the secant method, since time and tau are almost proportional.
  [[nodiscard]] T tau_at(std::size_t j, const T& elapsed) const {
    const bool backward = ends_.turns && j >= middle;  // from the turning point, as in fill()
    const std::size_t anchor = backward ? j + 1 : j;
    const T pace = (tau_[j + 1] - tau_[j]) / (time_[j + 1] - time_[j]);
    const T sign(backward ? -1 : 1);
    const T wanted = std::abs(elapsed - time_[anchor]);
    T last_tau = tau_[anchor];
    T last_time(0);
    T tau = last_tau + sign * pace * wanted;
    for (int i = 0; i < 50 && tau != last_tau; ++i) {
      const T time = pass(tau_[anchor], tau, place_[anchor], energy_[anchor]).time;
      const T slope = time != last_time ? (tau - last_tau) / (time - last_time) : sign * pace;
      last_tau = tau;
      last_time = time;
      const T correction = slope * (wanted - time);
      if (std::abs(correction) <= 2 * std::numeric_limits<T>::epsilon() * std::abs(tau_[j + 1] - tau_[j])) break;
      tau = std::clamp(tau + correction, tau_[j], tau_[j + 1]);
    }
    return tau;
  }

  void interpolate() {
    std::array<T, points - 1> theta;
    std::array<T, points - 1> stretch;
    std::array<T, points - 1> rate;
    for (std::size_t j = 0; j < points; ++j) {
      if (j == middle) continue;
      const std::size_t node = j < middle ? j : j - 1;
      theta[node] = time_[j] / duration();
      stretch[node] = path_.way(tau_[0], tau_[j]);
      rate[node] = rate_[j];
    }
    stretch_polynomial_ = through(theta, stretch);
    stretch_polynomial_[0] = place_[0].stretch;
    rate_polynomial_ = through(theta, rate);
  }

  /// Newton's divided differences, multiplied out; exact at the first node, theta = 0.
  [[nodiscard]] static DensePolynomial<T> through(const DensePolynomial<T>& theta, DensePolynomial<T> value) {
    constexpr std::size_t n = points - 1;
    static_assert(n == dense_degree + 1);
    for (std::size_t k = 1; k < n; ++k) {
      for (std::size_t i = n - 1; i >= k; --i) value[i] = (value[i] - value[i - 1]) / (theta[i] - theta[i - k]);
    }
    DensePolynomial<T> monomial{};
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t i = n - 1; i > 0; --i) monomial[i] = monomial[i - 1] - theta[k] * monomial[i];
      monomial[0] = value[k] - theta[k] * monomial[0];
    }
    return monomial;
  }

  Stroke<T> stroke_;
  BallisticPath<T> path_;
  Ends ends_;
  std::array<T, points> tau_;
  std::array<T, points> time_;
  std::array<Place<T>, points> place_;
  std::array<T, points> energy_;
  std::array<T, points> rate_;
  DensePolynomial<T> stretch_polynomial_;
  DensePolynomial<T> rate_polynomial_;
};

}  // namespace turgor
