#pragma once
// An elastic membrane of revolution, with the bending stiffness of its thickness, on a chain of quadratic elements:
// energies with exact gradients and Hessians, for solvers that move its nodes.
//
// Everything is per radian about the axis, as the integrals of the flow solver are. Places and velocities of n nodes
// are vectors of 2n numbers: r and z of the first node, of the second one, ...

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "turgor/material/material.hpp"
#include "turgor/membrane/meridian.hpp"

namespace turgor {

/// How the rim is held. It never moves; hinged it turns freely, clamped it keeps its direction.
enum class Rim { hinged, clamped };

/// What the membrane is made of.
struct MembraneWall {
  Material<double> material;
  double thickness;              ///< unstretched, d0 [m]
  double density;                ///< [kg/m^3]
  double bending_stiffness = 0;  ///< D [N m]; 0: none
  double damping_time = 0;       ///< eta [s]
  Rim rim = Rim::hinged;
};

/// A function of the places, with its derivatives.
struct MembraneForm {
  double value;
  Eigen::VectorXd gradient;             ///< 2n numbers
  Eigen::SparseMatrix<double> hessian;  ///< 2n x 2n, symmetric
};

/// Viscous forces and their derivatives.
struct MembraneDamping {
  Eigen::VectorXd force;                    ///< [N/rad], of the sign of MembraneForm::gradient: against the motion
  Eigen::SparseMatrix<double> by_velocity;  ///< [N s/m/rad], symmetric
  Eigen::SparseMatrix<double> by_place;     ///< [N/m/rad], not symmetric
};

class Membrane {
 public:
  /// @throws InvalidInput for membrane.nodes that are no meridian, and for a thickness or density that is not positive,
  ///         or a bending stiffness or damping time that is negative
  Membrane(const Meridian& reference, MembraneWall wall);

  [[nodiscard]] const MembraneWall& wall() const;
  /// Places of the stress-free membrane.
  [[nodiscard]] const Eigen::VectorXd& reference() const;
  /// Whether both ends lie on the axis.
  [[nodiscard]] bool closed() const;
  /// Radius of the hole [m]; 0 when closed.
  [[nodiscard]] double rim_radius() const;
  /// Unknowns that may change: all but r on the axis and both of the rim.
  [[nodiscard]] const std::vector<Eigen::Index>& free_unknowns() const;

  /// Elastic energy [J/rad], with its gradient [N/rad], the resistance to a displacement of the nodes.
  ///
  /// Integral over the stress-free area of
  ///   d0 W(l1, l2) + D/2 (k1^2 + k1 k2 + k2^2),     l1 = |x'|/|X'|,  l2 = r/R,
  /// W the strain energy of Material, k1 and k2 the changes of the principal curvatures
  ///   (r' z'' - z' r'')/|x'|^3  and  z'/(r |x'|).
  /// Elements meet at an angle, by which curvature is a Dirac function there; with its jump g, curvature per stretch
  /// less that of the stress-free chain, every node between elements adds
  ///   R [ {m1} g + (sigma D/2h) g^2 ],     m1 = D (k1 + k2/2),  sigma = 4,
  /// {} the mean of both sides (interior penalty: Engel et al., Comput. Methods Appl. Mech. Eng. 191 (2002) 3669). A
  /// clamped rim adds the same for the angle that it has turned. A rigid motion along the axis costs nothing.
  /// @throws ComputationFailed when the chain touches the axis, an element has no length, or the material has locked
  [[nodiscard]] MembraneForm elastic(const Eigen::VectorXd& places) const;

  /// Volume between the membrane and the plane of its rim [m^3/rad]; its gradient times a pressure is the load of that
  /// pressure, its Hessian what the load changes when it follows the wall. Exact for the quadratic chain.
  [[nodiscard]] MembraneForm volume(const Eigen::VectorXd& places) const;

  /// Area of the wall [m^2/rad].
  [[nodiscard]] double area(const Eigen::VectorXd& places) const;

  /// Kelvin-Voigt damping of the membrane's stress: the principal nominal stress dW/dl_i gets eta d/dt(dW/dl_i) in
  /// addition, so the force is eta times the material part of (tangent times velocity), and rigid motion has none.
  /// It dissipates while W is convex in its stretches (Mooney-Rivlin: up to l = sqrt(s1/s2) in equal biaxial stretch).
  /// @throws as elastic()
  [[nodiscard]] MembraneDamping damping(const Eigen::VectorXd& places, const Eigen::VectorXd& velocity) const;

  /// Consistent mass matrix of the wall [kg/rad]: the integral of density d0 N_i N_j over the stress-free area.
  [[nodiscard]] const Eigen::SparseMatrix<double>& mass() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;  // never changes: copies share it
};

}  // namespace turgor
