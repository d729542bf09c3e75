#pragma once
// Neumann's function of the ball, averaged over a ring of sources on its surface.

#include <array>
#include <cmath>
#include <vector>

#include "gauss_legendre.hpp"

namespace turgor {

/// Where the flow is wanted. Angles are measured from the axis through the orifice.
struct RingTarget {
  double depth;   ///< 1 - radius, without cancellation
  double radius;  ///< 0 to 1
  double angle;
  double sine;  ///< of the angle
  double cosine;
};

/// Average of n over a ring and its gradient; the tangential component is along increasing angle.
struct RingField {
  double potential = 0;
  double radial = 0;
  double tangential = 0;
};

/// Averages over rings, to a given tolerance.
class RingQuadrature {
 public:
  explicit RingQuadrature(double tolerance);

  /// @param difference  angle of the target less that of the ring, without cancellation
  /// @param sine        of the ring's angle
  [[nodiscard]] RingField average(const RingTarget& target, double difference, double sine) const;
  /// The potential alone.
  [[nodiscard]] double potential(const RingTarget& target, double difference, double sine) const;

  /// Gauss rule for a function of w on [0, length] that is smooth but for singularities at +-i pi/2 above or below 0:
  /// what 1/d becomes when distances are stretched by sinh w.
  [[nodiscard]] const GaussLegendre& stretched_rule(double length) const;

 private:
  template <class Add>
  void over_ring(double nearest_squared, double spread, const Add& add) const;

  struct Rule {
    double greatest_length;
    const GaussLegendre* rule;
  };
  double digits_;  ///< -ln(tolerance)
  std::vector<Rule> rules_;
  static constexpr int most_midpoints = 48;
  std::array<std::vector<double>, most_midpoints + 1> midpoints_;  ///< sin^2(psi/2) of so many midpoints of [0, pi]
};

}  // namespace turgor
