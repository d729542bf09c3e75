#pragma once
// Integer powers by multiplication: exact in rounding for every scalar type, and faster than pow.

namespace turgor {

/// x^N for a non-negative integer N known at compile time.
template <int N, class S>
[[nodiscard]] constexpr S power(const S& x) {
  static_assert(N >= 0);
  if constexpr (N == 0) {
    return S(1);
  } else if constexpr (N == 1) {
    return x;
  } else {
    const S half = power<N / 2>(x);
    if constexpr (N % 2 == 0) {
      return half * half;
    } else {
      return half * half * x;
    }
  }
}

}  // namespace turgor
