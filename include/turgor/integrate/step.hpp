#pragma once
// What the one-step methods share. Their scalar type is double, long double, or a SIMD batch of doubles whose lanes are
// independent balloons; nothing here may let one lane's values depend on another's.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "turgor/base/lanes.hpp"

namespace turgor {

/// Greatest degree of dense output: what the explicit pair of order 8 has; lower ones are padded with zeros.
inline constexpr int dense_degree = 7;

/// The solution over a step as a polynomial in theta = (t - t_start)/h: coefficients of all components by degree.
template <class State>
using DenseState = std::array<State, dense_degree + 1>;

/// f, df/dy and df/dt at the start of a step; shared by every attempt to step from there.
template <class V, int N>
struct Linearization {
  Eigen::Matrix<V, N, 1> rate;
  Eigen::Matrix<V, N, N> jacobian;
  Eigen::Matrix<V, N, 1> time_derivative;
};

/// Calls action(std::integral_constant<std::size_t, i>) for i = first ... last - 1, unrolled.
template <std::size_t first, std::size_t last, class Action>
constexpr void unrolled(const Action& action) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (action(std::integral_constant<std::size_t, first + i>()), ...);
  }(std::make_index_sequence<last - first>());
}

/// sum over j < terms of weight(j) k[j], unrolled, vanishing weights left out. The first weight must not vanish.
/// @tparam Weight  a lambda without captures, so that it can be evaluated while compiling
template <std::size_t terms, class Weight, class State, std::size_t count>
[[nodiscard]] State combination(Weight /*weight*/, const std::array<State, count>& k) {
  using V = typename State::Scalar;
  static_assert(terms > 0 && terms <= count && Weight()(0) != 0);
  State sum = V(Weight()(0)) * k[0];
  unrolled<1, terms>([&](auto j) {
    constexpr auto weight = Weight()(decltype(j)::value);
    if constexpr (weight != 0) sum += V(weight) * k[j];
  });
  return sum;
}

/// Work done by the integrator, over all lanes.
struct IntegratorStatistics {
  long steps = 0;
  long rejected = 0;
  long rate_evaluations = 0;
  long linearizations = 0;
  long factorizations = 0;
  long event_refinements = 0;
};

/// Tolerances of a step, by lane.
template <class V>
struct Tolerances {
  V rtol;
  V atol;

  /// What an error in component i is measured by.
  template <class State>
  [[nodiscard]] V scale(const State& start, const State& end, Eigen::Index i) const {
    using std::abs;
    using std::max;
    return atol + rtol * max(abs(start[i]), abs(end[i]));
  }
};

}  // namespace turgor
