// Stream functions and contours against flows that are known.

#include "view/stream_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace turgor {
namespace {

constexpr int cells = 6;

/// The rectangle 0 <= r <= 1, 0 <= z <= 1 in biquadratic cells, its inner nodes moved about.
VtuGrid rectangle() {
  VtuGrid grid;
  constexpr int nodes = 2 * cells + 1;
  for (int j = 0; j < nodes; ++j) {
    for (int i = 0; i < nodes; ++i) {
      const double x = i / (nodes - 1.0);
      const double y = j / (nodes - 1.0);
      const double bump = 0.05 * std::sin(3 * x) * x * (1 - x) * y * (1 - y);
      grid.points.insert(grid.points.end(), {x + bump, y - bump, 0.0});
    }
  }
  const auto at = [](int i, int j) { return j * nodes + i; };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = 2 * i;
      const int b = 2 * j;
      grid.biquadratic.push_back({at(a, b), at(a + 2, b), at(a + 2, b + 2), at(a, b + 2), at(a + 1, b),
                                  at(a + 2, b + 1), at(a + 1, b + 2), at(a, b + 1), at(a + 1, b + 1)});
    }
  }
  return grid;
}

// The trapezoidal rule is exact for r u_z linear in r.
TEST(StreamFunction, OfAUniformFlowIsExact) {
  const VtuGrid grid = rectangle();
  std::vector<double> velocity;
  for (std::size_t i = 0; i < grid.points.size() / 3; ++i) velocity.insert(velocity.end(), {0.0, 3.0, 0.0});
  const auto psi = stream_function(grid, velocity);
  for (std::size_t i = 0; i < psi.size(); ++i)
    EXPECT_NEAR(psi[i], 1.5 * grid.points[3 * i] * grid.points[3 * i], 1e-12);
}

// u = (-r, 2 z) has psi = r^2 z; h = 1/12, the rule's error is of second order.
TEST(StreamFunction, OfAStagnationFlow) {
  const VtuGrid grid = rectangle();
  std::vector<double> velocity;
  for (std::size_t i = 0; i < grid.points.size() / 3; ++i) {
    velocity.insert(velocity.end(), {-grid.points[3 * i], 2 * grid.points[3 * i + 1], 0.0});
  }
  const auto psi = stream_function(grid, velocity);
  for (std::size_t i = 0; i < psi.size(); ++i) {
    EXPECT_NEAR(psi[i], grid.points[3 * i] * grid.points[3 * i] * grid.points[3 * i + 1], 2e-3);
  }
}

TEST(Contour, OfAPlaneIsOneStraightLine) {
  const VtuGrid grid = rectangle();
  std::vector<double> plane;
  for (std::size_t i = 0; i < grid.points.size() / 3; ++i) plane.push_back(grid.points[3 * i] + grid.points[3 * i + 1]);
  const auto lines = contour(grid, node_triangles(grid), plane, 0.77);
  ASSERT_EQ(lines.size(), 1U);
  for (const auto& [r, z] : lines[0]) EXPECT_NEAR(r + z, 0.77, 1e-12);
  const auto [first, last] = std::pair(lines[0].front(), lines[0].back());
  EXPECT_NEAR(std::hypot(first[0] - last[0], first[1] - last[1]), 0.77 * std::sqrt(2.0), 1e-12);
}

TEST(Contour, OfAHillIsClosed) {
  const VtuGrid grid = rectangle();
  std::vector<double> hill;
  for (std::size_t i = 0; i < grid.points.size() / 3; ++i) {
    hill.push_back(std::hypot(grid.points[3 * i] - 0.5, grid.points[3 * i + 1] - 0.5));
  }
  const auto lines = contour(grid, node_triangles(grid), hill, 0.3);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  EXPECT_GT(lines[0].size(), 20U);
  EXPECT_TRUE(contour(grid, node_triangles(grid), hill, 2).empty());
}

}  // namespace
}  // namespace turgor
