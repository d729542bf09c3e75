#pragma once
// Numbers and SIMD batches of them under one name: formulas are written once, for a value type V whose lanes are
// independent.

namespace turgor {

/// What a scalar type is made of: itself, one lane wide. Specialised for SIMD batches.
template <class V>
struct Lanes {
  using Scalar = V;
  static constexpr int width = 1;
};
template <class V>
using ScalarOf = typename Lanes<V>::Scalar;

/// Lane-wise choice; SIMD batches have their own by the same name.
template <class T>
[[nodiscard]] constexpr T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
[[nodiscard]] constexpr bool any(bool condition) { return condition; }

// NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): a batch is nothing but its lanes
/// One lane of a value.
template <class V>
[[nodiscard]] ScalarOf<V>& lane(V& value, int index) {
  return reinterpret_cast<ScalarOf<V>*>(&value)[index];
}
template <class V>
[[nodiscard]] const ScalarOf<V>& lane(const V& value, int index) {
  return reinterpret_cast<const ScalarOf<V>*>(&value)[index];
}
// NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
/// A function without a SIMD form that treats all lanes alike.
template <class V, class Function>
[[nodiscard]] V lane_by_lane(V value, const Function& function) {
  for (int l = 0; l < Lanes<V>::width; ++l) lane(value, l) = function(lane(value, l));
  return value;
}
/// Bit l is set where lane l of a condition holds.
[[nodiscard]] constexpr unsigned bits(bool condition) { return condition ? 1U : 0U; }

}  // namespace turgor
