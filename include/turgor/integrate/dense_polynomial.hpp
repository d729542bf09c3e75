#pragma once
// Dense output of one component, and where it first becomes negative.

#include <optional>

#include "turgor/integrate/step.hpp"

namespace turgor {

/// Coefficients of a polynomial of degree 7: in powers of theta, or in Bernstein form on some interval.
template <class V>
using DensePolynomial = std::array<V, dense_degree + 1>;

template <class V>
[[nodiscard]] V evaluate(const DensePolynomial<V>& c, const V& x) {
  return ((((((c[7] * x + c[6]) * x + c[5]) * x + c[4]) * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
}
template <class V>
[[nodiscard]] V derivative(const DensePolynomial<V>& c, const V& x) {
  V sum(0);
  for (std::size_t k = dense_degree; k > 0; --k) sum = sum * x + V(static_cast<ScalarOf<V>>(k)) * c[k];
  return sum;
}

/// Bernstein coefficients on [0, 1] of a polynomial in powers of theta: its graph lies in their convex hull.
template <class V>
[[nodiscard]] DensePolynomial<V> bernstein(DensePolynomial<V> c) {
  constexpr std::array<int, dense_degree + 1> binomial{1, 7, 21, 35, 35, 21, 7, 1};
  for (std::size_t k = 1; k < dense_degree; ++k) c[k] *= V(ScalarOf<V>(1) / static_cast<ScalarOf<V>>(binomial[k]));
  for (std::size_t k = 1; k <= dense_degree; ++k) {
    for (std::size_t i = dense_degree; i >= k; --i) c[i] += c[i - 1];
  }
  return c;
}

/// A bound from below on [0, 1], cheaper and coarser than the least Bernstein coefficient.
template <class V>
[[nodiscard]] V lower_bound(const DensePolynomial<V>& c) {
  using std::min;
  V sum = c[0];
  for (std::size_t k = 1; k < c.size(); ++k) sum += min(c[k], V(0));
  return sum;
}

/// A part of [0, 1] and the polynomial's Bernstein coefficients there.
template <class T>
struct BernsteinPart {
  T lo;
  T hi;
  DensePolynomial<T> b;
};

/// The first part of [0, 1] in which the polynomial goes from positive (or zero, at its beginning) to below -noise,
/// once and for all of that part; nothing when it is never below. Parts shorter than 2^-depth are not divided further:
/// a dip narrower than that between two positive points can escape.
template <class T>
[[nodiscard]] std::optional<BernsteinPart<T>> first_fall(const BernsteinPart<T>& part, const T& noise, int depth) {
  int changes = 0;
  bool above = true;
  for (const T& coefficient : part.b) {
    if (above == (coefficient >= -noise)) continue;
    above = !above;
    ++changes;
  }
  if (changes == 0) return std::nullopt;
  if (changes == 1) return part;  // Descartes' rule: as many zeros as the coefficients have changes of sign
  if (depth == 0) return part.b.back() < -noise ? std::optional(part) : std::nullopt;

  const T middle = (part.lo + part.hi) / 2;
  BernsteinPart<T> left{part.lo, middle, {}};
  BernsteinPart<T> right{middle, part.hi, part.b};  // de Casteljau's subdivision at the middle
  for (std::size_t i = 0; i < right.b.size(); ++i) {
    left.b[i] = right.b[0];
    for (std::size_t j = 0; j + i + 1 < right.b.size(); ++j) right.b[j] = (right.b[j] + right.b[j + 1]) / 2;
  }
  if (const auto found = first_fall(left, noise, depth - 1)) return found;
  return first_fall(right, noise, depth - 1);
}

/// Where the polynomial c falls through zero on such a part: Newton's method from where the control polygon does,
/// bisection as its net.
template <class T>
[[nodiscard]] T falling_zero(const DensePolynomial<T>& c, const BernsteinPart<T>& part) {
  T lo = part.lo;
  T hi = part.hi;
  std::size_t below = 1;
  while (below + 1 < part.b.size() && part.b[below] >= T(0)) ++below;
  const T left = part.b[below - 1];
  const T share = static_cast<T>(below - 1) + (left > T(0) ? left / (left - part.b[below]) : T(0));
  T x = lo + (hi - lo) * share / dense_degree;
  for (int i = 0; i < 60; ++i) {
    const T value = evaluate(c, x);
    (value > T(0) ? lo : hi) = x;
    T next = x - value / derivative(c, x);
    if (!(next > lo && next < hi)) next = (lo + hi) / 2;
    const bool converged = std::abs(next - x) <= 4 * std::numeric_limits<T>::epsilon() * next;
    x = next;
    if (converged) break;
  }
  return x;
}

}  // namespace turgor
