#pragma once
// A tube of rings full of liquid, and its small waves.

#include <complex>

#include "turgor/fem/taylor_hood.hpp"

namespace turgor {

/// The generalised string: radial displacement eta of a wall whose points do not move along the tube,
///   mass eta_tt + stiffness eta - tension eta_zz = pressure of the liquid on it
/// (Quarteroni, Tuveri & Veneziani, Comput. Visual. Sci. 2 (2000) 163). Values are those of the benchmark: h = 1 mm,
/// E = 3e5 Pa, Poisson's ratio 0.3, 1200 kg/m^3, 1333.2 Pa for 3 ms.
struct Tube {
  static constexpr double young_thickness = 3e5 * 1e-3;  ///< E h [N/m]
  static constexpr double poisson = 0.3;

  double radius = 5e-3;  ///< [m]
  double length = 0.05;  ///< [m]
  double mass = 1.2;     ///< of the wall's area [kg/m^2]
  /// E h/((1 - nu^2) R^2): a wall that is held in length; without the factor, one that is free of stress along it
  /// [Pa/m].
  double stiffness = young_thickness / (1 - poisson * poisson) / (radius * radius);
  /// Of shear, k G h with Timoshenko's k = 5/6 [N/m]; 0 for rings that do not know of each other.
  double tension = 5.0 / 6 * young_thickness / (2 * (1 + poisson));
  double density = 1000;  ///< of the liquid [kg/m^3]
  double viscosity = 0;   ///< [Pa s]; 0: the liquid slides along the wall

  /// Moens's and Korteweg's (stiffness R/(2 rho))^{1/2} [m/s].
  [[nodiscard]] double long_wave_speed() const;
  /// omega of waves of a wave number k in liquid of no viscosity [rad/s]:
  ///   omega^2 {mass + rho I0(kR)/(k I1(kR))} = stiffness + tension k^2.
  [[nodiscard]] double frequency(double k) const;
};

/// I1/I0 for Re z > 0, by its continued fraction.
[[nodiscard]] std::complex<double> bessel_ratio(std::complex<double> z);

/// A small wave that stands in a tube closed at both ends, exact for liquid of any viscosity:
///   u_r = Re {[I1(kr) + b I1(kappa r)] e^{st}} cos kz,  u_z = -Re {[I0(kr) + b kappa/k I0(kappa r)] e^{st}} sin kz,
///   p = -Re {rho s/k I0(kr) e^{st}} cos kz,             kappa^2 = k^2 + s rho/mu,
/// b such that u_z = 0 on the wall (0 without viscosity), s such that the wall's equation holds: decay and frequency.
/// Scaled so that the displacement of the wall is `amplitude` at t = 0.
class StandingWave {
 public:
  StandingWave(const Tube& tube, double k, double amplitude);
  [[nodiscard]] std::complex<double> rate() const { return s_; }
  [[nodiscard]] Point2 velocity(const Point2& x, double t) const;
  [[nodiscard]] double displacement(double z, double t) const;

 private:
  /// What the wall's equation lacks.
  [[nodiscard]] std::complex<double> defect(std::complex<double> s) const;
  [[nodiscard]] std::complex<double> wave_number(std::complex<double> s) const;
  /// Radial velocity of the wall over the amplitude of I0(kR).
  [[nodiscard]] std::complex<double> wall_rate(std::complex<double> s) const;

  Tube tube_;
  double k_;
  std::complex<double> s_;
  std::complex<double> scale_;
};

/// Pressure at the end of a tube: constant for its duration, or (1 - cos)/2 of it.
struct PressurePulse {
  double height = 1333.2;  ///< [Pa]
  double duration = 3e-3;  ///< [s]
  bool smooth = false;

  /// A jump belongs to the instants before it.
  [[nodiscard]] double operator()(double t) const;
  /// What a unit oscillator of a frequency [rad/s] makes of it from rest: x'' / omega^2 + x = pressure.
  [[nodiscard]] double response(double omega, double t) const;
};

/// Displacement of the wall in small waves without viscosity: from rest, pressure at z = 0, the wall held there, the
/// far end closed; the sum over the waves with nodes at z = 0.
[[nodiscard]] double pulse_displacement(const Tube& tube, const PressurePulse& pulse, double z, double t);

}  // namespace turgor
