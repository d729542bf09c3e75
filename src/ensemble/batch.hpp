#pragma once
// SIMD batches of xsimd as the integrator's value type. To be included before the integrator.

#include <xsimd/xsimd.hpp>

#include "turgor/integrate/step.hpp"

namespace turgor {

template <class A>
struct Lanes<xsimd::batch<double, A>> {
  using Scalar = double;
  static constexpr int width = static_cast<int>(xsimd::batch<double, A>::size);
};

template <class A>
[[nodiscard]] unsigned bits(const xsimd::batch_bool<double, A>& condition) {
  // xsimd 8 has no such function of its own.
  if constexpr (std::is_integral_v<decltype(condition.data)>) {
    return static_cast<unsigned>(condition.data);
  } else {
    return static_cast<unsigned>(_mm256_movemask_pd(condition.data));
  }
}
using xsimd::any;
using xsimd::select;

}  // namespace turgor
