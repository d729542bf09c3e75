#pragma once
// Clocks for comparisons on a machine that others use too.

#include <chrono>
#include <ctime>

namespace turgor::bench {

/// Processor time of some work, of all its threads [s]: other programs on the machine do not count.
template <class Work>
[[nodiscard]] double processor_seconds(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Time by the clock on the wall [s].
template <class Work>
[[nodiscard]] double wall_seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace turgor::bench
