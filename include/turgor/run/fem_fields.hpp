#pragma once
// The fields that `turgor fem` has written into a run directory.

#include <array>
#include <filesystem>
#include <vector>

#include "turgor/run/vtu.hpp"

namespace turgor {

/// The state of a balloon at one time.
struct FemField {
  double time;                                  ///< [s]
  VtuGrid grid;                                 ///< biquadratic cells at (distance from the axis, height, 0) [m]
  std::vector<double> velocity;                 ///< [m/s], three components for each point
  std::vector<std::array<double, 2>> membrane;  ///< from the pole to the rim, (distance, height) [m]
  std::vector<std::array<double, 2>> membrane_at_start;  ///< the same points at t = 0
};

/// Reads fields one by one, as they are large.
class FemFields {
 public:
  /// @param folder  a run directory
  /// @throws InvalidInput for --fem when it has no fields, naming what is missing or wrong
  explicit FemFields(std::filesystem::path folder);

  [[nodiscard]] std::size_t size() const { return series_.size(); }
  /// [s], increasing
  [[nodiscard]] double time(std::size_t i) const { return series_[i].time; }
  /// @throws InvalidInput for --fem naming the file, when it is missing, broken, or no field of a balloon
  [[nodiscard]] FemField read(std::size_t i) const;

 private:
  std::filesystem::path folder_;
  std::vector<VtuInstant> series_;
};

}  // namespace turgor
