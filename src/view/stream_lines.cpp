#include "stream_lines.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace turgor {

namespace {

using Side = std::pair<std::size_t, std::size_t>;  ///< of triangles, the lesser point first

Side side(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

PlanePoint point(const VtuGrid& grid, std::size_t i) { return {grid.points[3 * i], grid.points[3 * i + 1]}; }

std::set<Side> sides_of(const std::vector<std::array<std::size_t, 3>>& triangles) {
  std::set<Side> sides;
  for (const auto& [a, b, c] : triangles) sides.insert({side(a, b), side(b, c), side(c, a)});
  return sides;
}

/// Flux between two points over 2 pi, by the trapezoidal rule: int r (u_z dr - u_r dz).
double flux(const VtuGrid& grid, const std::vector<double>& velocity, std::size_t a, std::size_t b) {
  const auto [ra, za] = point(grid, a);
  const auto [rb, zb] = point(grid, b);
  const double radial = (ra * velocity[3 * a] + rb * velocity[3 * b]) / 2;
  const double axial = (ra * velocity[3 * a + 1] + rb * velocity[3 * b + 1]) / 2;
  return axial * (rb - ra) - radial * (zb - za);
}

}  // namespace

std::vector<std::array<std::size_t, 3>> node_triangles(const VtuGrid& grid) {
  constexpr std::array<std::array<std::size_t, 3>, 8> parts{
      {{0, 4, 8}, {0, 8, 7}, {4, 1, 5}, {4, 5, 8}, {8, 5, 2}, {8, 2, 6}, {7, 8, 6}, {7, 6, 3}}};
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& cell : grid.biquadratic) {
    for (const auto& part : parts) {
      auto& triangle = triangles.emplace_back();
      std::ranges::transform(part, triangle.begin(), [&](std::size_t k) { return static_cast<std::size_t>(cell[k]); });
    }
  }
  return triangles;
}

std::vector<double> stream_function(const VtuGrid& grid, const std::vector<double>& velocity) {
  const std::size_t n = grid.points.size() / 3;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  const auto on_axis = [&](std::size_t i) { return point(grid, i)[0] == 0; };
  const auto add = [&](std::size_t i, std::size_t j, double value) {
    if (!on_axis(i) && !on_axis(j)) entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  };
  for (const auto& [a, b] : sides_of(node_triangles(grid))) {
    const double difference = flux(grid, velocity, a, b);
    add(a, a, 1);
    add(b, b, 1);
    add(a, b, -1);
    add(b, a, -1);
    if (!on_axis(a)) right[static_cast<Eigen::Index>(a)] -= difference;
    if (!on_axis(b)) right[static_cast<Eigen::Index>(b)] += difference;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (on_axis(i)) entries.emplace_back(static_cast<int>(i), static_cast<int>(i), 1.0);
  }
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::VectorXd psi = factors.solve(right);
  return {psi.begin(), psi.end()};
}

std::vector<std::vector<PlanePoint>> contour(const VtuGrid& grid,
                                             const std::vector<std::array<std::size_t, 3>>& triangles,
                                             const std::vector<double>& function, double level) {
  // a line enters and leaves a triangle through two of its sides; neighbours share a side
  std::map<Side, std::vector<Side>> next;
  for (const auto& t : triangles) {
    std::vector<Side> crossed;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = t[k];
      const std::size_t b = t[(k + 1) % 3];
      if ((function[a] < level) != (function[b] < level)) crossed.push_back(side(a, b));
    }
    if (crossed.size() != 2) continue;
    next[crossed[0]].push_back(crossed[1]);
    next[crossed[1]].push_back(crossed[0]);
  }
  const auto place = [&](const Side& s) {
    const double share = (level - function[s.first]) / (function[s.second] - function[s.first]);
    const PlanePoint a = point(grid, s.first);
    const PlanePoint b = point(grid, s.second);
    return PlanePoint{std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share)};
  };
  std::vector<std::vector<PlanePoint>> lines;
  const auto follow = [&](Side at) {
    auto& line = lines.emplace_back();
    line.push_back(place(at));
    while (!next[at].empty()) {
      const Side to = next[at].back();
      next[at].pop_back();
      std::erase(next[to], at);
      line.push_back(place(to));
      at = to;
    }
  };
  for (const auto& [start, ways] : next) {
    if (ways.size() == 1) follow(start);  // from the boundary
  }
  for (const auto& [start, ways] : next) {
    if (!ways.empty()) follow(start);  // closed
  }
  return lines;
}

}  // namespace turgor
