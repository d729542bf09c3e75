#pragma once
// How far a model is from finite elements.

#include <span>

namespace turgor {

/// model - finite elements at one row.
struct Difference {
  double time;  ///< [s]
  double value;
};

/// Differences over some rows, in their own unit.
struct Deviation {
  double mean;
  double rms;
  double greatest;       ///< in size, with its sign
  double greatest_time;  ///< of the first such row [s]
};

/// @param differences  at least one
[[nodiscard]] Deviation deviation_of(std::span<const Difference> differences);

}  // namespace turgor
