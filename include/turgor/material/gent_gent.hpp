#pragma once

#include <cmath>

#include "turgor/material/limited_chain.hpp"

namespace turgor {

/// Gent-Gent solid: W = -(mu jm/2) ln(1 - (I1 - 3)/jm) + c2 ln(I2/3).
///
/// E. Pucci & G. Saccomandi, Rubber Chem. Technol. 75 (2002) 839; for balloons: R. Mangan & M. Destrade,
/// Int. J. Non-Linear Mech. 68 (2015) 52. Small-strain shear modulus mu + 2 c2/3.
template <class T>
struct GentGent {
  T mu;  ///< [Pa]
  T jm;  ///< largest I1 - 3 [1]
  T c2;  ///< [Pa]

  friend bool operator==(const GentGent&, const GentGent&) = default;

  /// W and its derivatives at stretch lambda > 0; infinite from stretch_limit() on, and in compression where I1 - 3 >=
  /// jm.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const Jet<S> i1 = first_invariant_minus_3(lambda);
    const Jet<S> i2 = second_invariant_minus_3(lambda);
    const Jet<S> chains = of_invariant(of_first(i1.value), i1);
    const S whole = i2.value + 3.0;
    const S first = i2.first / whole;
    return {chains.value + of_second(i2.value).value, chains.first + c2 * first,
            chains.second + c2 * (i2.second / whole - first * first)};
  }

  /// f of W = f(I1 - 3) + g(I2 - 3), with its derivatives.
  template <class S>
  [[nodiscard]] Jet<S> of_first(const S& j) const {
    return gent_function(mu, jm, j);
  }

  /// g, as above.
  template <class S>
  [[nodiscard]] Jet<S> of_second(const S& j) const {
    using std::log;
    using std::log1p;
    const S whole = j + 3.0;
    S logarithm;
    if constexpr (requires { log1p(j); }) {
      logarithm = log1p(j / 3.0);
    } else {
      logarithm = log(whole / 3.0);
    }
    return {c2 * logarithm, c2 / whole, -c2 / (whole * whole)};
  }

  /// Stretch at which the chains are fully extended [1].
  [[nodiscard]] T stretch_limit() const { return limiting_stretch(jm); }
};

}  // namespace turgor
