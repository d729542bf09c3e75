#pragma once
// Pressure programs: the gauge pressure at the inlet as a function of time.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "turgor/base/polynomial.hpp"

namespace turgor {

/// How a quantity goes from one value to the next.
enum class RampShape {
  linear,  ///< s(x) = x
  smooth,  ///< s(x) = x^3 (10 - 15 x + 6 x^2): first and second derivative zero at both ends
};

/// A pressure [Pa] that is a polynomial of degree up to 5.
template <class T>
using PolynomialPressure = Polynomial<T, 5>;

/// p(t) = mean + amplitude sin(2 pi frequency t + phase).
template <class T>
struct HarmonicPressure {
  T mean;       ///< [Pa]
  T amplitude;  ///< [Pa]
  T frequency;  ///< [Hz]
  T phase;      ///< [rad]

  [[nodiscard]] T derivative(int k, const T& t) const {
    using std::sin;
    const T omega = 2 * std::numbers::pi_v<T> * frequency;
    T factor = amplitude;
    for (int j = 0; j < k; ++j) factor *= omega;
    const T quarter_turns = static_cast<T>(k) * std::numbers::pi_v<T> / 2;
    return (k == 0 ? mean : T(0)) + factor * sin(omega * t + phase + quarter_turns);
  }

  [[nodiscard]] T derivative_size(int k) const {
    using std::abs;
    T size = abs(amplitude);
    for (int j = 0; j < k; ++j) size *= 2 * std::numbers::pi_v<T> * frequency;
    return size;
  }

  [[nodiscard]] bool is_constant() const { return amplitude == T(0) || frequency == T(0); }

  [[nodiscard]] HarmonicPressure in_units(const T& pressure, const T& time) const {
    return {mean / pressure, amplitude / pressure, frequency * time, phase};
  }
};

/// A pressure without knots: infinitely smooth for all times.
template <class T>
class SmoothPressure {
 public:
  SmoothPressure(PolynomialPressure<T> p) : form_(std::move(p)) {}  // NOLINT: meant to convert
  SmoothPressure(HarmonicPressure<T> p) : form_(std::move(p)) {}    // NOLINT: meant to convert

  /// k-th derivative with respect to time [Pa/s^k] at time t [s].
  [[nodiscard]] T derivative(int k, const T& t) const {
    return std::visit([&](const auto& form) { return form.derivative(k, t); }, form_);
  }
  [[nodiscard]] T operator()(const T& t) const { return derivative(0, t); }
  /// Size of the terms that make up the k-th derivative: its rounding is relative to that.
  [[nodiscard]] T derivative_size(int k) const {
    return std::visit([&](const auto& form) { return form.derivative_size(k); }, form_);
  }
  [[nodiscard]] bool is_constant() const {
    return std::visit([](const auto& form) { return form.is_constant(); }, form_);
  }
  /// The same pressure measured in other units: pressure [Pa] and time [s] become 1.
  [[nodiscard]] SmoothPressure in_units(const T& pressure, const T& time) const {
    return std::visit([&](const auto& form) { return SmoothPressure(form.in_units(pressure, time)); }, form_);
  }

  [[nodiscard]] const std::variant<PolynomialPressure<T>, HarmonicPressure<T>>& form() const { return form_; }

 private:
  std::variant<PolynomialPressure<T>, HarmonicPressure<T>> form_;
};

/// The gauge pressure p_ext - p_a at the inlet as a function of time: smooth pieces that follow each other at knots.
/// At a knot the pressure may jump; the value there is the one after it.
template <class T>
class PressureProgram {
 public:
  struct Piece {
    T start;  ///< [s]
    SmoothPressure<T> pressure;
  };

  /// @param pieces  in order of time, at least one; the first also holds before its start, the last for ever
  explicit PressureProgram(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  /// The smooth pressure from time t [s] up to the next knot.
  [[nodiscard]] const SmoothPressure<T>& after(const T& t) const& { return (piece_after(t) - 1)->pressure; }
  const SmoothPressure<T>& after(const T& t) && = delete;  // would refer into a temporary

  /// Gauge pressure [Pa] at time t [s].
  [[nodiscard]] T operator()(const T& t) const { return after(t)(t); }

  /// First knot after time t [s]; +infinity when there is none.
  [[nodiscard]] T next_knot(const T& t) const {
    const auto next = piece_after(t);
    return next == pieces_.end() ? std::numeric_limits<T>::infinity() : next->start;
  }

  /// Times at which the program or one of its derivatives may jump [s], increasing.
  [[nodiscard]] std::vector<T> knots() const {
    std::vector<T> times;
    times.reserve(pieces_.size() - 1);
    for (std::size_t i = 1; i < pieces_.size(); ++i) times.push_back(pieces_[i].start);
    return times;
  }

  /// The same program measured in other units: pressure [Pa] and time [s] become 1.
  [[nodiscard]] PressureProgram in_units(const T& pressure, const T& time) const {
    std::vector<Piece> scaled;
    scaled.reserve(pieces_.size());
    for (const Piece& piece : pieces_) scaled.push_back({piece.start / time, piece.pressure.in_units(pressure, time)});
    return PressureProgram(std::move(scaled));
  }

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  [[nodiscard]] auto piece_after(const T& t) const {
    return std::upper_bound(pieces_.begin() + 1, pieces_.end(), t,
                            [](const T& time, const Piece& piece) { return time < piece.start; });
  }

  std::vector<Piece> pieces_;
};

/// The same gauge pressure for ever [Pa].
template <class T>
[[nodiscard]] PressureProgram<T> constant_pressure(const T& value) {
  return PressureProgram<T>({{T(0), PolynomialPressure<T>{T(0), T(1), {value, T(0), T(0), T(0), T(0), T(0)}}}});
}

template <class T>
[[nodiscard]] PressureProgram<T> harmonic_pressure(const HarmonicPressure<T>& harmonic) {
  return PressureProgram<T>({{T(0), harmonic}});
}

/// A quantity that goes through segments one after the other from t = 0: a pressure [Pa], or a velocity [m/s]. The last
/// value holds for ever.
template <class T>
class SegmentList {
 public:
  /// @param start  value at t = 0
  explicit SegmentList(const T& start) : value_(start) {}

  /// Keeps the value for `duration` [s].
  SegmentList& hold(const T& duration) { return append({value_, T(0), T(0), T(0), T(0), T(0)}, duration); }

  /// Jumps to `value`.
  SegmentList& step(const T& value) {
    jumps_ = jumps_ || value != value_;
    value_ = value;
    return *this;
  }

  /// Goes to `value` over `duration` [s].
  SegmentList& ramp(const T& value, const T& duration, RampShape shape) {
    const T rise = value - value_;
    std::array<T, 6> polynomial{value_, rise, T(0), T(0), T(0), T(0)};
    if (shape == RampShape::smooth) polynomial = {value_, T(0), T(0), 10 * rise, -15 * rise, 6 * rise};
    value_ = value;
    return append(polynomial, duration);
  }

  /// End of the last segment [s].
  [[nodiscard]] const T& end() const { return time_; }
  [[nodiscard]] bool jumps() const { return jumps_; }

  /// The segments in order of time, each monotone, and a last piece that holds the last value.
  [[nodiscard]] std::vector<Polynomial<T, 5>> pieces() const {
    SegmentList whole = *this;
    whole.hold(T(1));
    return std::move(whole.pieces_);
  }

  /// The pressure program of these segments.
  [[nodiscard]] PressureProgram<T> build() const {
    std::vector<typename PressureProgram<T>::Piece> program;
    for (const Polynomial<T, 5>& piece : pieces()) program.push_back({piece.start, piece});
    return PressureProgram<T>(std::move(program));
  }

 private:
  SegmentList& append(const std::array<T, 6>& polynomial, const T& duration) {
    pieces_.push_back({time_, duration, polynomial});
    time_ += duration;
    return *this;
  }

  T time_{0};
  T value_;
  bool jumps_ = false;
  std::vector<Polynomial<T, 5>> pieces_;
};

/// How a table is read between its rows.
enum class TableInterpolation {
  linear,
  cubic,  ///< monotone cubic (PCHIP): never overshoots the data
};

/// A program through given points; before the first and after the last the pressure keeps their value.
/// @param times      [s], strictly increasing, at least two, the first >= 0
/// @param pressures  gauge pressure [Pa], one for each time
/// @throws InvalidInput when the lists differ in length, are too short, not finite, or not increasing
[[nodiscard]] PressureProgram<double> table_pressure(const std::vector<double>& times,
                                                     const std::vector<double>& pressures,
                                                     TableInterpolation interpolation);

/// Least and greatest gauge pressure [Pa] of the pieces up to t_end; a harmonic counts with its whole swing.
template <class T>
struct PressureRange {
  T least;
  T greatest;
};
[[nodiscard]] PressureRange<double> range_of(const PressureProgram<double>& program, double t_end);

}  // namespace turgor
