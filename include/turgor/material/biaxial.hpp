#pragma once
// Kinematics of an incompressible membrane under two principal stretches, and the type that every material returns.
//
// Principal stretches (l1, l2, 1/(l1 l2)). Along l1 = l2 everything is as in equibiaxial.hpp.

#include <cmath>
#include <limits>

#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// A function of two stretches with its first two derivatives.
/// For a strain energy density: W [J/m^3 of unstretched material], its derivatives [Pa]; d1 and d2 are the principal
/// nominal stresses.
template <class S>
struct BiaxialJet {
  S value;
  S d1, d2;
  S d11, d12, d22;
};

/// x + y + 1/(x y) - 3 from x - 1 and y - 1, its double zero factored out. Loses digits again where x or y is minute.
template <class S>
[[nodiscard]] S sum_minus_3(const S& x_minus_1, const S& y_minus_1) {
  const S product = x_minus_1 * y_minus_1;
  return (x_minus_1 * x_minus_1 + product + y_minus_1 * y_minus_1 + product * (x_minus_1 + y_minus_1)) /
         ((1.0 + x_minus_1) * (1.0 + y_minus_1));
}

/// I1 - 3 = l1^2 + l2^2 + (l1 l2)^-2 - 3 and its derivatives; small strains keep their digits.
/// @param l1, l2  stretches [1], > 0
template <class S>
[[nodiscard]] BiaxialJet<S> first_invariant_minus_3(const S& l1, const S& l2) {
  const S x = l1 * l1;
  const S y = l2 * l2;
  const S e = (l1 - 1.0) * (l1 + 1.0);  // x - 1
  const S f = (l2 - 1.0) * (l2 + 1.0);  // y - 1
  const S z = 1.0 / (x * y);
  const S thinned = (e + f + e * f) * z;  // 1 - z
  return {sum_minus_3(e, f), 2.0 * (e + thinned) / l1, 2.0 * (f + thinned) / l2,
          2.0 + 6.0 * z / x, 4.0 * z / (l1 * l2),      2.0 + 6.0 * z / y};
}

/// I2 - 3 = l1^-2 + l2^-2 + (l1 l2)^2 - 3 and its derivatives; small strains keep their digits.
/// @param l1, l2  stretches [1], > 0
template <class S>
[[nodiscard]] BiaxialJet<S> second_invariant_minus_3(const S& l1, const S& l2) {
  const S x = l1 * l1;
  const S y = l2 * l2;
  const S e = (l1 - 1.0) * (l1 + 1.0);
  const S f = (l2 - 1.0) * (l2 + 1.0);
  const S grown = e + f + e * f;  // x y - 1
  return {sum_minus_3(S(-e / x), S(-f / y)),
          2.0 * (grown + e / x) / l1,
          2.0 * (grown + f / y) / l2,
          6.0 / (x * x) + 2.0 * y,
          4.0 * l1 * l2,
          6.0 / (y * y) + 2.0 * x};
}

/// W(l1, l2) for W = f(I), from f with its derivatives in I and I with its derivatives in the stretches (chain rule).
template <class S>
[[nodiscard]] BiaxialJet<S> of_invariant(const Jet<S>& f, const BiaxialJet<S>& invariant) {
  const BiaxialJet<S>& i = invariant;
  return {f.value,
          f.first * i.d1,
          f.first * i.d2,
          f.second * i.d1 * i.d1 + f.first * i.d11,
          f.second * i.d1 * i.d2 + f.first * i.d12,
          f.second * i.d2 * i.d2 + f.first * i.d22};
}

template <class S>
[[nodiscard]] BiaxialJet<S> operator+(const BiaxialJet<S>& a, const BiaxialJet<S>& b) {
  return {a.value + b.value, a.d1 + b.d1, a.d2 + b.d2, a.d11 + b.d11, a.d12 + b.d12, a.d22 + b.d22};
}

/// The same when all of it is finite, else +infinity throughout: a material that has locked, or whose energy has
/// outgrown every number, has no stress, and infinity minus infinity must not pass for one.
template <class S>
[[nodiscard]] BiaxialJet<S> infinite_unless_finite(const BiaxialJet<S>& w) {
  using std::abs;
  if (std::isfinite(abs(w.value) + abs(w.d1) + abs(w.d2) + abs(w.d11) + abs(w.d12) + abs(w.d22))) return w;
  const S infinite(std::numeric_limits<double>::infinity());
  return {infinite, infinite, infinite, infinite, infinite, infinite};
}

}  // namespace turgor
