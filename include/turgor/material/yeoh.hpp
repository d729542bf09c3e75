#pragma once

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Yeoh solid: W = c1 (I1 - 3) + c2 (I1 - 3)^2 + c3 (I1 - 3)^3.
///
/// O. H. Yeoh, Rubber Chem. Technol. 66 (1993) 754. Small-strain shear modulus 2 c1; c2 is often negative.
template <class T>
struct Yeoh {
  T c1;  ///< [Pa]
  T c2;  ///< [Pa]
  T c3;  ///< [Pa]

  friend bool operator==(const Yeoh&, const Yeoh&) = default;

  /// W and its derivatives at stretch lambda > 0.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    return of_invariant(of_first(i1.value), i1);
  }

  /// f of W = f(j), j = I1 - 3, with its derivatives in j.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    return {j * (c1 + j * (c2 + j * c3)), c1 + j * (2.0 * c2 + j * (3.0 * c3)), 2.0 * c2 + j * (6.0 * c3)};
  }
};

}  // namespace turgor
