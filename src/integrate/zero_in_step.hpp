#pragma once
// Where a polynomial on [0, 1] first becomes negative.

#include <array>
#include <cstddef>
#include <optional>

namespace turgor {

/// Five coefficients of a quartic, in Bernstein form on some interval.
template <class T>
using Bernstein = std::array<T, 5>;

/// Bernstein coefficients on [0, 1] of a quartic given by monomial coefficients: the graph lies in their convex hull.
template <class T, class Monomial>
[[nodiscard]] Bernstein<T> bernstein(const Monomial& c) {
  return {c[0], c[0] + c[1] / 4, c[0] + c[1] / 2 + c[2] / 6, c[0] + T(3) / 4 * c[1] + c[2] / 2 + c[3] / 4,
          c[0] + c[1] + c[2] + c[3] + c[4]};
}

/// The right end of the first small part of [lo, hi] at which the quartic is below -noise; nothing when it never is
/// (a dip narrower than (hi - lo)/2^depth between two such points can escape).
template <class T>
[[nodiscard]] std::optional<T> first_negative(const Bernstein<T>& b, const T& lo, const T& hi, const T& noise,
                                              int depth) {
  bool positive = true;
  for (const T& coefficient : b) positive = positive && coefficient >= -noise;
  if (positive) return std::nullopt;
  if (depth == 0) return b.back() < -noise ? std::optional<T>(hi) : std::nullopt;

  Bernstein<T> left;
  Bernstein<T> right = b;  // de Casteljau's subdivision at the middle
  for (std::size_t i = 0; i < b.size(); ++i) {
    left[i] = right[0];
    for (std::size_t j = 0; j + i + 1 < b.size(); ++j) right[j] = (right[j] + right[j + 1]) / 2;
  }
  const T middle = (lo + hi) / 2;
  if (const auto found = first_negative(left, lo, middle, noise, depth - 1)) return found;
  return first_negative(right, middle, hi, noise, depth - 1);
}

}  // namespace turgor
