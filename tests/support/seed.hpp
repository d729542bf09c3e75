#pragma once
// Where the random numbers of tests begin: anew each time, or as TURGOR_TEST_SEED says.

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>

namespace turgor::test {

/// Prints what it returns, so that a failure can be repeated.
[[nodiscard]] inline std::uint64_t random_seed() {
  const char* given = std::getenv("TURGOR_TEST_SEED");
  const std::uint64_t seed = given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
  std::cout << "TURGOR_TEST_SEED=" << seed << "\n";
  return seed;
}

[[nodiscard]] inline double between(std::mt19937_64& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

}  // namespace turgor::test
