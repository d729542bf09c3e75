#include "turgor/fem/elastic_wall.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "spherical_cap.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/membrane/equilibrium.hpp"

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
  const auto& p = c.parameters;
  return {meridian, MembraneWall{.material = p.material,
                                 .thickness = p.thickness,
                                 .density = p.solid_density,
                                 .bending_stiffness = c.wall.bending_stiffness,
                                 .damping_time = c.wall.damping_time,
                                 .rim = c.wall.clamped ? Rim::clamped : Rim::hinged}};
}

/// At rest with the volume of the sphere through the rim that the case starts from.
Eigen::VectorXd start_of(const Membrane& membrane, const Case& c) {
  if (c.stretch == 1) return membrane.reference();
  const double volume = cap_volume(c.stretch * c.parameters.radius, c.parameters.orifice_radius);
  return hold_volume(membrane, slack_state(membrane), volume).places;
}

}  // namespace

ElasticWall::ElasticWall(const FlowSpace& space, const Case& c)
    : space_(space),
      orifice_radius_(c.parameters.orifice_radius),
      radius_(c.parameters.radius),
      nodes_(chain_of(space)),
      membrane_(membrane_of(space, nodes_, c)),
      sphere_(orifice_radius_, radius_),
      extension_(space, nodes_),
      start_(start_of(membrane_, c)) {}

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

/// Of the sphere through the rim with the volume of these places.
double ElasticWall::equivalent_radius(const Eigen::VectorXd& places) const {
  const double volume = 2 * std::numbers::pi * membrane_.volume(places).value;
  if (!(volume > cap_volume(1.001 * orifice_radius_, orifice_radius_))) {
    throw ComputationFailed("the balloon is empty");
  }
  return cap_radius(volume, orifice_radius_, radius_);
}

std::vector<double> ElasticWall::mesh(const Eigen::VectorXd& places) const {
  const double radius = equivalent_radius(places);
  std::vector<double> all(2 * space_.nodes().size());
  for (std::size_t i = 0; i < space_.nodes().size(); ++i) {
    const Point2 x = sphere_.position(space_.nodes()[i], radius);
    all[2 * i] = x[0];
    all[2 * i + 1] = x[1];
  }
  extension_.add(places - of_wall(all), all);
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
