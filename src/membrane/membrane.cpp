#include "turgor/membrane/membrane.hpp"

#include <string>
#include <utility>

#include "parts.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

using Eigen::Index;
using Eigen::VectorXd;
using PointVector = Eigen::Matrix<double, point_variables, 1>;
using Point = SecondOrder<point_variables>;

namespace {

[[noreturn]] void refuse_nodes(const std::string& problem, const std::string& advice) {
  throw InvalidInput("membrane.nodes", "", problem, advice);
}

void check_nodes(const Meridian& meridian) {
  const auto& nodes = meridian.nodes;
  if (nodes.size() < 3 || nodes.size() % 2 == 0) {
    refuse_nodes("has " + std::to_string(nodes.size()) + " nodes",
                 "a chain of quadratic elements has 3, 5, 7, ... of them");
  }
  if (nodes.front()[0] != 0 && nodes.back()[0] != 0) {
    refuse_nodes("does not reach the axis", "r of its first or last node must be 0");
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& [r, z] = nodes[i];
    const bool end = i == 0 || i + 1 == nodes.size();
    if (!std::isfinite(r) || !std::isfinite(z) || r < 0 || (r == 0 && !end)) {
      refuse_nodes("node " + std::to_string(i) + " is at r = " + shortest(r) + " m, z = " + shortest(z) + " m",
                   "all numbers must be finite, and r positive but for the ends");
    }
  }
}

void check_wall(const MembraneWall& wall) {
  const auto need = [](bool fine, const char* key, double value, const char* unit, const char* allowed) {
    if (!fine || !std::isfinite(value)) throw InvalidInput(key, shortest(value) + unit, allowed);
  };
  need(wall.thickness > 0, "balloon.thickness", wall.thickness, " m", "must be positive");
  need(wall.density > 0, "balloon.density", wall.density, " kg/m^3", "must be positive");
  need(wall.bending_stiffness >= 0, "wall.bending_stiffness", wall.bending_stiffness, " N m", "must not be negative");
  need(wall.damping_time >= 0, "wall.damping_time", wall.damping_time, " s", "must not be negative");
}

/// Twice the signed area between the meridian and the axis, by its nodes: positive with the liquid to the left.
double turning(const Meridian& meridian) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < meridian.nodes.size(); ++i) {
    const auto& a = meridian.nodes[i];
    const auto& b = meridian.nodes[i + 1];
    sum += (a[0] + b[0]) * (b[1] - a[1]);
  }
  return sum;
}

std::string stretches_text(double l1, double l2) {
  return "stretches of " + shortest(l1) + " along and " + shortest(l2) + " around";
}

}  // namespace

void require_regular(const PointVector& q, std::size_t element) {
  const std::string where = "element " + std::to_string(element) + " of the membrane, at r = " + shortest(q(0)) + " m";
  if (!q.allFinite()) throw ComputationFailed(where + ", has places that are not numbers");
  if (!(q(0) > 0)) throw ComputationFailed(where + ", has crossed the axis");
  if (q(1) == 0 && q(2) == 0) throw ComputationFailed(where + ", has no length");
}

BiaxialJet<double> checked_energy(const Material<double>& material, double l1, double l2, double radius) {
  const BiaxialJet<double> w = strain_energy(material, l1, l2);
  if (std::isfinite(w.value)) return w;
  throw ComputationFailed("the membrane's material has locked, or its energy has outgrown every number, at r = " +
                          shortest(radius) + " m: " + stretches_text(l1, l2));
}

void Membrane::Parts::set_points() {
  for (std::size_t g = 0; g < gauss_points.size(); ++g) {
    shapes[g] = line_shape(gauss_points[g].place);
    maps[g] = point_map(shapes[g]);
  }
  const auto count = static_cast<std::size_t>(reference.size() - 2) / 4;
  for (std::size_t e = 0; e < count; ++e) {
    std::array<ReferencePoint, 3> at;
    for (std::size_t g = 0; g < at.size(); ++g) {
      const PointVector q = maps[g] * places_of(reference, e);
      if (!(q(0) > 0) || !(std::hypot(q(1), q(2)) > 0)) {
        refuse_nodes("element " + std::to_string(e) + " crosses the axis or has no length", "move its middle node");
      }
      at[g] = reference_point(q);
    }
    points.push_back(at);
  }
}

void Membrane::Parts::set_joints() {
  const std::size_t last = 2 * elements();
  const auto arc = [&](std::size_t e) {
    double sum = 0;
    for (std::size_t g = 0; g < gauss_points.size(); ++g) sum += gauss_points[g].weight * points[e][g].length;
    return sum;
  };
  for (std::size_t node = 0; node <= last; node += 2) {
    const bool end = node == 0 || node == last;
    const bool on_axis = end && reference(static_cast<Index>(2 * node)) == 0;
    if (on_axis || (end && wall.rim == Rim::hinged)) continue;
    Joint joint{node, {node > 0, node < last}, {}, {}, 0, 0};
    double inverse = 0;
    for (std::size_t s = 0; s < 2; ++s) {
      if (!joint.side[s]) continue;
      const std::size_t element = node / 2 - (s == 0 ? 1 : 0);
      const PointVector q = point_map(line_shape(s == 0 ? 1 : -1)) * places_of(reference, element);
      joint.reference[s] = reference_point(q);
      joint.tangents[s] = {q(1), q(2)};
      if (!joint.side[1 - s]) joint.tangents[1 - s] = {q(1), q(2)};
      inverse += (end ? 1.0 : 0.5) / arc(element);
    }
    joint.size = 1 / inverse;
    const auto& [before, behind] = joint.tangents;
    joint.kink = kink(before[0], before[1], behind[0], behind[1]);
    joints.push_back(joint);
  }
}

void Membrane::Parts::set_free(std::size_t rim_node) {
  for (Index i = 0; i < reference.size(); ++i) {
    const bool on_axis = i % 2 == 0 && reference(i) == 0;
    const bool on_rim = !closed && static_cast<std::size_t>(i / 2) == rim_node;
    if (!on_axis && !on_rim) free.push_back(i);
  }
}

void Membrane::Parts::set_mass() {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < elements(); ++e) {
    Eigen::Matrix<double, element_unknowns, element_unknowns> block;
    block.setZero();
    for (std::size_t g = 0; g < gauss_points.size(); ++g) {
      const ReferencePoint& at = points[e][g];
      const double share = wall.density * wall.thickness * gauss_points[g].weight * at.radius * at.length;
      for (std::size_t i = 0; i < element_nodes; ++i) {
        for (std::size_t j = 0; j < element_nodes; ++j) {
          const double m = share * shapes[g].value[i] * shapes[g].value[j];
          block(static_cast<Index>(2 * i), static_cast<Index>(2 * j)) += m;
          block(static_cast<Index>(2 * i + 1), static_cast<Index>(2 * j + 1)) += m;
        }
      }
    }
    FormSum::add_matrix(entries, static_cast<Index>(4 * e), block);
  }
  mass.resize(reference.size(), reference.size());
  mass.setFromTriplets(entries.begin(), entries.end());
}

Membrane::Membrane(const Meridian& reference, MembraneWall wall) {
  check_nodes(reference);
  check_wall(wall);
  auto parts = std::make_shared<Parts>();
  parts->wall = std::move(wall);
  const auto& nodes = reference.nodes;
  parts->reference.resize(static_cast<Index>(2 * nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    parts->reference(static_cast<Index>(2 * i)) = nodes[i][0];
    parts->reference(static_cast<Index>(2 * i + 1)) = nodes[i][1];
  }
  const std::size_t rim = nodes.front()[0] != 0 ? 0 : nodes.size() - 1;
  parts->rim_radius = nodes[rim][0];
  parts->closed = parts->rim_radius == 0;
  parts->orientation = turning(reference) > 0 ? 1 : -1;
  parts->set_points();
  parts->set_joints();
  parts->set_free(rim);
  parts->set_mass();
  parts_ = std::move(parts);
}

const MembraneWall& Membrane::wall() const { return parts_->wall; }
const VectorXd& Membrane::reference() const { return parts_->reference; }
bool Membrane::closed() const { return parts_->closed; }
double Membrane::rim_radius() const { return parts_->rim_radius; }
const std::vector<Index>& Membrane::free_unknowns() const { return parts_->free; }
const Eigen::SparseMatrix<double>& Membrane::mass() const { return parts_->mass; }

MembraneForm Membrane::elastic(const VectorXd& places) const {
  const MembraneWall& wall = parts_->wall;
  FormSum sum(places.size());
  for (std::size_t e = 0; e < parts_->elements(); ++e) {
    for (std::size_t g = 0; g < gauss_points.size(); ++g) {
      const ReferencePoint& reference = parts_->points[e][g];
      const PointVector q = parts_->maps[g] * places_of(places, e);
      require_regular(q, e);
      const auto x = variables_at(q);
      const Point l1 = (1 / reference.length) * x.length();
      const Point l2 = (1 / reference.radius) * x.r;
      Point density = wall.thickness * chain(checked_energy(wall.material, l1.value, l2.value, q(0)), l1, l2);
      if (wall.bending_stiffness > 0) {
        const auto k = bending_strains(x, reference);
        density = density + (wall.bending_stiffness / 2) * (k[0] * k[0] + k[0] * k[1] + k[1] * k[1]);
      }
      sum.add(static_cast<Index>(4 * e), parts_->maps[g], density,
              gauss_points[g].weight * reference.radius * reference.length);
    }
  }
  if (wall.bending_stiffness > 0) add_joints(wall, parts_->joints, places, sum);
  return sum.finish();
}

MembraneForm Membrane::volume(const VectorXd& places) const {
  FormSum sum(places.size());
  for (std::size_t e = 0; e < parts_->elements(); ++e) {
    for (std::size_t g = 0; g < gauss_points.size(); ++g) {
      const PointVector q = parts_->maps[g] * places_of(places, e);
      const auto x = variables_at(q);
      sum.add(static_cast<Index>(4 * e), parts_->maps[g], x.r * x.r * x.dz,
              gauss_points[g].weight * parts_->orientation / 2);
    }
  }
  return sum.finish();
}

double Membrane::area(const VectorXd& places) const {
  double sum = 0;
  for (std::size_t e = 0; e < parts_->elements(); ++e) {
    for (std::size_t g = 0; g < gauss_points.size(); ++g) {
      const PointVector q = parts_->maps[g] * places_of(places, e);
      sum += gauss_points[g].weight * q(0) * std::hypot(q(1), q(2));
    }
  }
  return sum;
}

}  // namespace turgor
