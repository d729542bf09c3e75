#include "tube_wall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/cylinder.hpp"

namespace turgor {

namespace {

constexpr double rounding = 1e-9;

}  // namespace

BalloonMesh tube_mesh(const Tube& tube, std::size_t columns, std::size_t rows, Side below, bool graded) {
  BalloonMesh mesh =
      cylinder({.columns = columns, .rows = rows, .radius = tube.radius, .length = tube.length, .below = below});
  if (!graded) return mesh;
  for (auto& [r, z] : mesh.points) r = tube.radius * std::sin(std::numbers::pi / 2 * r / tube.radius);
  return mesh;
}

bool TubeWall::on_ring(int node) const { return place(node)[0] > (1 - rounding) * tube_.radius; }

TubeWall::TubeWall(const FlowSpace& space, const Tube& tube)
    : space_(space), tube_(tube), nodes_(space.nodes_on(Side::wall)) {
  std::ranges::sort(nodes_, std::ranges::less{}, [&](int node) {
    const auto [r, z] = place(node);
    return z < tube.length / 2 ? r + z : 2 * tube.radius + z - r;
  });
  const auto size = static_cast<Eigen::Index>(2 * nodes_.size());
  rest_.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    rest_[i] = place(nodes_[static_cast<std::size_t>(i / 2)])[static_cast<std::size_t>(i % 2)];
  }
  for (auto* matrix : {&mass_, &stiffness_, &hold_}) matrix->resize(size, size);
  integrate_rings();
  hold_lengthways();
}

void TubeWall::integrate_rings() {
  std::vector<Eigen::Triplet<double>> mass;
  std::vector<Eigen::Triplet<double>> stiffness;
  for (const auto& edge : space_.edges()) {
    if (edge.side != Side::wall || !std::ranges::all_of(edge.nodes, [&](int node) { return on_ring(node); })) continue;
    std::array<int, 3> unknown{};
    for (std::size_t i = 0; i < 3; ++i) {
      unknown[i] = 2 * static_cast<int>(std::ranges::find(nodes_, edge.nodes[i]) - nodes_.begin());
    }
    const double length = std::abs(place(edge.nodes[1])[1] - place(edge.nodes[0])[1]);
    for (const EdgeValues& q : space_.element().edge_points()) {
      const double w = q.weight * tube_.radius * length;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const double both = w * q.value[i] * q.value[j];
          const double slopes = w * q.derivative[i] * q.derivative[j] / (length * length);
          mass.emplace_back(unknown[i], unknown[j], tube_.mass * both);
          stiffness.emplace_back(unknown[i], unknown[j], tube_.stiffness * both + tube_.tension * slopes);
        }
      }
    }
  }
  mass_.setFromTriplets(mass.begin(), mass.end());
  stiffness_.setFromTriplets(stiffness.begin(), stiffness.end());
}

void TubeWall::hold_lengthways() {
  constexpr double firmly = 1e6;  // [N s/m/rad]; the liquid's inertia, rho R^2 L omega, is about 1
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double z = place(nodes_[i])[1];
    const double from_end = std::min(z, tube_.length - z) / tube_.length;
    const int axial = 2 * static_cast<int>(i) + 1;
    if (tube_.viscosity > 0 || from_end < rounding) entries.emplace_back(axial, axial, firmly);
  }
  hold_.setFromTriplets(entries.begin(), entries.end());
}

std::vector<double> TubeWall::start() const {
  std::vector<double> all;
  for (const Point2& X : space_.nodes()) all.insert(all.end(), X.begin(), X.end());
  return all;
}

FlexibleWall::Resistance TubeWall::resistance(const Motion& motion) const {
  return {mass_ * motion.acceleration + stiffness_ * (motion.places - rest_) + hold_ * motion.velocity,
          motion.acceleration_per_velocity * mass_ + motion.place_per_velocity * stiffness_ + hold_};
}

std::vector<double> TubeWall::mesh(const Eigen::VectorXd& places) const {
  std::vector<std::array<double, 2>> rings;  // height, displacement
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto radial = static_cast<Eigen::Index>(2 * i);
    if (on_ring(nodes_[i])) rings.push_back({place(nodes_[i])[1], places[radial] - rest_[radial]});
  }
  const double spacing = tube_.length / static_cast<double>(rings.size() - 1);
  std::vector<double> all =
      followed([&](double z) { return rings[static_cast<std::size_t>(std::lround(z / spacing))][1]; });
  const std::vector<double> rest = start();
  for (std::size_t i = 0; i < all.size(); ++i) all[i] += rest[i];
  return all;
}

std::vector<double> TubeWall::displacements(const FlowSolver& solver) const {
  std::vector<double> list;
  for (const int node : nodes_) {
    if (on_ring(node)) list.push_back(solver.positions()[2 * static_cast<std::size_t>(node)] - tube_.radius);
  }
  return list;
}

double TubeWall::energy(const FlowSolver& solver) const {
  Eigen::VectorXd displacement(rest_.size());
  Eigen::VectorXd velocity(rest_.size());
  for (Eigen::Index i = 0; i < rest_.size(); ++i) {
    const auto at =
        2 * static_cast<std::size_t>(nodes_[static_cast<std::size_t>(i / 2)]) + static_cast<std::size_t>(i % 2);
    displacement[i] = solver.positions()[at] - rest_[i];
    velocity[i] = solver.solution()[at];
  }
  return std::numbers::pi * (velocity.dot(mass_ * velocity) + displacement.dot(stiffness_ * displacement));
}

}  // namespace turgor
