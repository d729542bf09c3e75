#pragma once
// Kinematics of an incompressible membrane under equal biaxial stretch, and the type that every material returns.
//
// Principal stretches (lambda, lambda, lambda^-2): the balloon stays a sphere, eq. (2.16).

#include <complex>

#include "turgor/base/power.hpp"

namespace turgor {

/// A function of the stretch with its first two derivatives.
/// For a strain energy density: W [J/m^3 of unstretched material], dW/dlambda and d2W/dlambda2 [Pa].
template <class S>
struct Jet {
  S value;
  S first;
  S second;
};

/// What a material decides by: the number itself, also when derivatives are carried along as its imaginary part.
template <class S>
[[nodiscard]] auto real_part(const S& value) {
  return value;
}
template <class T>
[[nodiscard]] T real_part(const std::complex<T>& value) {
  return value.real();
}

/// A quotient whose division is still to be done.
template <class S>
struct Fraction {
  S numerator;
  S denominator;
};

/// I1 - 3 = 2 lambda^2 + lambda^-4 - 3 and its derivatives.
///
/// Written with its double zero at lambda = 1 factored out: the textbook form loses all digits of a small strain.
/// @param lambda  stretch [1], > 0
template <class S>
[[nodiscard]] Jet<S> first_invariant_minus_3(const S& lambda) {
  const S x = lambda * lambda;
  const S below_one = (lambda - 1.0) * (lambda + 1.0);  // x - 1
  return {below_one * below_one * (2.0 * x + 1.0) / (x * x), 4.0 * below_one * (x * x + x + 1.0) / (x * x * lambda),
          4.0 + 20.0 / (x * x * x)};
}

/// I2 - 3 = lambda^4 + 2 lambda^-2 - 3 and its derivatives, its double zero at lambda = 1 factored out.
/// @param lambda  stretch [1], > 0
template <class S>
[[nodiscard]] Jet<S> second_invariant_minus_3(const S& lambda) {
  const S x = lambda * lambda;
  const S below_one = (lambda - 1.0) * (lambda + 1.0);
  return {below_one * below_one * (x + 2.0) / x, 4.0 * below_one * (x * x + x + 1.0) / (x * lambda),
          12.0 * x + 12.0 / (x * x)};
}

/// W(lambda) for W = f(I), from f with its derivatives in I and I with its derivatives in lambda (chain rule).
template <class S>
[[nodiscard]] Jet<S> of_invariant(const Jet<S>& f, const Jet<S>& invariant) {
  return {f.value, f.first * invariant.first,
          f.second * invariant.first * invariant.first + f.first * invariant.second};
}

}  // namespace turgor
