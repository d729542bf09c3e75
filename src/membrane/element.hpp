#pragma once
// The quadratic element of a meridian, and what its points and its joints contribute to energies.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>

#include "second_order.hpp"

namespace turgor {

constexpr std::size_t element_nodes = 3;

/// Shape functions with their first two derivatives at one place of the parameter in [-1, 1].
struct LineShape {
  std::array<double, element_nodes> value;
  std::array<double, element_nodes> slope;
  std::array<double, element_nodes> curve;
};
[[nodiscard]] inline LineShape line_shape(double xi) {
  return {{xi * (xi - 1) / 2, (1 - xi) * (1 + xi), xi * (xi + 1) / 2}, {xi - 0.5, -2 * xi, xi + 0.5}, {1, -2, 1}};
}

/// Gauss points: with three the volume of a quadratic element, a polynomial of degree 5, is exact.
struct GaussPoint {
  double place;
  double weight;
};
inline const std::array<GaussPoint, 3> gauss_points{
    {{-0.7745966692414834, 5.0 / 9}, {0.0, 8.0 / 9}, {0.7745966692414834, 5.0 / 9}}};

/// Variables of a point of an element: r, r', z', r'', z'' with respect to the element's parameter.
constexpr int point_variables = 5;
constexpr int element_unknowns = 6;
/// From the places of an element's nodes to its variables at a point.
using PointMap = Eigen::Matrix<double, point_variables, element_unknowns>;
[[nodiscard]] inline PointMap point_map(const LineShape& shape) {
  PointMap map = PointMap::Zero();
  for (std::size_t i = 0; i < element_nodes; ++i) {
    const auto r = static_cast<Eigen::Index>(2 * i);
    map(0, r) = shape.value[i];
    map(1, r) = map(2, r + 1) = shape.slope[i];
    map(3, r) = map(4, r + 1) = shape.curve[i];
  }
  return map;
}

/// The meridian at one place; T is a number or SecondOrder.
template <class T>
struct LinePoint {
  T r;
  T dr, dz;
  T ddr, ddz;

  /// |x'|
  [[nodiscard]] T length() const {
    using std::sqrt;
    return sqrt(dr * dr + dz * dz);
  }
  /// Principal curvatures [1/m], those of a sphere passed counterclockwise positive: along the meridian and around.
  [[nodiscard]] std::array<T, 2> curvatures() const {
    const T l = length();
    return {(dr * ddz - dz * ddr) / (l * l * l), dz / (r * l)};
  }
};

/// A place of the stress-free meridian.
struct ReferencePoint {
  double radius;                      ///< R [m]
  double length;                      ///< |X'| [m]
  std::array<double, 2> curvature{};  ///< [1/m]
};
[[nodiscard]] inline ReferencePoint reference_point(const Eigen::Matrix<double, point_variables, 1>& q) {
  const LinePoint<double> x{q(0), q(1), q(2), q(3), q(4)};
  return {x.r, x.length(), x.curvatures()};
}

/// Changes of the principal curvatures [1/m].
template <class T>
[[nodiscard]] std::array<T, 2> bending_strains(const LinePoint<T>& x, const ReferencePoint& reference) {
  const std::array<T, 2> k = x.curvatures();
  return {k[0] - reference.curvature[0], k[1] - reference.curvature[1]};
}

/// Twice the tangent of half the angle by which one direction turns to the next: the angle itself where it is small,
/// and without bound as the chain folds back on itself.
template <class T>
[[nodiscard]] T kink(const T& ar, const T& az, const T& br, const T& bz) {
  using std::sqrt;
  const T cross = ar * bz - az * br;
  const T along = ar * br + az * bz;
  const T both = sqrt((ar * ar + az * az) * (br * br + bz * bz));
  return 2.0 * (cross / (both + along));
}

}  // namespace turgor
