#pragma once

#include <cmath>
#include <vector>

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Ogden solid with N terms: W = sum_p (mu_p/alpha_p) (2 lambda^alpha_p + lambda^(-2 alpha_p) - 3).
///
/// R. W. Ogden, Proc. R. Soc. Lond. A 326 (1972) 565. Small-strain shear modulus (1/2) sum mu_p alpha_p, which must be
/// positive; single terms may be negative as long as mu_p alpha_p > 0 for each.
template <class T>
struct Ogden {
  std::vector<T> mu;     ///< [Pa], N values
  std::vector<T> alpha;  ///< [1], N values, none zero

  friend bool operator==(const Ogden&, const Ogden&) = default;

  /// W and its derivatives at stretch lambda > 0.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    using std::exp;
    using std::log;
    const S logarithm = log(lambda);
    Jet<S> sum{S(0.0), S(0.0), S(0.0)};
    for (std::size_t p = 0; p < mu.size(); ++p) {
      const T a = alpha[p];
      const S up = exp(a * logarithm);  // lambda^a
      const S down = 1.0 / (up * up);   // lambda^-2a
      // 2 u + u^-2 - 3 with its double zero at u = 1 factored out
      sum.value += (mu[p] / a) * ((up - 1.0) * (up - 1.0) * (2.0 * up + 1.0) * down);
      sum.first += (2 * mu[p]) * (up - down) / lambda;
      sum.second += (2 * mu[p]) * ((a - 1) * up + (2 * a + 1) * down) / (lambda * lambda);
    }
    return sum;
  }
};

}  // namespace turgor
