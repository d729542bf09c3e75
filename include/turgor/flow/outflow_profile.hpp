#pragma once
// How the outflow is distributed over the orifice: the profile f of (2.13).

#include <functional>
#include <vector>

#include "turgor/base/chebyshev.hpp"

namespace turgor {

/// Axial velocity over its mean, f(Upsilon) of (2.13), against the distance Upsilon from the axis over r_ch,
/// 0 <= Upsilon <= 1. Always normalised: int_0^1 Upsilon f dUpsilon = 1/2. Made of polynomials between knots.
class OutflowProfile {
 public:
  /// f = 1, the profile of (2.1) and (2.5).
  [[nodiscard]] static OutflowProfile uniform();

  /// f proportional to c_0 + c_1 Upsilon + c_2 Upsilon^2 + ...
  /// @throws InvalidInput unless it is finite and carries liquid out of the balloon
  [[nodiscard]] static OutflowProfile polynomial(const std::vector<double>& coefficients);

  /// Monotone cubics through points, mirrored at the axis so that f is smooth there.
  /// @param upsilon   strictly increasing from 0 to 1, at least four
  /// @param velocity  axial velocities there, in any unit, positive out of the balloon
  /// @throws InvalidInput when these do not make a profile
  [[nodiscard]] static OutflowProfile table(const std::vector<double>& upsilon, const std::vector<double>& velocity);

  /// Any function, approximated to `tolerance` of its largest value; where it is singular, on pieces down to a length
  /// of 1e-9.
  /// @throws InvalidInput as polynomial(), and when it would take more than a thousand pieces
  [[nodiscard]] static OutflowProfile function(const std::function<double(double)>& f, double tolerance = 1e-11);

  struct ValueAndSlope {
    double value;  ///< f
    double slope;  ///< df/dUpsilon
  };
  /// @param upsilon  0 to 1; beyond by rounding only
  [[nodiscard]] ValueAndSlope at(double upsilon) const;
  [[nodiscard]] double operator()(double upsilon) const { return at(upsilon).value; }

  /// Ends of the polynomials, from 0 to 1.
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
  [[nodiscard]] bool is_uniform() const { return uniform_; }
  /// The factor that normalised what was given.
  [[nodiscard]] double normalisation() const { return normalisation_; }
  /// int_0^1 2 Upsilon f^2 dUpsilon: flux of momentum over that of uniform outflow; 4/3 for Poiseuille's profile.
  [[nodiscard]] double momentum_factor() const;

 private:
  using Piece = ChebyshevSeries<16>;
  OutflowProfile(std::vector<Piece> pieces, bool uniform);
  /// int_0^1 Upsilon power(f) dUpsilon.
  template <class Integrand>
  [[nodiscard]] double moment(const Integrand& integrand) const;

  std::vector<Piece> pieces_;
  std::vector<double> knots_;
  double normalisation_ = 1;
  bool uniform_;
};

}  // namespace turgor
