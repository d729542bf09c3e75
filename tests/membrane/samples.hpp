#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "turgor/membrane/membrane.hpp"

namespace turgor {

/// The balloon of the paper's section 2.5: r0 = 30 cm, d0 = 3 mm.
inline constexpr double sample_radius = 0.3;
inline constexpr double sample_bending = 0.0297;  // [N m]
inline MembraneWall sample_wall() { return {MooneyRivlin<double>{1.5e6, 1.5e5}, 3e-3, 1000}; }

/// Every node at another place: nodes of the reference by a function of (r, z).
template <class Function>
Eigen::VectorXd moved(const Membrane& membrane, const Function& place) {
  Eigen::VectorXd x = membrane.reference();
  for (Eigen::Index i = 0; i < x.size(); i += 2) {
    const auto [r, z] = place(x(i), x(i + 1));
    x(i) = r;
    x(i + 1) = z;
  }
  return x;
}

/// A smooth state without symmetry that keeps the axis, with some roughness so that elements meet at angles.
inline Eigen::VectorXd sample_state(const Membrane& membrane) {
  Eigen::VectorXd x = moved(membrane, [](double r, double z) {
    return std::pair(r * (1.2 + 0.4 * z), 1.3 * z + 0.1 * std::sin(9 * r) + 0.05 * z * z);
  });
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x(i) != 0) x(i) += 4e-4 * std::sin(7.0 * static_cast<double>(i * i));
  }
  return x;
}

/// Slope of log(error) against log(elements) by the last two of errors at doubled counts.
inline double observed_order(const std::vector<double>& errors) {
  return std::log2(errors[errors.size() - 2] / errors.back());
}

}  // namespace turgor
