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
    return {s1 * i1.value + s2 * i2.value, s1 * i1.first + s2 * i2.first, s1 * i1.second + s2 * i2.second};
  }
};

}  // namespace turgor
