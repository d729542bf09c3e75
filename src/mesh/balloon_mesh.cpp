#include "turgor/mesh/balloon_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "block_builder.hpp"
#include "layout.hpp"
#include "ring_map.hpp"
#include "spacing.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

Line part(const Line& line, std::size_t first, std::size_t last) {
  return {line.begin() + static_cast<std::ptrdiff_t>(first), line.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

Line reversed(Line line) {
  std::ranges::reverse(line);
  return line;
}

/// Joins a line that ends where the next one begins.
Line joined(Line line, const Line& next) {
  line.insert(line.end(), next.begin() + 1, next.end());
  return line;
}

/// Builds the blocks from the rim outwards.
class BalloonMesher {
 public:
  explicit BalloonMesher(const MeshRequest& request) : layout_(mesh_layout(request)) {}

  [[nodiscard]] BalloonMesh mesh() {
    build_core();
    build_fan();
    build_orifice_block();
    build_rings();
    build_pole();
    if (layout_.request.channel_length > 0) build_channel();
    return finish();
  }

 private:
  void build_core();
  void build_fan();
  void build_orifice_block();
  void build_rings();
  void build_pole();
  void build_channel();
  [[nodiscard]] BalloonMesh finish() const;
  [[nodiscard]] Side side(const std::array<std::size_t, 2>& edge) const;

  [[nodiscard]] Place about_rim(double distance, double share) const;
  [[nodiscard]] std::vector<double> ring_levels(const RingMap& rings) const;
  Line line_between(std::size_t from, std::size_t to, std::size_t cells);

  MeshLayout layout_;
  BlockBuilder builder_;
  Line fan_;      ///< from the orifice to the wall
  Line orifice_;  ///< from the axis to the rim
  Line first_ring_;
  Line last_ring_;
};

/// A place at this distance from the rim; the share goes from 0 on the orifice to 1 on the wall.
Place BalloonMesher::about_rim(double distance, double share) const {
  const double a = layout_.request.orifice_radius;
  const double opening = layout_.wedge - std::asin(distance / (2 * layout_.request.radius));
  if (share == 0) return {a - distance, 0};
  return a - std::polar(distance, -opening * share);
}

Line BalloonMesher::line_between(std::size_t from, std::size_t to, std::size_t cells) {
  Line line{from};
  for (std::size_t i = 1; i < cells; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(cells);
    line.push_back(builder_.add((1 - t) * builder_.place(from) + t * builder_.place(to)));
  }
  line.push_back(to);
  return line;
}

void BalloonMesher::build_core() {
  const std::size_t m = layout_.core;
  const auto sectors = static_cast<double>(layout_.sectors());
  const double opening = layout_.wedge / static_cast<double>(rim_blocks);
  for (std::size_t j = 0; j <= layout_.sectors(); ++j) {
    const double turn = layout_.wedge * static_cast<double>(j % (2 * m)) / sectors;
    fan_.push_back(
        builder_.add(about_rim(layout_.core_radius * core_outline(turn, opening), static_cast<double>(j) / sectors)));
  }
  const std::size_t rim = builder_.add(layout_.request.orifice_radius);
  std::vector<Line> spokes;
  for (std::size_t b = 0; b <= rim_blocks; ++b) {
    const double share = static_cast<double>(b) / static_cast<double>(rim_blocks);
    Line spoke{rim};
    for (std::size_t i = 1; i < m; ++i) {
      const double distance = layout_.core_radius * static_cast<double>(i) / static_cast<double>(m);
      spoke.push_back(builder_.add(about_rim(distance, share)));
    }
    spoke.push_back(fan_[2 * m * b]);
    spokes.push_back(spoke);
  }
  for (std::size_t b = 0; b < rim_blocks; ++b) {
    const Line north = part(fan_, 2 * m * b, 2 * m * b + m);
    const Line east = reversed(part(fan_, 2 * m * b + m, 2 * m * (b + 1)));
    builder_.fill(spokes[b + 1], east, north, spokes[b]);
  }
  orifice_ = reversed(spokes[0]);
}

void BalloonMesher::build_fan() {
  const double from = layout_.core_radius;
  const double to = layout_.fan_radius;
  const auto size = [&](double distance) {
    return std::lerp(layout_.request.rim, layout_.orifice, (distance - from) / (to - from));
  };
  const std::vector<double> distances = spaced(from, to, steps(from, to, size), size);
  const Line outline = fan_;
  for (std::size_t k = 1; k < distances.size(); ++k) {
    const double share = (distances[k] - from) / (to - from);
    Line next;
    for (std::size_t j = 0; j < outline.size(); ++j) {
      const double start = std::abs(builder_.place_on(outline, j) - layout_.request.orifice_radius);
      next.push_back(builder_.add(
          about_rim(std::lerp(start, to, share), static_cast<double>(j) / static_cast<double>(outline.size() - 1))));
    }
    builder_.strip(fan_, next);
    fan_ = next;
    orifice_.insert(orifice_.begin(), fan_.front());
  }
}

/// From the orifice to the axis. Its upper side leaves the fan at 60 degrees and meets the axis at 90.
void BalloonMesher::build_orifice_block() {
  const std::size_t corner = fan_[layout_.inner_sectors];
  const Place S = builder_.place(corner);
  const double share = static_cast<double>(layout_.inner_sectors) / static_cast<double>(layout_.sectors());
  const double direction = std::clamp(pi - share * layout_.wedge + pi / 6, 2 * pi / 3, 5 * pi / 6);
  const double height = S.imag() - 0.45 * S.real() * std::tan(direction);
  const std::size_t origin = builder_.add(0);
  const Line south = line_between(origin, fan_.front(), layout_.columns);

  Line west{origin};
  const auto size = [&](double z) { return layout_.orifice * (1 + z / height / 2); };
  for (const double z : spaced(0, height, layout_.inner_sectors, size)) {
    if (z > 0) west.push_back(builder_.add({0, z}));
  }
  Line north{west.back()};
  const Place start = builder_.place(west.back());
  const double speed = std::abs(S - start);
  for (std::size_t i = 1; i < layout_.columns; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(layout_.columns);
    const double weight = t * t * (3 - 2 * t);
    north.push_back(builder_.add(start * (1 - weight) + S * weight + speed * t * (1 - t) * (1 - t) +
                                 std::polar(speed, direction) * t * t * (1 - t)));
  }
  north.push_back(corner);
  builder_.fill(south, part(fan_, 0, layout_.inner_sectors), north, west);
  orifice_ = joined(south, orifice_);
  first_ring_ = joined(north, part(fan_, layout_.inner_sectors, layout_.sectors()));
}

/// Levels of the rings, so that neither their steps on the axis nor those on the wall are too large.
std::vector<double> BalloonMesher::ring_levels(const RingMap& rings) const {
  const MeshRequest& q = layout_.request;
  const auto size = [&](const Place& place) {
    constexpr double start = 1.4;
    constexpr double growth = 0.9;
    constexpr double most = 1.25;  // over the wall's size: leaves room for the bulk, where there are no more columns
    return std::min(most * q.wall, layout_.orifice * (start + growth * (std::abs(place) / q.orifice_radius - 1)));
  };
  const auto level_step = [&](double level) {
    constexpr double shift = 1e-4;
    double step = 1;
    for (const std::size_t column : {std::size_t{0}, layout_.ring()}) {
      const Place before = rings.place(level - shift, column);
      const Place after = rings.place(level + shift, column);
      step = std::min(step, size((before + after) / 2.0) * 2 * shift / std::abs(after - before));
    }
    return step;
  };
  return spaced(rings.bottom(), rings.top(), steps(rings.bottom(), rings.top(), level_step), level_step);
}

void BalloonMesher::build_rings() {
  std::vector<Place> places;
  for (const std::size_t point : first_ring_) places.push_back(builder_.place(point));
  const RingMap rings(layout_, places);
  last_ring_ = first_ring_;
  for (const double level : ring_levels(rings)) {
    if (level == rings.bottom()) continue;
    Line next;
    for (std::size_t j = 0; j <= layout_.ring(); ++j) next.push_back(builder_.add(rings.place(level, j)));
    builder_.strip(last_ring_, next);
    last_ring_ = next;
  }
}

void BalloonMesher::build_pole() {
  const std::size_t m = layout_.ring() / 2;
  const double R = layout_.request.radius;
  const std::size_t pole = builder_.add({0, layout_.centre + R});
  const Line axis = line_between(last_ring_.front(), pole, m);
  const Place end = builder_.place(last_ring_.back()) - Place{0, layout_.centre};
  const double angle = std::atan2(end.real(), end.imag());
  Line wall{pole};
  for (std::size_t i = 1; i < m; ++i) {
    const double theta = angle * static_cast<double>(i) / static_cast<double>(m);
    wall.push_back(builder_.add({R * std::sin(theta), layout_.centre + R * std::cos(theta)}));
  }
  wall.push_back(last_ring_.back());
  builder_.fill(part(last_ring_, 0, m), part(last_ring_, m, 2 * m), wall, axis);
}

/// Columns from the orifice straight down, so that they are graded to the channel's wall.
void BalloonMesher::build_channel() {
  const MeshRequest& q = layout_.request;
  const auto size = [&](double depth) {
    return std::min({q.rim * (1 + channel_aspect * depth / q.orifice_radius), channel_aspect * q.rim,
                     channel_step * layout_.orifice});
  };
  Line above = orifice_;
  for (const double depth : spaced(0, q.channel_length, steps(0, q.channel_length, size), size)) {
    if (depth == 0) continue;
    Line row;
    for (const std::size_t point : orifice_) row.push_back(builder_.add(builder_.place(point) - Place{0, depth}));
    builder_.strip(row, above);
    above = row;
  }
}

/// Coordinates on the straight sides are exact, so that equality tells them apart.
Side BalloonMesher::side(const std::array<std::size_t, 2>& edge) const {
  const MeshRequest& q = layout_.request;
  const auto both = [&](auto&& on) { return on(builder_.place(edge[0])) && on(builder_.place(edge[1])); };
  if (both([](const Place& x) { return x.real() == 0; })) return Side::axis;
  if (both([&](const Place& x) { return x.imag() == -q.channel_length; })) return Side::inlet;
  if (both([&](const Place& x) { return x.real() == q.orifice_radius && x.imag() <= 0; })) return Side::channel;
  return Side::wall;
}

BalloonMesh BalloonMesher::finish() const {
  BalloonMesh mesh{builder_.points(), builder_.cells(), {}, {}, layout_.centre, layout_.request.radius};
  mesh.wall_edge.assign(mesh.cells.size(), BalloonMesh::no_edge);
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  const auto for_each_edge = [&](auto&& act) {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      for (std::size_t e = 0; e < 4; ++e) {
        const std::size_t from = mesh.cells[c][e];
        const std::size_t to = mesh.cells[c][(e + 1) % 4];
        act(c, e, std::array{from, to}, std::minmax(from, to));
      }
    }
  };
  for_each_edge([&](auto, auto, const auto&, const auto& key) { ++uses[key]; });
  for_each_edge([&](std::size_t cell, std::size_t e, const auto& edge, const auto& key) {
    if (uses[key] > 1) return;
    mesh.boundary.push_back({edge, side(edge)});
    if (mesh.boundary.back().side == Side::wall) mesh.wall_edge[cell] = static_cast<int>(e);
  });
  return mesh;
}

}  // namespace

std::array<double, 2> BalloonMesh::at(std::size_t cell, double xi, double eta) const {
  const auto& corners = cells[cell];
  const std::array<double, 4> weights{(1 - xi) * (1 - eta), xi * (1 - eta), xi * eta, (1 - xi) * eta};
  Place place = 0;
  const auto corner = [&](std::size_t i) { return Place{points[corners[i % 4]][0], points[corners[i % 4]][1]}; };
  for (std::size_t i = 0; i < 4; ++i) place += weights[i] * corner(i);
  const int edge = wall_edge[cell];
  if (edge != no_edge) {
    const std::array<double, 4> along{xi, eta, 1 - xi, 1 - eta};
    const std::array<double, 4> inside{eta, 1 - xi, 1 - eta, xi};
    const auto e = static_cast<std::size_t>(edge);
    const Place centre{0, sphere_centre};
    const Place from = corner(e) - centre;
    const Place to = corner(e + 1) - centre;
    const double angle = std::arg(to / from);
    const double s = along[e];
    const Place arc = (std::sin((1 - s) * angle) * from + std::sin(s * angle) * to) / std::sin(angle);
    place += (1 - inside[e]) * (arc - (1 - s) * from - s * to);
  }
  return {place.real(), place.imag()};
}

BalloonMesh balloon_mesh(const MeshRequest& request) { return BalloonMesher(request).mesh(); }

}  // namespace turgor
