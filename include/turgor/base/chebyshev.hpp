#pragma once
// Chebyshev series on an interval: smooth functions as numbers.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace turgor {

/// sum_k c_k T_k(x) on [lower, upper], k < N.
template <std::size_t N>
struct ChebyshevSeries {
  double lower;
  double upper;
  std::array<double, N> coefficient;

  /// The polynomial of degree N - 1 that equals f at the Chebyshev points of the first kind.
  template <class Function>
  [[nodiscard]] static ChebyshevSeries through(const Function& f, double lower, double upper) {
    constexpr double pi = std::numbers::pi;
    std::array<double, N> value;
    for (std::size_t j = 0; j < N; ++j) value[j] = f(point(j, lower, upper));
    ChebyshevSeries series{lower, upper, {}};
    for (std::size_t k = 0; k < N; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < N; ++j) {
        sum += value[j] * std::cos(pi * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / N);
      }
      series.coefficient[k] = (k == 0 ? 1 : 2) * sum / N;
    }
    return series;
  }

  /// The j-th of N Chebyshev points of an interval.
  [[nodiscard]] static double point(std::size_t j, double lower, double upper) {
    const double x = std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / N);
    return (lower + upper) / 2 + (upper - lower) / 2 * x;
  }

  template <class T>
  struct ValueAndSlope {
    T value;
    T slope;
  };

  /// The sum and its derivative, by Clenshaw's recurrence and its derivative.
  template <class T>
  [[nodiscard]] ValueAndSlope<T> at(const T& argument) const {
    const T per_length = T(2) / (T(upper) - T(lower));
    const T x = (argument - T(lower)) * per_length - T(1);
    T b1(0);
    T b2(0);
    T d1(0);
    T d2(0);
    for (std::size_t k = N - 1; k > 0; --k) {
      const T d = 2 * (x * d1 + b1) - d2;
      const T b = 2 * x * b1 - b2 + T(coefficient[k]);
      d2 = d1;
      d1 = d;
      b2 = b1;
      b1 = b;
    }
    return {x * b1 - b2 + T(coefficient[0]), (b1 + x * d1 - d2) * per_length};
  }

  /// How large the last coefficients are: about the error of the series.
  [[nodiscard]] double tail() const { return std::abs(coefficient[N - 1]) + std::abs(coefficient[N - 2]); }
};

}  // namespace turgor
