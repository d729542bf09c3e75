#include "turgor/asymptotics/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

Oscillation::Oscillation(const FreeMotion& motion, Regime regime)
    : equilibrium_(motion.equilibrium()), frequency_(motion.frequency(regime)) {
  const double R = equilibrium_;
  const double r2 = R * R;
  const double r3 = r2 * R;
  const Inertia<double>& i = motion.inertia(regime);
  const double M = i.mass(r3, R);
  const double M1 = i.mass_slope(r3) / M;
  const double M2 = 12 * i.m4 * r2 / M;
  const double Q = i.centripetal(r3) / M;
  const double Q1 = i.centripetal_slope(r2, r3) / M;

  // Derivatives of g = F/M, relative to the first.
  const Jet<double> F = motion.force().at(R);
  const double second = F.second / F.first - 2 * M1;
  const double third = motion.force().third(R) / F.first - 3 * M1 * F.second / F.first + 6 * M1 * M1 - 3 * M2;

  const double nu = -Q;
  const double nu_slope = -(Q1 - Q * M1);
  mass_slope_ = nu;
  mass_curvature_ = nu * nu + nu_slope;
  quadratic_ = second / 2 + nu / 2;
  cubic_ = third / 6 - nu * nu / 6 + nu_slope / 3;
  nonlinearity_ =
      std::max({std::abs(quadratic_), std::sqrt(std::abs(cubic_)), std::abs(nu), std::sqrt(std::abs(nu_slope))});
}

double Oscillation::first(double e, double T) const { return equilibrium_ + e * std::cos(frequency_ * T); }

double Oscillation::second(double e, double T) const {
  const double angle = frequency_ * T;
  const double constant = -mass_slope_ / 2 - (quadratic_ - mass_slope_ / 2) / 2;
  const double twice = -mass_slope_ / 6 + (quadratic_ - mass_slope_ / 2) / 6;
  return first(e, T) + e * e * (constant + twice * std::cos(2 * angle) - (constant + twice) * std::cos(angle));
}

// Lindstedt's expansion of s'' + alpha^2 (s + a s^2 + b s^3) = 0, with s(R) and R(s) to the same order.
double Oscillation::third(double e, double T) const {
  const double a = quadratic_;
  const double triple = a * a / 48 + cubic_ / 32;
  const double s = e * (1 + e * (mass_slope_ / 2 + e * mass_curvature_ / 6));
  const double A = s * (1 + s * (a / 3 + s * (2 * a * a / 9 - triple)));
  const double angle = frequency_ * T * (1 - lengthening() * A * A);
  const double x = A * (std::cos(angle) + A * (a / 6 * (std::cos(2 * angle) - 3) + A * triple * std::cos(3 * angle)));
  return equilibrium_ + x * (1 + x * (-mass_slope_ / 2 + x * (mass_slope_ * mass_slope_ / 2 - mass_curvature_ / 6)));
}

double Oscillation::lengthening() const { return 5 * quadratic_ * quadratic_ / 12 - 3 * cubic_ / 8; }

double Oscillation::fourth_order_size(double e) const { return std::abs(e) * power<3>(std::abs(e) * nonlinearity_); }

void Oscillation::require(double e, double T) const {
  require_time(T);
  if (std::abs(e) <= reach()) return;
  throw InvalidInput("e", shortest(e),
                     "is beyond the reach of an expansion about the equilibrium " + shortest(equilibrium_),
                     "at most " + shortest(reach()));
}

Estimate Oscillation::first_order(double e, double T) const {
  require(e, T);

  const double value = first(e, T);
  return {value, std::abs(third(e, T) - value) + fourth_order_size(e)};
}

Estimate Oscillation::second_order(double e, double T) const {
  require(e, T);

  const double value = second(e, T);
  return {value, std::abs(third(e, T) - value) + fourth_order_size(e)};
}

Estimate Oscillation::third_order(double e, double T) const {
  require(e, T);
  return {third(e, T), fourth_order_size(e)};
}

Estimate Oscillation::half_period(double e) const {
  const double value = std::numbers::pi / frequency_;
  return {value, value * (std::abs(lengthening()) * e * e + power<3>(std::abs(e) * nonlinearity_))};
}

Estimate Oscillation::corrected_half_period(double e) const {
  const double value = std::numbers::pi / frequency_;
  return {value * (1 + lengthening() * e * e), value * power<3>(std::abs(e) * nonlinearity_)};
}

double alpha2(const FreeMotion& motion) {
  const Jet<double> F = motion.force().at(motion.equilibrium());
  return 5 + motion.equilibrium() * F.second / (2 * F.first);
}

}  // namespace turgor
