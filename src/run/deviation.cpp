#include "turgor/run/deviation.hpp"

#include <cmath>

namespace turgor {

Deviation deviation_of(std::span<const Difference> differences) {
  const auto count = static_cast<double>(differences.size());
  Deviation all{0, 0, 0, differences.front().time};
  for (const Difference& difference : differences) {
    all.mean += difference.value / count;
    all.rms += difference.value * difference.value / count;
    if (std::abs(difference.value) > std::abs(all.greatest)) {
      all.greatest = difference.value;
      all.greatest_time = difference.time;
    }
  }
  all.rms = std::sqrt(all.rms);
  return all;
}

}  // namespace turgor
