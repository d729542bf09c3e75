#pragma once
// Which values the members of a sweep have. Any member's values follow from its number alone, so that threads, ranks
// and resumed runs agree.

#include <boost/random/sobol.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "turgor/case/sweep.hpp"

namespace turgor {

/// The values of one axis of a grid, in order.
/// Evenly spaced: from + (to - from) k/(n - 1); in equal ratios: from (to/from)^(k/(n - 1)); both ends exact.
[[nodiscard]] std::vector<Node> grid_values(const Axis& axis);

/// The value of a sampled axis at which its distribution function is u: quantiles by Boost.Math.
/// @param u  strictly between 0 and 1
[[nodiscard]] double quantile_of(const Axis& axis, double u);

/// The members of a sweep, numbered from 0. In a grid the last axis runs fastest. Copy it for each thread.
class SweepPlan {
 public:
  /// Latin hypercubes keep a permutation for each axis: 4 bytes per member and axis.
  /// @throws InvalidInput when that would take more than 1 GB
  explicit SweepPlan(SweepSettings settings);

  [[nodiscard]] const SweepSettings& settings() const { return settings_; }
  [[nodiscard]] std::uint64_t members() const { return settings_.members; }
  /// A grid's index along each axis.
  [[nodiscard]] std::vector<std::uint64_t> indices(std::uint64_t member) const;
  /// One value for each axis, in the form that its key takes.
  [[nodiscard]] std::vector<Node> values(std::uint64_t member);

 private:
  using Permutations = std::vector<std::vector<std::uint32_t>>;

  /// The member's point in the unit cube, strictly inside.
  [[nodiscard]] std::vector<double> point(std::uint64_t member);

  SweepSettings settings_;
  std::vector<std::vector<Node>> grid_;
  std::shared_ptr<const Permutations> strata_;  ///< of a latin hypercube; copies share them
  std::optional<boost::random::sobol> sobol_;
};

}  // namespace turgor
