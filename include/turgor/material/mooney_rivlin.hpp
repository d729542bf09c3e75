#pragma once

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Two-parameter Mooney-Rivlin solid, eq. (2.18): W = s1 (I1 - 3) + s2 (I2 - 3).
///
/// M. Mooney, J. Appl. Phys. 11 (1940) 582; R. S. Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379.
/// Small-strain shear modulus 2 (s1 + s2).
template <class T>
struct MooneyRivlin {
  T s1;  ///< [Pa]
  T s2;  ///< [Pa]

  friend bool operator==(const MooneyRivlin&, const MooneyRivlin&) = default;

  /// W and its derivatives at stretch lambda > 0.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    const Jet<S> i2 = second_invariant_minus_3(lambda);
    const Fraction<S> first = tension(lambda);
    return {s1 * i1.value + s2 * i2.value, first.numerator / first.denominator, s1 * i1.second + s2 * i2.second};
  }

  /// f of W = f(I1 - 3) + g(I2 - 3), with its derivatives.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    return {s1 * j, S(s1), S(0.0)};
  }

  /// g, as above.
  template <class S>
  [[nodiscard]] Jet<S> of_second(const S& j) const {
    return {s2 * j, S(s2), S(0.0)};
  }

  /// dW/dlambda as a fraction: the innermost loop of every simulation then has one division and not three.
  template <class S>
  [[nodiscard]] Fraction<S> tension(const S& lambda) const {
    const S x = lambda * lambda;
    return {4.0 * ((lambda - 1.0) * (lambda + 1.0)) * (x * x + x + 1.0) * (s1 + s2 * x), x * (x * lambda)};
  }
};

}  // namespace turgor
