#pragma once

#include <cmath>
#include <vector>

#include "turgor/material/biaxial.hpp"

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

  /// W = sum_p (mu_p/alpha_p) (l1^alpha_p + l2^alpha_p + (l1 l2)^-alpha_p - 3) and its derivatives, l1, l2 > 0.
  template <class S>
  [[nodiscard]] BiaxialJet<S> energy(const S& l1, const S& l2) const {
    using std::exp;
    using std::log;
    const S log1 = log(l1);
    const S log2 = log(l2);
    BiaxialJet<S> sum{S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0)};
    for (std::size_t p = 0; p < mu.size(); ++p) {
      const T a = alpha[p];
      const S u = exp(a * log1);
      const S v = exp(a * log2);
      const S w = 1.0 / (u * v);
      sum.value += (mu[p] / a) * sum_minus_3(S(u - 1.0), S(v - 1.0));
      sum.d1 += mu[p] * (u - w) / l1;
      sum.d2 += mu[p] * (v - w) / l2;
      sum.d11 += mu[p] * ((a - 1) * u + (a + 1) * w) / (l1 * l1);
      sum.d12 += mu[p] * a * w / (l1 * l2);
      sum.d22 += mu[p] * ((a - 1) * v + (a + 1) * w) / (l2 * l2);
    }
    return sum;
  }
};

}  // namespace turgor
