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
    using std::exp;
    using std::expm1;
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    const S growth = exp(b * i1.value);
    S minus_one;
    if constexpr (requires { expm1(i1.value); }) {
      minus_one = expm1(b * i1.value);
    } else {
      minus_one = growth - 1.0;
    }
    return of_invariant(Jet<S>{(mu / (2 * b)) * minus_one, (mu / 2) * growth, (mu * b / 2) * growth}, i1);
  }
};

}  // namespace turgor
