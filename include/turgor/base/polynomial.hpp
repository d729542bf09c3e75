#pragma once
// Polynomials in time, each on an interval of its own.

#include <algorithm>
#include <array>
#include <cstddef>

namespace turgor {

/// A polynomial of degree up to `Degree` in x = (t - start)/duration; the unit of its values is the user's.
template <class T, int Degree>
struct Polynomial {
  T start;                                                           ///< [s]
  T duration;                                                        ///< [s], > 0
  std::array<T, static_cast<std::size_t>(Degree) + 1> coefficients;  ///< of 1, x, ..., x^Degree

  /// k-th derivative with respect to time at time t [s].
  [[nodiscard]] T derivative(int k, const T& t) const {
    const T x = (t - start) / duration;
    T sum(0);
    for (int i = Degree; i >= k; --i) {
      T falling(1);
      for (int j = 0; j < k; ++j) falling *= static_cast<T>(i - j);
      sum = sum * x + falling * coefficients[static_cast<std::size_t>(i)];
    }
    T scale(1);
    for (int j = 0; j < k; ++j) scale *= duration;
    return sum / scale;
  }
  [[nodiscard]] T operator()(const T& t) const { return derivative(0, t); }

  /// Size of the terms that make up the k-th derivative: its rounding is relative to that.
  [[nodiscard]] T derivative_size(int k) const {
    Polynomial all_positive = *this;
    for (T& coefficient : all_positive.coefficients) coefficient = coefficient < T(0) ? -coefficient : coefficient;
    return all_positive.derivative(k, start + duration);
  }

  [[nodiscard]] bool is_constant() const {
    return std::all_of(coefficients.begin() + 1, coefficients.end(), [](const T& c) { return c == T(0); });
  }

  /// The integral over time from `start` on, plus a constant.
  [[nodiscard]] Polynomial<T, Degree + 1> integral(const T& constant) const {
    Polynomial<T, Degree + 1> sum{start, duration, {constant}};
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      sum.coefficients[i + 1] = duration * coefficients[i] / static_cast<T>(i + 1);
    }
    return sum;
  }

  /// The same polynomial measured in other units: `value` and `time` [s] become 1.
  [[nodiscard]] Polynomial in_units(const T& value, const T& time) const {
    Polynomial scaled{start / time, duration / time, coefficients};
    for (T& coefficient : scaled.coefficients) coefficient /= value;
    return scaled;
  }
};

}  // namespace turgor
