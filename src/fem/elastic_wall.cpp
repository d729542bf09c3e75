#include "turgor/fem/elastic_wall.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "spherical_cap.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/membrane/equilibrium.hpp"
#include "turgor/run/membrane_study.hpp"

namespace turgor {

namespace {

/// Nodes on the wall from the rim to the axis.
std::vector<int> chain_of(const FlowSpace& space) {
  std::map<int, std::array<int, 2>> next;  // along the boundary, liquid to the left: from the rim to the axis
  int rim = -1;
  for (const auto& edge : space.edges()) {
    if (edge.side != Side::wall) continue;
    next[edge.nodes[0]] = {edge.nodes[2], edge.nodes[1]};
    if (space.nodes()[static_cast<std::size_t>(edge.nodes[0])][1] == 0) rim = edge.nodes[0];
  }
  std::vector<int> chain{rim};
  while (next.contains(chain.back())) {
    const auto step = next[chain.back()];
    chain.insert(chain.end(), step.begin(), step.end());
  }
  return chain;
}

Membrane membrane_of(const FlowSpace& space, const std::vector<int>& chain, const Case& c) {
  Meridian meridian;
  for (const int node : chain) meridian.nodes.push_back(space.nodes()[static_cast<std::size_t>(node)]);
  return {meridian, wall_of(c)};
}

/// At rest with the volume of the sphere through the rim that the case starts from.
Eigen::VectorXd start_of(const Membrane& membrane, const Case& c) {
  if (c.stretch == 1) return membrane.reference();
  const double volume = cap_volume(c.stretch * c.parameters.radius, c.parameters.orifice_radius);
  return hold_volume(membrane, slack_state(membrane), volume).places;
}

std::vector<ToroidalCoordinates> coordinates_of(const FlowSpace& space, const std::vector<int>& nodes, double a) {
  std::vector<ToroidalCoordinates> all;
  all.reserve(nodes.size());
  for (const int node : nodes) all.push_back(toroidal_coordinates(space.nodes()[static_cast<std::size_t>(node)], a));
  return all;
}

}  // namespace

ElasticWall::ElasticWall(const FlowSpace& space, const Case& c)
    : space_(space),
      orifice_radius_(c.parameters.orifice_radius),
      nodes_(chain_of(space)),
      membrane_(membrane_of(space, nodes_, c)),
      reference_(coordinates_of(space, nodes_, orifice_radius_)),
      followers_(followers()),
      start_(start_of(membrane_, c)) {}

/// All nodes above the orifice's plane but the wall's. Between the rim, where tau is infinite, and the wall's next
/// node, they follow that one.
std::vector<ElasticWall::Follower> ElasticWall::followers() const {
  const std::set<int> wall(nodes_.begin(), nodes_.end());
  std::vector<Follower> all;
  for (std::size_t i = 0; i < space_.nodes().size(); ++i) {
    const Point2& X = space_.nodes()[i];
    if (X[1] <= 0 || wall.contains(static_cast<int>(i))) continue;
    const ToroidalCoordinates at = toroidal_coordinates(X, orifice_radius_);
    const auto after = std::find_if(reference_.begin() + 2, reference_.end() - 1,
                                    [&](const ToroidalCoordinates& on_wall) { return on_wall.tau <= at.tau; });
    const auto behind = static_cast<std::size_t>(after - reference_.begin()) - 1;
    const double from = reference_[behind].tau;
    const double weight = std::clamp((from - at.tau) / (from - reference_[behind + 1].tau), 0.0, 1.0);
    all.push_back(
        {i, at, at.rest / std::lerp(reference_[behind].rest, reference_[behind + 1].rest, weight), behind, weight});
  }
  return all;
}

FlexibleWall::Resistance ElasticWall::resistance(const Motion& motion) const {
  const MembraneForm elastic = membrane_.elastic(motion.places);
  Resistance wall;
  wall.force = membrane_.mass() * motion.acceleration + elastic.gradient;
  wall.tangent = motion.acceleration_per_velocity * membrane_.mass() + motion.place_per_velocity * elastic.hessian;
  if (membrane_.wall().damping_time > 0) {
    const MembraneDamping damping = membrane_.damping(motion.places, motion.velocity);
    wall.force += damping.force;
    wall.tangent += damping.by_velocity + motion.place_per_velocity * damping.by_place;
  }
  return wall;
}

std::vector<double> ElasticWall::mesh(const Eigen::VectorXd& places) const {
  std::vector<double> all(2 * space_.nodes().size());
  for (std::size_t i = 0; i < space_.nodes().size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) all[2 * i + c] = space_.nodes()[i][c];
  }
  struct Change {
    double tau;    // added
    double angle;  // factor of pi - sigma
  };
  std::vector<Change> changes(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(2 * k);
    const Point2 x{places[at], places[at + 1]};
    for (std::size_t c = 0; c < 2; ++c) all[2 * static_cast<std::size_t>(nodes_[k]) + c] = x[c];
    if (k == 0) continue;  // the rim has no angle
    const ToroidalCoordinates now = toroidal_coordinates(x, orifice_radius_);
    if (!(now.rest > 0)) throw ComputationFailed("the wall has come down to the orifice");
    changes[k] = {now.tau - reference_[k].tau, now.rest / reference_[k].rest};
  }
  for (const Follower& follower : followers_) {
    const Change& one = changes[follower.behind];
    const Change& other = changes[follower.behind + 1];
    const double tau = follower.reference.tau + follower.share * std::lerp(one.tau, other.tau, follower.weight);
    const double rest = follower.reference.rest * std::lerp(one.angle, other.angle, follower.weight);
    const Point2 x = toroidal_place({tau, std::numbers::pi - rest, rest}, orifice_radius_);
    for (std::size_t c = 0; c < 2; ++c) all[2 * follower.node + c] = x[c];
  }
  return all;
}

Eigen::VectorXd ElasticWall::of_wall(const std::vector<double>& all) const {
  Eigen::VectorXd part(static_cast<Eigen::Index>(2 * nodes_.size()));
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    for (std::size_t c = 0; c < 2; ++c) {
      part[static_cast<Eigen::Index>(2 * k + c)] = all[2 * static_cast<std::size_t>(nodes_[k]) + c];
    }
  }
  return part;
}

}  // namespace turgor
