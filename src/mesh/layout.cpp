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

std::string metres(double length) { return shortest(length) + " m"; }

bool positive(double x) { return x > 0 && std::isfinite(x); }

std::vector<Issue> lengths_that_are_none(const MeshRequest& q) {
  std::vector<Issue> issues;
  const auto require = [&](const std::string& key, double value) {
    if (!positive(value)) issues.push_back({key, metres(value), "must be a positive length", "", "", 0});
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
    issues.push_back({"balloon.radius", metres(q.radius), "the orifice is too wide for a mesh of this balloon",
                      "allowed are radii from " + metres(least_radius_ratio * a), "", 0});
  }
  if (q.orifice > a / 3) {
    issues.push_back({"fem.h_orifice", metres(q.orifice), "fewer than three cells from the axis to the rim",
                      "allowed is at most a third of the orifice's radius, " + metres(a / 3) + "; try a fifteenth, " +
                          metres(a / 15),
                      "", 0});
  }
  if (q.rim > q.orifice) {
    issues.push_back({"fem.h_rim", metres(q.rim), "larger than fem.h_orifice = " + metres(q.orifice),
                      "cells are smallest at the rim; try " + metres(q.orifice / 4), "", 0});
  }
  if (q.wall < q.orifice) {
    issues.push_back({"fem.h_wall", metres(q.wall), "smaller than fem.h_orifice = " + metres(q.orifice),
                      "cells grow from the orifice to the wall; try " + metres(4 * q.orifice), "", 0});
  }
  if (q.wall > q.radius / 4) {
    issues.push_back({"fem.h_wall", metres(q.wall), "too large to follow the wall",
                      "allowed is at most a quarter of the radius, " + metres(q.radius / 4), "", 0});
  }
  return issues;
}

/// An upper estimate of the number of cells, before any is made.
double estimated_cells(const MeshLayout& l) {
  const MeshRequest& q = l.request;
  const double a = q.orifice_radius;
  const double rays = a / l.orifice * (1 + std::log(l.orifice / q.rim));
  const double rings = 4 * q.radius / q.wall + 2 * a / l.orifice * std::log1p(q.radius / a);
  const double rows = q.channel_length / std::min(channel_aspect * q.rim, 4 * l.orifice) + 3 * a / q.rim;
  return static_cast<double>(l.ring()) * rings + rays * (static_cast<double>(l.sectors() + l.inner_sectors) + rows);
}

std::size_t rounded_up_to_one(double x) { return static_cast<std::size_t>(std::max(1.0, std::round(x))); }

/// Chooses the least number of sectors, from the one that the orifice's size asks for, with which not many more columns
/// than it asks for make rings that are fine enough at the balloon's middle.
void choose_counts(MeshLayout& l) {
  const MeshRequest& q = l.request;
  const double asked_columns = (q.orifice_radius - l.fan_radius) / q.orifice;
  const double asked_core = l.wedge * l.fan_radius / q.orifice / (2.0 * rim_blocks);
  const double ring = widest_column * q.radius / (2 * q.wall);
  constexpr double spare = 1.4;
  constexpr double growth = 1.02;
  for (double finer = 1;; finer *= growth) {
    l.core = rounded_up_to_one(finer * asked_core);
    const std::size_t sectors = 2 * rim_blocks * l.core;
    l.inner_sectors = rounded_up_to_one(inner_share * static_cast<double>(sectors));
    l.outer_sectors = sectors - l.inner_sectors;
    const double missing = std::ceil(ring) - static_cast<double>(l.outer_sectors);
    l.columns = rounded_up_to_one(std::max(missing, finer * asked_columns));
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
  MeshLayout l{};
  l.request = request;
  const double a = request.orifice_radius;
  const double R = request.radius;
  l.centre = std::sqrt((R - a) * (R + a));
  l.wedge = std::numbers::pi - std::asin(a / R);
  l.fan_radius = fan_share * a;
  if (a / request.rim > most_cells || R / request.wall > most_cells || a / request.orifice > most_cells) {
    throw InvalidInput("fem.h_rim", metres(request.rim), "the mesh would have far too many cells",
                       "try a sixtieth of the orifice's radius, " + metres(a / 60));
  }
  choose_counts(l);
  l.core_radius = std::min(static_cast<double>(l.core) * request.rim, l.fan_radius / 2);
  const double cells = estimated_cells(l);
  if (cells > most_cells) {
    throw InvalidInput("fem.h_orifice", metres(request.orifice),
                       "the mesh would have about " + rounded(cells, 2) + " cells; at most " + rounded(most_cells) +
                           " are made",
                       "try larger fem.h_orifice, fem.h_rim or fem.h_wall");
  }
  return l;
}

}  // namespace turgor
