#pragma once
// The integrator's value type in a SIMD kernel: a batch of xsimd of as many lanes as TURGOR_KERNEL_LANES says, or
// double. To be included before the integrator, once in each kernel's source.

#include "turgor/integrate/step.hpp"

#if TURGOR_KERNEL_LANES > 1

#include <xsimd/xsimd.hpp>

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

#endif

namespace turgor {
namespace {

#if TURGOR_KERNEL_LANES > 1
using KernelValue = xsimd::batch<double>;
#else
using KernelValue = double;
#endif
static_assert(Lanes<KernelValue>::width == TURGOR_KERNEL_LANES);

}  // namespace
}  // namespace turgor
