#pragma once

#include "turgor/material/limited_chain.hpp"

namespace turgor {

/// Gent solid: W = -(mu jm/2) ln(1 - (I1 - 3)/jm).
///
/// A. N. Gent, Rubber Chem. Technol. 69 (1996) 59. Chains reach their full length where I1 - 3 = jm: from
/// stretch_limit() on energy and tension are infinite.
template <class T>
struct Gent {
  T mu;  ///< shear modulus [Pa]
  T jm;  ///< largest I1 - 3 [1]

  friend bool operator==(const Gent&, const Gent&) = default;

  /// W and its derivatives at stretch lambda > 0; infinite from stretch_limit() on, and in compression where I1 - 3 >=
  /// jm.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    return of_invariant(of_first(i1.value), i1);
  }

  /// f of W = f(j), j = I1 - 3, with its derivatives in j.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    return gent_function(mu, jm, j);
  }

  /// Stretch at which the chains are fully extended [1].
  [[nodiscard]] T stretch_limit() const { return limiting_stretch(jm); }
};

}  // namespace turgor
