#pragma once

#include <cmath>

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Isotropic Fung (Demiray) solid: W = (mu/2b) (exp(b (I1 - 3)) - 1).
///
/// Y. C. Fung, Am. J. Physiol. 213 (1967) 1532; isotropic form: H. Demiray, J. Biomech. 5 (1972) 309. Soft tissue:
/// stiffens exponentially, so that its balloon often has no pressure maximum.
template <class T>
struct Fung {
  T mu;  ///< shear modulus at small strain [Pa]
  T b;   ///< stiffening exponent [1]

  friend bool operator==(const Fung&, const Fung&) = default;

  /// W and its derivatives at stretch lambda > 0.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    return of_invariant(of_first(i1.value), i1);
  }

  /// f of W = f(j), j = I1 - 3, with its derivatives in j.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    using std::exp;
    using std::expm1;
    const S growth = exp(b * j);
    S minus_one;
    if constexpr (requires { expm1(j); }) {
      minus_one = expm1(b * j);
    } else {
      minus_one = growth - 1.0;
    }
    return {(mu / (2 * b)) * minus_one, (mu / 2) * growth, (mu * b / 2) * growth};
  }
};

}  // namespace turgor
