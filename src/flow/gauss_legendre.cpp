#include "gauss_legendre.hpp"

#include <math.h>  // NOLINT: Boost 1.74 calls isnan without naming its namespace

#include <array>
#include <boost/math/special_functions/legendre.hpp>
#include <mutex>

namespace turgor {

namespace {

GaussLegendre make(int size) {
  GaussLegendre rule;
  const auto add = [&](double x) {
    const double slope = boost::math::legendre_p_prime(size, x);
    rule.node.push_back((1 + x) / 2);
    rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
  };
  for (const double x : boost::math::legendre_p_zeros<double>(size)) {
    if (x > 0) add(-x);
    add(x);
  }
  return rule;
}

}  // namespace

const GaussLegendre& gauss_legendre(int size) {
  constexpr std::size_t largest = 128;
  static std::array<GaussLegendre, largest + 1> rules;
  static std::array<std::once_flag, largest + 1> made;
  const auto i = static_cast<std::size_t>(size);
  std::call_once(made.at(i), [&] { rules[i] = make(size); });
  return rules[i];
}

}  // namespace turgor
