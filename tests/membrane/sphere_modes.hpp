#pragma once
// Small oscillations of a closed sphere filled with liquid: by the membrane's linear equations, and by a chain.

#include <Eigen/Dense>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "samples.hpp"
#include "turgor/membrane/equilibrium.hpp"

namespace turgor {

inline constexpr double mode_stretch = 1.2;
inline constexpr double mode_liquid = 1000;  // [kg/m^3]

/// Frequency [Hz] of the n-th shape of a closed sphere filled with liquid, by the membrane's linear equations on
/// spherical harmonics: radial a P_n and tangential b dP_n/dtheta.
inline double exact_frequency(const MembraneWall& wall, int n) {
  const BiaxialJet<double> w = strain_energy(wall.material, mode_stretch, mode_stretch);
  const double A = wall.thickness * w.d11;
  const double B = wall.thickness * w.d12;
  const double T = wall.thickness * w.d1 / mode_stretch;
  const double N = n * (n + 1);
  const double r = mode_stretch * sample_radius;
  const double solid = wall.density * wall.thickness / (mode_stretch * mode_stretch);
  Eigen::Matrix2d stiffness;
  stiffness << 2 * A + 2 * B + T * (N - 4), -N * (A + B - T), -N * (A + B - T), N * ((N - 1) * A + B - T);
  const Eigen::Matrix2d mass = Eigen::Vector2d(mode_liquid * r / n + solid, N * solid).asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(stiffness / (r * r), mass);
  return std::sqrt(solver.eigenvalues()(0)) / (2 * std::numbers::pi);
}

/// The wall's normal velocity in terms of P_1, P_2, ... gives the kinetic energy of the liquid: rho r/n per area.
/// P_0 would change the volume; it gets a mass beyond all others, so that it does not move.
inline Eigen::MatrixXd sphere_added_mass(const Eigen::VectorXd& places, double radius, double centre, int most) {
  std::vector<Eigen::VectorXd> moments(static_cast<std::size_t>(most + 1), Eigen::VectorXd::Zero(places.size()));
  for (Eigen::Index first = 0; first + 5 < places.size(); first += 4) {
    for (int side = -1; side <= 1; side += 2) {
      for (std::size_t g = 0; g < 4; ++g) {
        const double xi = side * boost::math::quadrature::gauss<double, 8>::abscissa()[g];
        const double weight = boost::math::quadrature::gauss<double, 8>::weights()[g];
        const Eigen::Vector3d value(xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2);
        const Eigen::Vector3d slope(xi - 0.5, -2 * xi, xi + 0.5);
        const Eigen::Matrix<double, 3, 2> x = places.segment<6>(first).reshaped(2, 3).transpose();
        const Eigen::Vector2d at = x.transpose() * value;
        const double area = at(0) * (x.transpose() * slope).norm() * weight;
        const Eigen::Vector2d normal = (at - Eigen::Vector2d(0, centre)).normalized();
        for (int n = 0; n <= most; ++n) {
          const double share = area * std::legendre(static_cast<unsigned>(n), normal(1));
          for (Eigen::Index i = 0; i < 3; ++i) {
            moments[static_cast<std::size_t>(n)].segment<2>(first + 2 * i) += share * value(i) * normal;
          }
        }
      }
    }
  }
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(places.size(), places.size());
  for (int n = 0; n <= most; ++n) {
    const Eigen::VectorXd& c = moments[static_cast<std::size_t>(n)];
    const double depth = n > 0 ? radius / n : 1e6 * radius;
    mass += mode_liquid * depth * (2 * n + 1) / (2 * radius * radius) * c * c.transpose();
  }
  return mass;
}

/// Frequencies [Hz] of a chain: the volume's, that of the shift along the axis, n = 2 and n = 3.
inline std::array<double, 4> sphere_frequencies(std::size_t elements) {
  const Membrane membrane(spherical_meridian(sample_radius, 0, elements), sample_wall());
  const MembraneState slack = slack_state(membrane);
  const MembraneState state = hold_volume(membrane, slack, std::pow(mode_stretch, 3) * slack.volume);
  const double centre = (state.places(1) + state.places(state.places.size() - 1)) / 2;
  const auto modes =
      shape_modes(membrane, state, sphere_added_mass(state.places, mode_stretch * sample_radius, centre, 12), 4);
  std::array<double, 4> hertz{};
  for (std::size_t i = 0; i < 4; ++i)
    hertz[i] = std::sqrt(std::abs(modes[i].frequency_squared)) / (2 * std::numbers::pi);
  return hertz;
}

}  // namespace turgor
