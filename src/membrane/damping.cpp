#include <complex>

#include "parts.hpp"

namespace turgor {

namespace {

using Eigen::Index;
using PointVector = Eigen::Matrix<double, point_variables, 1>;
using Row = Eigen::Matrix<double, 1, element_unknowns>;
using Block = Eigen::Matrix<double, element_unknowns, element_unknowns>;

/// A principal stretch at a point of an element, as a function of the element's places.
struct StretchAt {
  double value;
  double rate;      ///< [1/s]
  Row gradient;     ///< by places, and so the rate's by velocities
  Row rate_change;  ///< the rate's gradient by places
  Block curvature;  ///< Hessian by places
};

std::array<StretchAt, 2> stretches_at(const PointMap& map, const ReferencePoint& reference, const PointVector& q,
                                      const PointVector& velocity) {
  const auto x = variables_at(q);
  const std::array<SecondOrder<point_variables>, 2> l{(1 / reference.length) * x.length(),
                                                      (1 / reference.radius) * x.r};
  std::array<StretchAt, 2> out;
  for (std::size_t i = 0; i < 2; ++i) {
    out[i] = {l[i].value, l[i].gradient.dot(velocity), l[i].gradient.transpose() * map,
              (l[i].hessian * velocity).transpose() * map, map.transpose() * l[i].hessian * map};
  }
  return out;
}

/// Rates of the principal nominal stresses, W_ij dl_j/dt [Pa/s], with their derivatives by the stretches and by their
/// rates.
struct StressRate {
  Eigen::Vector2d value;
  Eigen::Matrix2d by_stretch;
  Eigen::Matrix2d by_rate;
};

/// Third derivatives of the energy by the complex step, which is exact to rounding.
StressRate stress_rate(const Material<double>& material, const std::array<StretchAt, 2>& l, double radius) {
  using Complex = std::complex<double>;
  constexpr double h = 1e-40;
  const BiaxialJet<double> w = checked_energy(material, l[0].value, l[1].value, radius);
  const Eigen::Vector2d rate(l[0].rate, l[1].rate);
  StressRate s;
  s.by_rate << w.d11, w.d12, w.d12, w.d22;
  s.value = s.by_rate * rate;
  for (int k = 0; k < 2; ++k) {
    const auto shifted =
        strain_energy(material, Complex(l[0].value, k == 0 ? h : 0), Complex(l[1].value, k == 1 ? h : 0));
    Eigen::Matrix2d third;
    third << shifted.d11.imag(), shifted.d12.imag(), shifted.d12.imag(), shifted.d22.imag();
    s.by_stretch.col(k) = third * rate / h;
  }
  return s;
}

/// Viscous force of a point per weight, and its derivatives.
struct PointDamping {
  Eigen::Matrix<double, element_unknowns, 1> force = Eigen::Matrix<double, element_unknowns, 1>::Zero();
  Block by_velocity = Block::Zero();
  Block by_place = Block::Zero();
};

PointDamping point_damping(const std::array<StretchAt, 2>& l, const StressRate& s) {
  PointDamping out;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto row = static_cast<Index>(i);
    out.force += s.value(row) * l[i].gradient.transpose();
    out.by_place += s.value(row) * l[i].curvature;
    for (std::size_t j = 0; j < 2; ++j) {
      const auto column = static_cast<Index>(j);
      out.by_velocity += s.by_rate(row, column) * l[i].gradient.transpose() * l[j].gradient;
      out.by_place += l[i].gradient.transpose() *
                      (s.by_stretch(row, column) * l[j].gradient + s.by_rate(row, column) * l[j].rate_change);
    }
  }
  return out;
}

}  // namespace

MembraneDamping Membrane::damping(const Eigen::VectorXd& places, const Eigen::VectorXd& velocity) const {
  const Index n = places.size();
  const MembraneWall& wall = parts_->wall;
  MembraneDamping out{Eigen::VectorXd::Zero(n), {n, n}, {n, n}};
  if (wall.damping_time == 0) return out;
  std::vector<Eigen::Triplet<double>> by_velocity;
  std::vector<Eigen::Triplet<double>> by_place;
  for (std::size_t e = 0; e < parts_->elements(); ++e) {
    const auto first = static_cast<Index>(4 * e);
    for (std::size_t g = 0; g < gauss_points.size(); ++g) {
      const ReferencePoint& reference = parts_->points[e][g];
      const PointMap& map = parts_->maps[g];
      const PointVector q = map * places_of(places, e);
      require_regular(q, e);
      const auto l = stretches_at(map, reference, q, map * places_of(velocity, e));
      const PointDamping point = point_damping(l, stress_rate(wall.material, l, q(0)));
      const double weight =
          wall.damping_time * wall.thickness * gauss_points[g].weight * reference.radius * reference.length;
      out.force.segment<element_unknowns>(first) += weight * point.force;
      FormSum::add_matrix<element_unknowns>(by_velocity, first, weight * point.by_velocity);
      FormSum::add_matrix<element_unknowns>(by_place, first, weight * point.by_place);
    }
  }
  out.by_velocity.setFromTriplets(by_velocity.begin(), by_velocity.end());
  out.by_place.setFromTriplets(by_place.begin(), by_place.end());
  return out;
}

}  // namespace turgor
