// The mesh of the balloon and its channel: geometry, topology, quality, sizes.

#include "turgor/mesh/balloon_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "../support/seed.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace turgor {
namespace {

using std::numbers::pi;
using Place = std::complex<double>;
using Nodes = std::array<Place, 9>;  ///< of a biquadratic cell, row by row

MeshRequest usual(double a, double channel = 0) { return {a, channel, 0.3, a / 60, a / 15, 0.008}; }

MeshRequest finer(MeshRequest q, double factor) {
  q.rim /= factor;
  q.orifice /= factor;
  q.wall /= factor;
  return q;
}

MeshRequest random_request(std::mt19937_64& random) {
  MeshRequest q{};
  q.orifice_radius = std::exp(test::between(random, std::log(0.001), std::log(0.1)));
  q.radius = q.orifice_radius * std::exp(test::between(random, std::log(least_radius_ratio * 1.001), std::log(100)));
  q.channel_length = test::between(random, 0, 1) < 0.5 ? 0 : q.orifice_radius * test::between(random, 0.1, 20);
  q.orifice = q.orifice_radius / test::between(random, 3, 30);
  q.rim = q.orifice / test::between(random, 1, 10);
  q.wall = q.radius / 4 * test::between(random, 0.1, 1);
  q.wall = std::max(q.wall, q.orifice);
  if (q.wall > q.radius / 4) q.orifice = q.rim = q.wall = q.radius / 4 / (q.radius > 4 * q.orifice_radius ? 1 : 2);
  q.orifice = std::min(q.orifice, q.orifice_radius / 3);
  q.rim = std::min(q.rim, q.orifice);
  return q;
}

Place corner(const BalloonMesh& mesh, std::size_t cell, std::size_t i) {
  const auto& [r, z] = mesh.points[mesh.cells[cell][i % 4]];
  return {r, z};
}

Place place(const std::array<double, 2>& x) { return {x[0], x[1]}; }

Nodes nodes(const BalloonMesh& mesh, std::size_t cell, auto&& motion) {
  Nodes result;
  for (std::size_t k = 0; k < 9; ++k) {
    result[k] = place(motion(mesh.at(cell, 0.5 * static_cast<double>(k % 3), 0.5 * static_cast<double>(k / 3))));
  }
  return result;
}

std::array<double, 3> quadratic(double x) { return {(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)}; }
std::array<double, 3> quadratic_slope(double x) { return {4 * x - 3, 4 - 8 * x, 4 * x - 1}; }

struct Point {
  Place place;
  double jacobian;
};

Point biquadratic(const Nodes& nodes, double xi, double eta) {
  Place x = 0;
  Place by_xi = 0;
  Place by_eta = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    x += nodes[k] * quadratic(xi)[k % 3] * quadratic(eta)[k / 3];
    by_xi += nodes[k] * quadratic_slope(xi)[k % 3] * quadratic(eta)[k / 3];
    by_eta += nodes[k] * quadratic(xi)[k % 3] * quadratic_slope(eta)[k / 3];
  }
  return {x, std::imag(std::conj(by_xi) * by_eta)};
}

constexpr std::array<double, 4> gauss{0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
constexpr std::array<double, 4> weight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};

/// Volume of revolution of the biquadratic cells, whose integrands are of degree 5 in either coordinate: exact.
double volume(const BalloonMesh& mesh, auto&& motion) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Nodes n = nodes(mesh, c, motion);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const Point x = biquadratic(n, gauss[i], gauss[j]);
        sum += 2 * pi * x.place.real() * x.jacobian * weight[i] * weight[j];
      }
    }
  }
  return sum;
}

double exact_volume(double a, double channel, double radius) {
  const double height = radius + std::sqrt(radius * radius - a * a);
  return pi * height * height * (3 * radius - height) / 3 + pi * a * a * channel;
}

std::array<double, 2> stay(const std::array<double, 2>& x) { return x; }

struct Quality {
  double least_angle = 180;
  double greatest_angle = 0;
  double aspect = 0;  ///< greatest ratio of sides above the orifice's plane
};

Quality quality(const BalloonMesh& mesh) {
  Quality q;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    double least = HUGE_VAL;
    double greatest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Place next = corner(mesh, c, i + 1) - corner(mesh, c, i);
      const double angle = std::arg((corner(mesh, c, i + 3) - corner(mesh, c, i)) / next) * 180 / pi;
      q.least_angle = std::min(q.least_angle, angle);
      q.greatest_angle = std::max(q.greatest_angle, angle);
      least = std::min(least, std::abs(next));
      greatest = std::max(greatest, std::abs(next));
    }
    if (corner(mesh, c, 2).imag() > 0) q.aspect = std::max(q.aspect, greatest / least);
  }
  return q;
}

/// Lengths of the edges on a side, by their middles.
std::vector<std::pair<Place, double>> edges(const BalloonMesh& mesh, Side side) {
  std::vector<std::pair<Place, double>> result;
  for (const auto& edge : mesh.boundary) {
    if (edge.side != side) continue;
    const Place a = place(mesh.points[edge.points[0]]);
    const Place b = place(mesh.points[edge.points[1]]);
    result.emplace_back((a + b) / 2.0, std::abs(b - a));
  }
  return result;
}

double length(const BalloonMesh& mesh, Side side) {
  double sum = 0;
  for (const auto& [middle, edge] : edges(mesh, side)) sum += edge;
  return sum;
}

void expect_sound(const BalloonMesh& mesh, const MeshRequest& q) {
  std::map<std::pair<std::size_t, std::size_t>, int> directed;
  std::set<std::pair<double, double>> different;
  for (const auto& [r, z] : mesh.points) EXPECT_TRUE(different.insert({r, z}).second);
  for (const auto& cell : mesh.cells) {
    for (std::size_t i = 0; i < 4; ++i) ++directed[{cell[i], cell[(i + 1) % 4]}];
  }
  std::size_t lonely = 0;
  for (const auto& [edge, count] : directed) {
    EXPECT_EQ(count, 1);  // neighbours run along their edge in opposite ways
    lonely += directed.contains({edge.second, edge.first}) ? 0U : 1U;
  }
  ASSERT_EQ(mesh.boundary.size(), lonely);
  std::map<std::size_t, std::size_t> next;
  for (const auto& edge : mesh.boundary) {
    EXPECT_EQ((directed[{edge.points[0], edge.points[1]}]), 1);
    EXPECT_TRUE(next.emplace(edge.points[0], edge.points[1]).second);
  }
  std::size_t point = mesh.boundary.front().points[0];
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    ASSERT_TRUE(next.contains(point));
    const std::size_t following = next[point];
    next.erase(point);
    point = following;
  }
  EXPECT_EQ(point, mesh.boundary.front().points[0]);  // one closed line
  // Euler's formula of a disc
  EXPECT_EQ(mesh.points.size() + mesh.cells.size() + 1, (directed.size() + lonely) / 2 + 1 + 1);

  const double centre = std::sqrt((q.radius - q.orifice_radius) * (q.radius + q.orifice_radius));
  for (const auto& edge : mesh.boundary) {
    for (const std::size_t p : edge.points) {
      const auto& [r, z] = mesh.points[p];
      if (edge.side == Side::axis) {
        EXPECT_EQ(r, 0);
      }
      if (edge.side == Side::inlet) {
        EXPECT_EQ(z, -q.channel_length);
      }
      if (edge.side == Side::channel) {
        EXPECT_EQ(r, q.orifice_radius);
      }
      if (edge.side == Side::wall) {
        EXPECT_NEAR(std::hypot(r, z - centre), q.radius, 1e-14 * q.radius);
      }
    }
  }
  // sums of up to a thousand lengths
  EXPECT_NEAR(length(mesh, Side::axis), centre + q.radius + q.channel_length, 1e-12 * q.radius);
  EXPECT_NEAR(length(mesh, Side::inlet), q.orifice_radius, 1e-12 * q.radius);
  EXPECT_NEAR(length(mesh, Side::channel), q.channel_length, 1e-12 * q.radius);
}

/// Jacobians at Gauss points and corners, over the cell's area.
double least_jacobian(const BalloonMesh& mesh, auto&& motion) {
  double least = HUGE_VAL;
  constexpr std::array<double, 5> places{0, gauss[0], gauss[1], gauss[2], 1};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Nodes n = nodes(mesh, c, motion);
    const double area = std::imag(std::conj(n[8] - n[0]) * (n[6] - n[2])) / 2;
    for (const double xi : places) {
      for (const double eta : places) least = std::min(least, biquadratic(n, xi, eta).jacobian / area);
    }
  }
  return least;
}

TEST(BalloonMesh, IsConformingAndFillsEveryDefaultBalloon) {
  for (const double a : {0.005, 0.01, 0.02, 0.03}) {
    for (const double channel : {0.0, 0.5}) {
      const MeshRequest q = usual(a, channel);
      const BalloonMesh mesh = balloon_mesh(q);
      expect_sound(mesh, q);
      // biquadratic arcs of 2 degrees: their error is theta^4 / 2000 of their sagitta
      EXPECT_NEAR(volume(mesh, stay) / exact_volume(a, channel, q.radius), 1, 2e-8);
      const Quality shape = quality(mesh);
      EXPECT_GT(shape.least_angle, 45);
      EXPECT_LT(shape.greatest_angle, 140);
      EXPECT_LT(shape.aspect, 4);
      EXPECT_GT(least_jacobian(mesh, stay), 0.2);
    }
  }
}

TEST(BalloonMesh, HasSoManyCells) {
  EXPECT_LT(balloon_mesh(usual(0.03)).cells.size(), 2600U);
  EXPECT_LT(balloon_mesh(usual(0.03, 0.3)).cells.size(), 3600U);
  EXPECT_LT(balloon_mesh(usual(0.005)).cells.size(), 3300U);
}

TEST(BalloonMesh, IsRefinedByHalvingTheSizes) {
  for (const double a : {0.005, 0.03}) {
    for (const double channel : {0.0, 0.5}) {
      double before = static_cast<double>(balloon_mesh(usual(a, channel)).cells.size());
      double error = std::abs(volume(balloon_mesh(usual(a, channel)), stay) - exact_volume(a, channel, 0.3));
      for (const double factor : {2.0, 4.0}) {
        const BalloonMesh mesh = balloon_mesh(finer(usual(a, channel), factor));
        const auto cells = static_cast<double>(mesh.cells.size());
        EXPECT_NEAR(cells / before, 4, 0.3);  // whole numbers in both directions: half a step in 13, or in 25
        before = cells;
        // of fourth order
        const double remaining = std::abs(volume(mesh, stay) - exact_volume(a, channel, 0.3));
        EXPECT_LT(remaining, error / 10);
        error = remaining;
        EXPECT_GT(quality(mesh).least_angle, 45);
        EXPECT_LT(quality(mesh).greatest_angle, 140);
      }
    }
  }
}

TEST(BalloonMesh, MeetsTheSizes) {
  for (const double a : {0.005, 0.01, 0.02, 0.03}) {
    for (const double factor : {1.0, 2.0}) {
      const MeshRequest q = finer(usual(a, 0.5), factor);
      const BalloonMesh mesh = balloon_mesh(q);
      const Place rim = a;
      for (const auto side : {Side::wall, Side::channel}) {
        const auto all = edges(mesh, side);
        const auto at_rim = *std::ranges::min_element(all, {}, [&](const auto& e) { return std::abs(e.first - rim); });
        EXPECT_LT(at_rim.second, 1.5 * q.rim);
        EXPECT_GT(at_rim.second, q.rim / 1.5);
      }
      for (const auto& [middle, size] : edges(mesh, Side::inlet)) {
        EXPECT_LT(size, 1.5 * q.orifice);
        if (middle.real() < a / 2) {
          EXPECT_GT(size, q.orifice / 1.5);
        }
      }
      for (const auto& [middle, size] : edges(mesh, Side::wall)) {
        EXPECT_LT(size, 1.5 * q.wall);
        if (middle.imag() > 0.3 && middle.imag() < 0.5) {
          EXPECT_GT(size, q.wall / 1.5);
        }
      }
      for (const auto& [middle, size] : edges(mesh, Side::axis)) {
        if (std::abs(middle.imag() - a / 8) < a / 8) {
          EXPECT_LT(size, 1.5 * q.orifice);
        }
      }
      for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_LT(std::abs(corner(mesh, c, i + 1) - corner(mesh, c, i)), 2 * q.wall);
        }
      }
    }
  }
}

TEST(BalloonMesh, BlendsCellsWithTheWallsArc) {
  const MeshRequest q = usual(0.03);
  const BalloonMesh mesh = balloon_mesh(q);
  std::size_t on_wall = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT(std::abs(place(mesh.at(c, corners[i][0], corners[i][1])) - corner(mesh, c, i)), 1e-15);
    }
    Place mean = 0;
    for (std::size_t i = 0; i < 4; ++i) mean += corner(mesh, c, i) / 4.0;
    if (mesh.wall_edge[c] == BalloonMesh::no_edge) {
      EXPECT_LT(std::abs(place(mesh.at(c, 0.5, 0.5)) - mean), 1e-15);
      continue;
    }
    ++on_wall;
    const auto e = static_cast<std::size_t>(mesh.wall_edge[c]);
    const auto along_edge = [&](std::size_t edge, double s) {
      const auto& from = corners[edge % 4];
      const auto& to = corners[(edge + 1) % 4];
      return place(mesh.at(c, std::lerp(from[0], to[0], s), std::lerp(from[1], to[1], s)));
    };
    const Place centre{0, mesh.sphere_centre};
    for (const double s : {0.25, 0.5, 0.9}) {
      const Place x = along_edge(e, s);
      EXPECT_NEAR(std::abs(x - centre), q.radius, 1e-15);
      EXPECT_NEAR(std::arg((x - centre) / (corner(mesh, c, e) - centre)),
                  s * std::arg((corner(mesh, c, e + 1) - centre) / (corner(mesh, c, e) - centre)), 1e-14);
      for (const std::size_t other : {e + 1, e + 2, e + 3}) {
        const Place straight = (1 - s) * corner(mesh, c, other) + s * corner(mesh, c, other + 1);
        EXPECT_LT(std::abs(along_edge(other, s) - straight), 1e-15);
      }
    }
  }
  EXPECT_EQ(on_wall, edges(mesh, Side::wall).size());
}

TEST(BalloonMesh, StaysSoundWhenTheBalloonMoves) {
  for (const double a : {0.005, 0.03, 0.15}) {
    const MeshRequest q{a, a, 0.3, a / 60, a / 15, 0.02};
    const BalloonMesh mesh = balloon_mesh(q);
    const ToroidalMotion motion(a, q.radius);
    for (const double ratio : {0.9, 1.1, 1.5, 2.0, 2.5}) {
      const auto moved = [&](const std::array<double, 2>& X) { return motion.position(X, ratio * q.radius); };
      EXPECT_GT(least_jacobian(mesh, moved), 0.15) << a << " " << ratio;
      // arcs of up to 9 degrees
      EXPECT_NEAR(volume(mesh, moved) / exact_volume(a, a, ratio * q.radius), 1, 2e-5);
    }
  }
}

TEST(BalloonMesh, IsSoundForAnyBalloon) {
  std::mt19937_64 random(test::random_seed());
  for (int i = 0; i < 100; ++i) {
    const MeshRequest q = random_request(random);
    SCOPED_TRACE(testing::Message() << q.orifice_radius << " " << q.channel_length << " " << q.radius << " " << q.rim
                                    << " " << q.orifice << " " << q.wall);
    const BalloonMesh mesh = balloon_mesh(q);
    expect_sound(mesh, q);
    // worst of 17000 small ones: 0.27, and 32 and 148 degrees, with 3 cells over an orifice of R/1.6
    EXPECT_GT(least_jacobian(mesh, stay), 0.2);
    EXPECT_GT(quality(mesh).least_angle, 30);
    EXPECT_LT(quality(mesh).greatest_angle, 155);
    if (HasFailure()) break;
  }
}

std::string message(const MeshRequest& q) {
  try {
    (void)balloon_mesh(q);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BalloonMesh, SaysWhatIsWrongWithARequest) {
  const MeshRequest good = usual(0.03, 0.5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Lengths {
    double MeshRequest::* member;
    const char* key;
  };
  for (const Lengths& one : {Lengths{&MeshRequest::orifice_radius, "inlet.orifice_radius = "},
                             {&MeshRequest::channel_length, "inlet.channel_length = "},
                             {&MeshRequest::radius, "balloon.radius = "},
                             {&MeshRequest::rim, "fem.h_rim = "},
                             {&MeshRequest::orifice, "fem.h_orifice = "},
                             {&MeshRequest::wall, "fem.h_wall = "}}) {
    for (const double value : {-1.0, nan, HUGE_VAL}) {
      MeshRequest q = good;
      q.*one.member = value;
      EXPECT_NE(message(q).find(one.key), std::string::npos) << message(q);
    }
  }
  const auto expect = [](const MeshRequest& q, const std::string& text) {
    EXPECT_NE(message(q).find(text), std::string::npos) << message(q);
  };
  expect({0.03, 0, 0.3, 0.003, 0.002, 0.008}, "fem.h_rim = 0.003 m: larger than fem.h_orifice = 0.002 m");
  expect({0.03, 0, 0.3, 0.003, 0.011, 0.02}, "fem.h_orifice = 0.011 m: fewer than three cells");
  expect({0.03, 0, 0.3, 0.0005, 0.002, 0.001}, "fem.h_wall = 0.001 m: smaller than fem.h_orifice");
  expect({0.03, 0, 0.3, 0.0005, 0.002, 0.08}, "fem.h_wall = 0.08 m: too large to follow the wall");
  expect({0.2, 0, 0.3, 0.0005, 0.002, 0.008}, "balloon.radius = 0.3 m: the orifice is too wide");
  expect({1e-5, 0, 0.3, 1e-7, 1e-6, 0.008}, "inlet.orifice_radius = 1e-05 m: too small");
  expect({0.03, 0, 0.3, 1e-6, 1e-5, 0.008}, "fem.h_orifice = 1e-05 m: the mesh would have about");
  expect({0.03, 0, 0.3, 1e-6, 1e-4, 1e-4}, "fem.h_wall = 1e-04 m: the mesh would have about");
  expect({0.03, 1e9, 0.3, 0.0005, 0.002, 0.008}, "fem.h_rim = 5e-04 m: the mesh would have about");
  expect({0.03, 0, 0.3, 1e-300, 1e-299, 1e-298}, "cells; at most");
  // all of them at once
  expect({0.03, 0, 0.3, 0.02, 0.011, 0.08}, "fem.h_wall");
  expect({0.03, 0, 0.3, 0.02, 0.011, 0.08}, "fem.h_rim");
}

}  // namespace
}  // namespace turgor
