#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "turgor/base/lanes.hpp"
#include "turgor/material/equibiaxial.hpp"

namespace turgor {

/// The nominal stress s of a wall in equal biaxial stretch, known at some stretches.
///
/// Between them a cubic spline with continuous second derivative, not-a-knot at its ends; beyond them a straight line
/// with the slope at the end. Never changes, so that threads can share it.
template <class T>
class StressTable {
 public:
  /// @param stretch  lambda [1], > 0, strictly increasing; at least four, of which one is 1 and the last is larger
  /// @param stress   force per unstretched area [Pa], as many; 0 at stretch 1
  /// @throws InvalidInput for material.table.stretch or material.table.stress, with the index of the first that is
  /// wrong
  StressTable(std::vector<T> stretch, const std::vector<T>& stress);

  /// W = 2 int_1^lambda s, as stretching in two directions does work in both, with W' = 2 s and W'' = 2 s'.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    const auto after = std::upper_bound(stretch_.begin(), stretch_.end(), real_part(lambda));
    const Piece& p = pieces_[static_cast<std::size_t>(after - stretch_.begin())];
    const std::array<T, 4>& s = p.stress;
    const S x = lambda - p.about;
    return {T(2) * p.energy + x * (T(2) * s[0] + x * (s[1] + x * (T(2) * s[2] / T(3) + x * (s[3] / T(2))))),
            T(2) * (s[0] + x * (s[1] + x * (s[2] + x * s[3]))), T(2) * s[1] + x * (T(4) * s[2] + x * (T(6) * s[3]))};
  }

  [[nodiscard]] const T& least_stretch() const { return stretch_.front(); }
  [[nodiscard]] const T& greatest_stretch() const { return stretch_.back(); }

  friend bool operator==(const StressTable&, const StressTable&) = default;

 private:
  /// s as a cubic in lambda - about, where about is the end nearer to 1: small strains keep their digits.
  struct Piece {
    T about;
    T energy;                 ///< int_1^about s
    std::array<T, 4> stress;  ///< coefficients of 1, x, x^2, x^3
    friend bool operator==(const Piece&, const Piece&) = default;
  };

  std::vector<T> stretch_;
  std::vector<Piece> pieces_;  ///< below each stretch, and beyond the last
};

extern template class StressTable<double>;
extern template class StressTable<long double>;

/// A wall given by a table. V is a number, or a batch of them whose lanes have a table each; copies share tables.
template <class V>
struct Tabulated {
  std::array<std::shared_ptr<const StressTable<ScalarOf<V>>>, static_cast<std::size_t>(Lanes<V>::width)> tables{};

  friend bool operator==(const Tabulated& a, const Tabulated& b) {
    return std::equal(a.tables.begin(), a.tables.end(), b.tables.begin(),
                      [](const auto& s, const auto& t) { return s == t || (s && t && *s == *t); });
  }

  /// W and its derivatives at stretch lambda; no table may be null.
  template <class S>
  [[nodiscard]] Jet<S> energy(const S& lambda) const {
    if constexpr (Lanes<S>::width == 1) {
      return tables[0]->energy(lambda);
    } else {
      Jet<S> all{S(0.0), S(0.0), S(0.0)};
      for (int l = 0; l < Lanes<S>::width; ++l) {
        const Jet<ScalarOf<S>> one = tables[static_cast<std::size_t>(l)]->energy(lane(lambda, l));
        lane(all.value, l) = one.value;
        lane(all.first, l) = one.first;
        lane(all.second, l) = one.second;
      }
      return all;
    }
  }
};

/// A wall of the given points, as StressTable takes them.
template <class T>
[[nodiscard]] Tabulated<T> tabulated(std::vector<T> stretch, const std::vector<T>& stress) {
  return {{std::make_shared<const StressTable<T>>(std::move(stretch), stress)}};
}

}  // namespace turgor
