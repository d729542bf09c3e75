#pragma once

#include <array>

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Arruda-Boyce eight-chain solid, its five-term series in I1:
/// W = mu sum_{i=1..5} C_i lambda_m^(2-2i) (I1^i - 3^i), C = 1/2, 1/20, 11/1050, 19/7000, 519/673750.
///
/// E. M. Arruda & M. C. Boyce, J. Mech. Phys. Solids 41 (1993) 389. mu is the coefficient of the series (n k Theta);
/// the small-strain shear modulus is a little larger. The series stays finite beyond the locking stretch lambda_m.
template <class T>
struct ArrudaBoyce {
  T mu;        ///< [Pa]
  T lambda_m;  ///< locking stretch of a chain [1]

  friend bool operator==(const ArrudaBoyce&, const ArrudaBoyce&) = default;

  /// W and its derivatives at stretch lambda > 0.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    return of_invariant(of_first(i1.value), i1);
  }

  /// f of W = f(j), j = I1 - 3, with its derivatives in j.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    const std::array<T, 5> c{T(1) / 2, T(1) / 20, T(11) / 1050, T(19) / 7000, T(519) / 673750};
    const S whole = j + 3.0;
    const T shrink = 1 / (lambda_m * lambda_m);
    Jet<S> f{S(0.0), S(0.0), S(0.0)};
    S power(1.0);       // I1^(i-1)
    S previous(0.0);    // I1^(i-2)
    S difference(1.0);  // (I1^i - 3^i)/(I1 - 3)
    T three(1);         // 3^(i-1)
    T factor = mu;      // mu lambda_m^(2-2i)
    for (std::size_t i = 1; i <= c.size(); ++i) {
      const T weight = factor * c[i - 1];
      const T n(static_cast<double>(i));
      f.value += weight * difference * j;
      f.first += weight * n * power;
      f.second += weight * n * (n - 1) * previous;
      previous = power;
      power = power * whole;
      three *= 3;
      difference = difference * whole + three;
      factor *= shrink;
    }
    return f;
  }
};

}  // namespace turgor
