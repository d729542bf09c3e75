#pragma once
// The flow inside a deflating balloon: solution of (2.4), (2.5) and its generalization by (2.13).

#include <memory>
#include <numbers>

#include "turgor/flow/outflow_profile.hpp"

namespace turgor {

/// A place in the balloon, in spherical coordinates about its centre.
struct FlowPoint {
  double radius;  ///< over the balloon's radius r, 0 to 1
  double theta;   ///< from the axis, 0 to pi; the orifice is at pi
};

/// The flow at one point for dr/dt = 1 and r = 1, seen from the balloon's centre. In a balloon of radius r that shrinks
/// with dr/dt velocities are dr/dt times these, the potential is r dr/dt times this one.
struct FlowField {
  double potential;         ///< sum A_m/(2m) radius^m P_m(cos theta) of (2.6)
  double potential_change;  ///< its derivative with respect to eps at a fixed place: the same sum with dA_m/deps
  double radial;            ///< v_r
  double tangential;        ///< v_theta
};

/// Potential flow (2.6) in a ball whose wall moves with unit normal velocity, the liquid leaving through the cap beyond
/// the orifice with (2.5), or with the profile f of (2.13).
///
/// Instead of the Legendre series, which near the rim needs some 15/eps terms, the flow is the surface integral of
///
///     n = 1/d - 1 + 1/2 ln(2/(1 - s cos gamma + d)) = sum_{m>=1} (2m+1)/(2m) s^m P_m(cos gamma),
///
/// Neumann's function of the ball (d: distance to a source on the sphere, gamma: angle to it, s: radius of the point),
/// over the cap alone, since n is blind to what is the same all over the sphere. Gauss rules in variables that stretch
/// with the distance to the cap keep the accuracy up to the rim, at any place. docs/theory.md, section 2.1.1.
class PotentialFlow {
 public:
  /// @param kappa      r_ch/r, 0 < kappa < 1
  /// @param tolerance  accuracy wanted of each value, relative to the size of what is integrated, 1e-15 to 1e-4
  /// @throws InvalidInput when kappa or tolerance is out of range
  explicit PotentialFlow(double kappa, OutflowProfile profile = OutflowProfile::uniform(), double tolerance = 1e-13);

  /// @throws InvalidInput for points outside the balloon: radius > 1, beyond the orifice's plane, or on the rim, where
  ///   velocities are infinite
  [[nodiscard]] FlowField at(const FlowPoint& point) const;

  /// On the wall, `offset` [rad] from the rim; keeps its digits however close to the rim.
  /// @param offset  0 < offset <= wall_angle()
  [[nodiscard]] FlowField on_wall(double offset) const;

  /// In the middle of the orifice's plane, where (2.3) gives the pressure.
  [[nodiscard]] const FlowField& at_orifice() const { return at_orifice_; }

  [[nodiscard]] double kappa() const { return kappa_; }
  [[nodiscard]] double eps() const { return eps_; }
  [[nodiscard]] const OutflowProfile& profile() const { return profile_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  /// Angle from the rim to the pole opposite the orifice.
  [[nodiscard]] double wall_angle() const { return std::numbers::pi - cap_angle_; }

  /// Normal velocity at the cap, of the balloon's centre's frame, less than the wall's: u - 1 with u of (2.5); and its
  /// derivative with respect to eps at a fixed place. The sources of the flow.
  struct CapSource {
    double strength;
    double change;
  };
  /// @param angle  from the axis through the orifice, 0 to asin(kappa)
  [[nodiscard]] CapSource source(double angle) const;
  /// asin(kappa).
  [[nodiscard]] double cap_angle() const { return cap_angle_; }

 private:
  struct Target;
  class Sum;
  [[nodiscard]] FlowField field(const Target& target) const;
  void add_piece(Sum& sum, double from, double to) const;

  double kappa_;
  double eps_;
  double cap_angle_;
  OutflowProfile profile_;
  double tolerance_;
  std::shared_ptr<const class RingQuadrature> quadrature_;
  FlowField at_orifice_{};
};

}  // namespace turgor
