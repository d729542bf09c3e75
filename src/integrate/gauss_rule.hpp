#pragma once
// Gauss-Legendre nodes on [0, 1], with the integrals from each node to the right end.

#include <math.h>  // NOLINT: Boost 1.74 calls isnan without naming its namespace

#include <array>
#include <boost/math/quadrature/gauss.hpp>

namespace turgor {

/// @tparam N  odd, one of those that Boost knows
template <class T, unsigned N>
struct GaussRule {
  static constexpr std::size_t size = N;
  std::array<T, N> node;                 ///< increasing, in (0, 1)
  std::array<T, N> weight;               ///< sum 1
  std::array<std::array<T, N>, N> tail;  ///< int_{node i}^1 f = sum_j tail[i][j] f(node j), f of degree < N

  [[nodiscard]] static const GaussRule& get() {
    static const GaussRule rule = make();
    return rule;
  }

 private:
  static GaussRule make() {
    using Half = boost::math::quadrature::gauss<T, N>;  // the nodes >= 0 of [-1, 1]
    GaussRule rule{};
    constexpr std::size_t middle = N / 2;
    for (std::size_t i = 0; i <= middle; ++i) {
      rule.node[middle + i] = (1 + Half::abscissa()[i]) / 2;
      rule.node[middle - i] = (1 - Half::abscissa()[i]) / 2;
      rule.weight[middle + i] = rule.weight[middle - i] = Half::weights()[i] / 2;
    }
    for (std::size_t i = 0; i < size; ++i) {
      const T length = 1 - rule.node[i];
      for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t q = 0; q < size; ++q) {
          rule.tail[i][j] += length * rule.weight[q] * rule.lagrange(j, rule.node[i] + length * rule.node[q]);
        }
      }
    }
    return rule;
  }

  [[nodiscard]] T lagrange(std::size_t j, const T& x) const {
    T product(1);
    for (std::size_t k = 0; k < size; ++k) {
      if (k != j) product *= (x - node[k]) / (node[j] - node[k]);
    }
    return product;
  }
};

}  // namespace turgor
