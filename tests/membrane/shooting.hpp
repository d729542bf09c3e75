#pragma once
// The membrane without bending stiffness at rest by shooting: an ordinary differential equation along the meridian from
// the pole to the rim, without elements and without energies.

#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "turgor/membrane/membrane.hpp"

namespace turgor {

struct ShotState {
  double pressure;  ///< [Pa]
  double volume;    ///< [m^3]
  double radius;    ///< as in MembraneState [m]
};

class Shooting {
 public:
  Shooting(MembraneWall wall, double radius, double rim) : wall_(std::move(wall)), radius_(radius), rim_(rim) {}

  /// The state at which the pole has this stretch.
  [[nodiscard]] ShotState at(double pole) const {
    const double near = 2 * wall_.thickness * strain_energy(wall_.material, pole, pole).d1 / (radius_ * pole * pole);
    const auto miss = [&](double p) {
      const double r = meridian(pole, p)[0];
      return std::isfinite(r) ? r - rim_ : -rim_;  // too much pressure closes the balloon before the rim
    };
    const double pressure = root(miss, 0.99 * near, 1.01 * near);
    const State end = meridian(pole, pressure);
    return {pressure, end[4], std::sqrt(end[3] / std::numbers::pi + rim_ * rim_) / 2};
  }

 private:
  /// r, thickness-free meridional tension W1 times R, angle of the tangent, area, volume.
  using State = std::array<double, 5>;

  template <class Function>
  static double root(const Function& f, double lo, double hi) {
    std::uintmax_t iterations = 100;
    return boost::math::tools::toms748_solve(f, lo, hi, boost::math::tools::eps_tolerance<double>(48), iterations)
        .first;
  }

  /// l1 at which the stress W1 has a value: it rises with l1.
  [[nodiscard]] double stretch_along(double stress, double l2, double guess) const {
    double l1 = guess;
    for (int i = 0; i < 50; ++i) {
      const BiaxialJet<double> w = strain_energy(wall_.material, l1, l2);
      const double change = (w.d1 - stress) / w.d11;
      l1 -= change;
      if (std::abs(change) < 1e-14) break;
    }
    return l1;
  }

  /// At the rim. Balance along the meridian: d(d0 W1 R)/dS = d0 W2 cos; across it: T1 k1 + T2 k2 = p.
  [[nodiscard]] State meridian(double pole, double pressure) const {
    const double d0 = wall_.thickness;
    double along = pole;
    const auto slope = [&](const State& y, State& out, double arc) {
      const double R = radius_ * std::sin(arc / radius_);
      const double around = y[0] / R;
      along = stretch_along(y[1] / R, around, along);
      const BiaxialJet<double> w = strain_energy(wall_.material, along, around);
      const double tension1 = d0 * w.d1 / around;
      const double tension2 = d0 * w.d2 / along;
      out[0] = along * std::cos(y[2]);
      out[1] = w.d2 * std::cos(y[2]);
      out[2] = along * (pressure - std::sin(y[2]) / y[0] * tension2) / tension1;
      out[3] = along * 2 * std::numbers::pi * y[0];
      out[4] = along * std::numbers::pi * y[0] * y[0] * std::sin(y[2]);
    };
    const double start = 1e-5 * radius_;  // the pole's neighbourhood is a plane to 1e-10
    const double stress = strain_energy(wall_.material, pole, pole).d1;
    const double r = pole * radius_ * std::sin(start / radius_);
    State y{r, stress * start, pressure * pole * pole * start / (2 * d0 * stress), std::numbers::pi * r * r, 0};
    using namespace boost::numeric::odeint;
    integrate_adaptive(make_controlled<runge_kutta_dopri5<State>>(1e-11, 1e-11), slope, y, start,
                       radius_ * (std::numbers::pi - std::asin(rim_ / radius_)), 1e-4);
    return y;
  }

  MembraneWall wall_;
  double radius_;
  double rim_;
};

}  // namespace turgor
