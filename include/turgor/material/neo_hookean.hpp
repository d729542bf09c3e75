#pragma once

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Neo-Hookean solid: W = (mu/2) (I1 - 3).
///
/// L. R. G. Treloar, Trans. Faraday Soc. 39 (1943) 241. A balloon of it has a pressure maximum and no minimum:
/// above that maximum nothing holds it.
template <class T>
struct NeoHookean {
  T mu;  ///< shear modulus [Pa]

  friend bool operator==(const NeoHookean&, const NeoHookean&) = default;

  /// W and its derivatives at stretch lambda > 0.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    const T half = mu / 2;
    return {half * i1.value, half * i1.first, half * i1.second};
  }

  /// f of W = f(j), j = I1 - 3, with its derivatives in j.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    const T half = mu / 2;
    return {half * j, S(half), S(0.0)};
  }
};

}  // namespace turgor
