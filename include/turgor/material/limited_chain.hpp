#pragma once
// What the Gent family shares: a strain energy that becomes infinite where I1 - 3 reaches jm.

#include <cmath>
#include <limits>
#include <type_traits>

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// Stretch > 1 at which I1 - 3 = jm, that is 2 lambda^2 + lambda^-4 = 3 + jm. jm > 0.
/// With x = lambda^2, 2x + x^-2 is convex and increasing for x > 1, so Newton from the right converges monotonically.
template <class T>
[[nodiscard]] T limiting_stretch(const T& jm) {
  using std::sqrt;
  T x = (T(3) + jm) / T(2);
  for (int i = 0; i < 100; ++i) {
    const T next = x - (2 * x + 1 / (x * x) - 3 - jm) / (2 - 2 / (x * x * x));
    if (!(next < x)) break;
    x = next;
  }
  return sqrt(x);
}

/// -(mu jm/2) ln(1 - j/jm) as a function of j = I1 - 3, with derivatives; all +infinity from j = jm on.
template <class T, class S>
[[nodiscard]] Jet<S> gent_function(const T& mu, const T& jm, const S& j) {
  using std::log;
  using std::log1p;
  const S left = 1.0 - j / jm;
  const auto extensible = real_part(left) > 0;
  constexpr bool one_lane = std::is_same_v<std::remove_const_t<decltype(extensible)>, bool>;
  if constexpr (one_lane) {
    const S infinite(std::numeric_limits<T>::infinity());
    if (!extensible) return {infinite, infinite, infinite};
  }
  const S first = (mu / 2) / left;
  S logarithm;
  if constexpr (requires { log1p(j); }) {
    logarithm = log1p(-j / jm);
  } else {
    logarithm = log(left);
  }
  const Jet<S> jet{-(mu * jm / 2) * logarithm, first, first / (left * jm)};
  if constexpr (one_lane) {
    return jet;
  } else {  // SIMD lanes, each with its own limit
    const S infinite(std::numeric_limits<double>::infinity());
    return {select(extensible, jet.value, infinite), select(extensible, jet.first, infinite),
            select(extensible, jet.second, infinite)};
  }
}

}  // namespace turgor
