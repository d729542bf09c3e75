#include <gtest/gtest.h>

#include "sphere_modes.hpp"

namespace turgor {
namespace {

TEST(ShapeModes, OfASphereFilledWithLiquid) {
  const std::array<double, 2> exact{exact_frequency(sample_wall(), 2), exact_frequency(sample_wall(), 3)};
  EXPECT_NEAR(exact[0], 6.823, 1e-3);  // another program's digits
  EXPECT_NEAR(exact[1], 11.788, 1e-3);
  std::array<std::vector<double>, 2> errors;
  for (const std::size_t elements : {8U, 16U, 32U}) {
    const auto found = sphere_frequencies(elements);
    EXPECT_LT(found[1], 0.03 * found[2]);  // nothing resists a shift
    for (std::size_t i = 0; i < 2; ++i) errors[i].push_back(std::abs(found[i + 2] / exact[i] - 1));
  }
  for (const auto& of_mode : errors) {
    EXPECT_LT(of_mode.back(), 2e-5);
    EXPECT_NEAR(observed_order(of_mode), 4, 0.1);
  }
}

}  // namespace
}  // namespace turgor
