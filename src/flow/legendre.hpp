#pragma once
// Legendre polynomials near x = -1 without cancellation.

namespace turgor {

/// p_m = (-1)^m P_m(eps - 1) for m = 0, 1, 2, ... by the recurrence of their differences, and
/// h_m = int_{-1}^{eps-1} P_m dx.
/// @tparam V      a number or an array of numbers
/// @tparam Count  for m
template <class V, class Count = double>
class LegendreNearMinusOne {
 public:
  /// @param eps  x + 1, 0 to 2
  explicit LegendreNearMinusOne(const V& eps)
      : eps_(eps), value_(0 * eps + 1), difference_(-eps), last_difference_(0 * eps) {}

  [[nodiscard]] const V& value() const { return value_; }
  /// p_m - p_{m-1}; 0 for m = 0.
  [[nodiscard]] const V& last_difference() const { return last_difference_; }
  /// (-1)^m h_m.
  [[nodiscard]] V integral() const {
    if (m_ == 0) return eps_;
    return -(difference_ + last_difference_) / (2 * m_ + 1);
  }
  /// On to m + 1.
  void advance() {
    last_difference_ = difference_;
    value_ += difference_;
    m_ += 1;
    difference_ = (m_ * difference_ - (2 * m_ + 1) * eps_ * value_) / (m_ + 1);
  }

 private:
  V eps_;
  Count m_ = 0;
  V value_;
  V difference_;       ///< p_{m+1} - p_m
  V last_difference_;  ///< p_m - p_{m-1}
};

}  // namespace turgor
