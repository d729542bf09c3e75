// Images of flows: what stands in a pixel, and where the pixel stands.

#include "view/speed_image.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "view/stream_lines.hpp"

namespace turgor {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Columns at -3, -1, 1, 3 times half a pixel, rows from 0.1 upwards; in units that are a tenth of a pixel's.
TEST(ImageBlock, MirrorsItsValuesAtTheAxis) {
  const Pixels pixels{"speed", 0.2, 0.1, 2, 2};
  EXPECT_EQ(image_block(pixels, {1, 2, 3, nothing}, 10),
            "$speed << EOD\n"
            "4 -3 -1 1 3\n"
            "2 2 1 1 2\n"
            "4 NaN 3 3 NaN\n"
            "EOD\n");
}

/// One biquadratic cell over 0 <= r <= 1, 0 <= z <= 2.
VtuGrid cell() {
  VtuGrid grid;
  const std::array<std::array<double, 2>, 9> nodes{
      {{0, 0}, {1, 0}, {1, 2}, {0, 2}, {0.5, 0}, {1, 1}, {0.5, 2}, {0, 1}, {0.5, 1}}};
  for (const auto& [r, z] : nodes) grid.points.insert(grid.points.end(), {r, z, 0.0});
  grid.biquadratic.push_back({0, 1, 2, 3, 4, 5, 6, 7, 8});
  return grid;
}

// Colours are linear on triangles between nodes, so a linear field is met exactly.
TEST(SpeedImage, HasTheValuesAtTheMiddlesOfItsPixels) {
  const VtuGrid grid = cell();
  const auto field = [](double r, double z) { return 3 + r - 2 * z; };
  std::vector<double> speed;
  for (std::size_t i = 0; i < grid.points.size(); i += 3) speed.push_back(field(grid.points[i], grid.points[i + 1]));
  const Pixels pixels{"speed", 0.3, -0.5, 5, 9};
  const std::vector<double> values = speed_image(grid, node_triangles(grid), speed, pixels);
  ASSERT_EQ(values.size(), 45U);
  for (std::size_t j = 0; j < 9; ++j) {
    for (std::size_t i = 0; i < 5; ++i) {
      const double r = 0.3 * (static_cast<double>(i) + 0.5);
      const double z = -0.5 + 0.3 * (static_cast<double>(j) + 0.5);
      const double value = values[5 * j + i];
      if (r < 1 && z > 0 && z < 2) {
        EXPECT_NEAR(value, field(r, z), 1e-12) << r << " " << z;
      } else {
        EXPECT_TRUE(std::isnan(value)) << r << " " << z;
      }
    }
  }
}

TEST(SpeedImage, TakesTheSpeedFromBothComponents) {
  EXPECT_EQ(speeds({3, -4, 0, 0, 5, 0}), (std::vector<double>{5, 5}));
}

}  // namespace
}  // namespace turgor
