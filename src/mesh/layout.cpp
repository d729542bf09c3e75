#include "layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "ring_map.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

/// Over the orifice's radius.
constexpr double fan_share = 0.55;
/// Of the fan's sectors; those between the orifice and the block that reaches the axis.
constexpr double inner_share = 0.42;

std::string exactly(double length) { return shortest(length) + " m"; }
std::string metres(double length) { return rounded(length) + " m"; }

bool positive(double x) { return x > 0 && std::isfinite(x); }

std::vector<Issue> lengths_that_are_none(const MeshRequest& q) {
  std::vector<Issue> issues;
  const auto require = [&](const std::string& key, double value) {
    if (!positive(value)) issues.push_back({key, exactly(value), "must be a positive length", "", "", 0});
  };
  require("inlet.orifice_radius", q.orifice_radius);
  require("balloon.radius", q.radius);
  require("fem.h_rim", q.rim);
  require("fem.h_orifice", q.orifice);
  require("fem.h_wall", q.wall);
  if (q.channel_length != 0) require("inlet.channel_length", q.channel_length);
  return issues;
}

std::vector<Issue> sizes_out_of_order(const MeshRequest& q) {
  std::vector<Issue> issues;
  const double a = q.orifice_radius;
  if (q.radius < least_radius_ratio * a) {
    issues.push_back({"balloon.radius", exactly(q.radius), "the orifice is too wide for a mesh of this balloon",
                      "allowed are radii from " + metres(least_radius_ratio * a), "", 0});
  }
  if (q.radius > greatest_radius_ratio * a) {
    issues.push_back({"inlet.orifice_radius", exactly(a),
                      "too small for a mesh of a balloon of radius " + metres(q.radius),
                      "allowed are orifices from " + metres(q.radius / greatest_radius_ratio), "", 0});
  }
  if (q.orifice > a / 3) {
    issues.push_back({"fem.h_orifice", exactly(q.orifice), "fewer than three cells from the axis to the rim",
                      "allowed is at most a third of the orifice's radius, " + metres(a / 3) + "; try a fifteenth, " +
                          metres(a / 15),
                      "", 0});
  }
  if (q.rim > q.orifice) {
    issues.push_back({"fem.h_rim", exactly(q.rim), "larger than fem.h_orifice = " + metres(q.orifice),
                      "cells are smallest at the rim; try " + metres(q.orifice / 4), "", 0});
  }
  if (q.wall < q.orifice) {
    issues.push_back({"fem.h_wall", exactly(q.wall), "smaller than fem.h_orifice = " + metres(q.orifice),
                      "cells grow from the orifice to the wall; try " + metres(4 * q.orifice), "", 0});
  }
  if (q.wall > q.radius / 4) {
    issues.push_back({"fem.h_wall", exactly(q.wall), "too large to follow the wall",
                      "allowed is at most a quarter of the radius, " + metres(q.radius / 4), "", 0});
  }
  return issues;
}

/// Cells of a ring that this size over the orifice brings with it, and those that the size of the wall asks for.
double ring_for_orifice(const MeshRequest& q) { return 1.4 * q.orifice_radius / q.orifice; }
double ring_for_wall(const MeshRequest& q) { return widest_column * q.radius / (2 * q.wall); }

/// Stops a request for too many cells before any is made. The estimate is within a factor of two.
void check_count(const MeshRequest& q) {
  const double a = q.orifice_radius;
  const double ring = std::max(ring_for_orifice(q), ring_for_wall(q));
  const double orifice = 1.4 * a / ring;
  const double rim = std::min(q.rim, 0.99 * orifice);
  const double rays = 0.45 * a / orifice + fan_share * a * std::log(orifice / rim) / (orifice - rim);
  const double rings = 2.5 * q.radius / q.wall + a / orifice * std::log(q.radius / a);
  const double rows = q.channel_length / std::min(channel_aspect * q.rim, channel_step * orifice);
  const double balloon = ring * rings + 1.6 * a / orifice * rays;
  const double cells = balloon + rays * rows;
  if (cells <= most_cells) return;
  std::string key = "fem.h_orifice";
  double size = q.orifice;
  if (ring_for_wall(q) > ring_for_orifice(q)) {
    key = "fem.h_wall";
    size = q.wall;
  }
  if (rays * rows > balloon) {
    key = "fem.h_rim";
    size = q.rim;
  }
  throw InvalidInput(
      key, exactly(size),
      "the mesh would have about " + rounded(cells, 2) + " cells; at most " + rounded(most_cells) + " are made",
      "try larger sizes; usual are fem.h_rim = " + metres(a / 60) + ", fem.h_orifice = " + metres(a / 15) +
          ", fem.h_wall = " + metres(q.radius / 40));
}

std::size_t at_least_one(double x) { return static_cast<std::size_t>(std::max(1.0, std::round(x))); }

/// Chooses the least number of sectors, from the one that the orifice's size asks for, with which not many more columns
/// than it asks for make rings that are fine enough at the balloon's middle.
void choose_counts(MeshLayout& l) {
  const MeshRequest& q = l.request;
  const double asked_columns = (q.orifice_radius - l.fan_radius) / q.orifice;
  const double asked_core = l.wedge * l.fan_radius / q.orifice / (2.0 * rim_blocks);
  const double ring = ring_for_wall(q);
  constexpr double spare = 1.4;
  constexpr double growth = 1.02;
  for (int attempt = 0;; ++attempt) {
    const double finer = std::pow(growth, attempt);
    l.core = at_least_one(finer * asked_core);
    const std::size_t sectors = 2 * rim_blocks * l.core;
    l.inner_sectors = at_least_one(inner_share * static_cast<double>(sectors));
    l.outer_sectors = sectors - l.inner_sectors;
    const double missing = std::ceil(ring) - static_cast<double>(l.outer_sectors);
    l.columns = at_least_one(std::max(missing, finer * asked_columns));
    l.columns += l.ring() % 2;
    l.orifice = q.orifice / finer;
    if (static_cast<double>(l.columns) <= spare * finer * asked_columns + 1) return;
  }
}

}  // namespace

MeshLayout mesh_layout(const MeshRequest& request) {
  for (auto* check : {lengths_that_are_none, sizes_out_of_order}) {
    std::vector<Issue> issues = check(request);
    if (!issues.empty()) throw InvalidInput(std::move(issues));
  }
  check_count(request);
  MeshLayout l{};
  l.request = request;
  const double a = request.orifice_radius;
  const double R = request.radius;
  l.centre = std::sqrt(R - a) * std::sqrt(R + a);  // no overflow
  l.wedge = std::numbers::pi - std::asin(a / R);
  l.fan_radius = fan_share * a;
  choose_counts(l);
  l.core_radius = std::min(static_cast<double>(l.core) * request.rim, l.fan_radius / 2);
  return l;
}

}  // namespace turgor
