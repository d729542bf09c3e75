// Stream functions and contours against flows that are known.

#include "view/stream_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "view/balloon_pictures.hpp"

namespace turgor {
namespace {

/// The rectangle 0 <= r <= 1, 0 <= z <= 1 in biquadratic cells, its inner nodes moved about.
VtuGrid rectangle(int cells = 6) {
  VtuGrid grid;
  const int nodes = 2 * cells + 1;
  for (int j = 0; j < nodes; ++j) {
    for (int i = 0; i < nodes; ++i) {
      const double x = i / (nodes - 1.0);
      const double y = j / (nodes - 1.0);
      const double bump = 0.05 * std::sin(3 * x) * x * (1 - x) * y * (1 - y);
      grid.points.insert(grid.points.end(), {x + bump, y - bump, 0.0});
    }
  }
  const auto at = [nodes](int i, int j) { return j * nodes + i; };
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

/// Greatest error of the stream function of a flow u(r, z) that has psi(r, z), on cells x cells.
template <class Velocity, class Exact>
double error_of(int cells, const Velocity& u, const Exact& exact) {
  const VtuGrid grid = rectangle(cells);
  std::vector<double> velocity;
  for (std::size_t i = 0; i < grid.points.size(); i += 3) {
    const auto [radial, axial] = u(grid.points[i], grid.points[i + 1]);
    velocity.insert(velocity.end(), {radial, axial, 0.0});
  }
  const auto psi = stream_function(grid, velocity);
  double error = 0;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    error = std::max(error, std::abs(psi[i] - exact(grid.points[3 * i], grid.points[3 * i + 1])));
  }
  return error;
}

// u_z = 2 (1 - r^2) has psi = r^2 - r^4/2. The trapezoidal rule's error is h^2/12 times the integral of |(r u_z)''| =
// 12 r.
TEST(StreamFunction, OfPoiseuillesFlow) {
  const auto u = [](double r, double) { return std::pair(0.0, 2 * (1 - r * r)); };
  const auto exact = [](double r, double) { return r * r - std::pow(r, 4) / 2; };
  const double coarse = error_of(6, u, exact);
  EXPECT_LT(coarse, 0.5 / 144 * 1.05);
  EXPECT_NEAR(coarse / error_of(12, u, exact), 4, 0.1);
}

// Velocity by the law of Biot and Savart, its integral by the trapezoidal rule, which converges exponentially; psi by
// Lamb's complete elliptic integrals (Hydrodynamics, art. 161).
TEST(StreamFunction, OfAVortexRing) {
  constexpr double a = 0.6;  // its radius
  constexpr double b = 1.4;  // its height, above the rectangle
  const auto u = [](double r, double z) {
    constexpr int parts = 256;
    double radial = 0;
    double axial = 0;
    for (int k = 0; k < parts; ++k) {
      const double angle = 2 * std::numbers::pi * k / parts;
      const double distance = std::sqrt(r * r + a * a - 2 * a * r * std::cos(angle) + (z - b) * (z - b));
      radial += a * (z - b) * std::cos(angle) / std::pow(distance, 3) / (2 * parts);
      axial += a * (a - r * std::cos(angle)) / std::pow(distance, 3) / (2 * parts);
    }
    return std::pair(radial, axial);
  };
  const auto exact = [](double r, double z) {
    const double near = std::hypot(r - a, z - b);
    const double far = std::hypot(r + a, z - b);
    const double share = (far - near) / (far + near);
    return (far + near) * (std::comp_ellint_1(share) - std::comp_ellint_2(share)) / (2 * std::numbers::pi);
  };
  ASSERT_GT(exact(1, 1), 0.05);
  const double coarse = error_of(6, u, exact);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_NEAR(coarse / error_of(12, u, exact), 4, 0.3);
}

/// The rectangle with a uniform flow of this speed upwards.
FemField uniform_flow(double speed) {
  FemField field{0, rectangle(), {}, {}, {}};
  for (std::size_t i = 0; i < field.grid.points.size(); i += 3) {
    field.velocity.insert(field.velocity.end(), {0.0, speed, 0.0});
  }
  return field;
}

// 3 m/s through a circle of 1 m: 3 pi m^3/s = 9.42 m^3/s, by at most 30 lines 0.5 m^3/s apart. Between nodes psi is
// taken as linear.
TEST(StreamLines, HaveRoundFluxes) {
  const StreamLines streams = stream_lines(uniform_flow(3), 1e-3);
  EXPECT_EQ(streams.flux, 0.5);
  ASSERT_EQ(streams.lines.size(), 18U);
  for (std::size_t i = 0; i < streams.lines.size(); ++i) {
    const double flux = 0.5 * static_cast<double>(i + 1);
    EXPECT_NEAR(streams.lines[i].flux, flux, 1e-12);
    constexpr double h = 1.0 / 12;
    for (const auto& [r, z] : streams.lines[i].points) {
      EXPECT_NEAR(3 * std::numbers::pi * r * r, flux, 3 * std::numbers::pi * h * h / 3.5);
    }
  }
  const StreamLines down = stream_lines(uniform_flow(-3), 1e-3);
  ASSERT_EQ(down.lines.size(), 18U);
  EXPECT_NEAR(down.lines[0].flux, -9, 1e-12);
}

TEST(StreamLines, OfALiquidAtRestAreNone) {
  EXPECT_TRUE(stream_lines(uniform_flow(0), 1e-3).lines.empty());
  EXPECT_TRUE(stream_lines(uniform_flow(1e-4), 1e-3).lines.empty());
  EXPECT_EQ(stream_lines(uniform_flow(1e-4), 1e-3).flux, 0);
  EXPECT_EQ(stream_lines(uniform_flow(0), 0).flux, 0);
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
