#pragma once
// Numbers that carry their gradient and Hessian with respect to N variables along: exact derivatives of energies.

#include <Eigen/Core>
#include <cmath>

#include "turgor/material/biaxial.hpp"

namespace turgor {

template <int N>
struct SecondOrder {
  double value = 0;
  Eigen::Matrix<double, N, 1> gradient = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> hessian = Eigen::Matrix<double, N, N>::Zero();

  /// The i-th variable.
  [[nodiscard]] static SecondOrder variable(double value, int i) {
    SecondOrder x;
    x.value = value;
    x.gradient(i) = 1;
    return x;
  }
};

/// f(a), from f and its first two derivatives at a.
template <int N>
[[nodiscard]] SecondOrder<N> chain(const SecondOrder<N>& a, double f, double first, double second) {
  return {f, first * a.gradient, second * a.gradient * a.gradient.transpose() + first * a.hessian};
}

/// w(a, b), from w and its derivatives at a, b.
template <int N>
[[nodiscard]] SecondOrder<N> chain(const BiaxialJet<double>& w, const SecondOrder<N>& a, const SecondOrder<N>& b) {
  SecondOrder<N> out{w.value, w.d1 * a.gradient + w.d2 * b.gradient, w.d1 * a.hessian + w.d2 * b.hessian};
  out.hessian += w.d11 * a.gradient * a.gradient.transpose() + w.d22 * b.gradient * b.gradient.transpose() +
                 w.d12 * (a.gradient * b.gradient.transpose() + b.gradient * a.gradient.transpose());
  return out;
}

template <int N>
[[nodiscard]] SecondOrder<N> operator+(const SecondOrder<N>& a, const SecondOrder<N>& b) {
  return {a.value + b.value, a.gradient + b.gradient, a.hessian + b.hessian};
}
template <int N>
[[nodiscard]] SecondOrder<N> operator-(const SecondOrder<N>& a, const SecondOrder<N>& b) {
  return {a.value - b.value, a.gradient - b.gradient, a.hessian - b.hessian};
}
template <int N>
[[nodiscard]] SecondOrder<N> operator*(const SecondOrder<N>& a, const SecondOrder<N>& b) {
  return {a.value * b.value, a.value * b.gradient + b.value * a.gradient,
          a.value * b.hessian + b.value * a.hessian + a.gradient * b.gradient.transpose() +
              b.gradient * a.gradient.transpose()};
}
template <int N>
[[nodiscard]] SecondOrder<N> operator-(const SecondOrder<N>& a, double b) {
  return {a.value - b, a.gradient, a.hessian};
}
template <int N>
[[nodiscard]] SecondOrder<N> operator*(double a, const SecondOrder<N>& b) {
  return {a * b.value, a * b.gradient, a * b.hessian};
}
template <int N>
[[nodiscard]] SecondOrder<N> operator/(const SecondOrder<N>& a, const SecondOrder<N>& b) {
  const double inverse = 1 / b.value;
  return a * chain(b, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
}
template <int N>
[[nodiscard]] SecondOrder<N> sqrt(const SecondOrder<N>& a) {
  const double root = std::sqrt(a.value);
  return chain(a, root, 0.5 / root, -0.25 / (root * a.value));
}

}  // namespace turgor
