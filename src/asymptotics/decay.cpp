#include "turgor/asymptotics/decay.hpp"

#include <algorithm>
#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <cmath>
#include <numbers>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

/// Y = 1 + W0(-z e^-z), z = 1 + X, is the root of (1 - Y) e^Y = (1 + X) e^-X. Next to its branch point W0 knows half
/// the digits only; one step of Newton's method on the logarithm of that equation restores them.
double lambert_map(double X) {
  constexpr double near = 1e-3;
  const double z = 1 + X;
  double Y = X < near ? X / (1 + 2 * X / 3) : 1 + boost::math::lambert_w0(-z * std::exp(-z));
  if (X < 1) Y += (boost::math::log1pmx(-Y) - boost::math::log1pmx(X)) * (1 - Y) / Y;
  return Y;
}

/// First order effect of F'' (f) and beta' (d) on lambert_map(X): perturbation of k' = 2 beta k - 2 F with k = 0 at
/// both ends.
double correction(double X, double Y, double f, double d) {
  if (X < 1e-3) return f * 2 * X * X / 3;  // the difference below would lose its digits
  const double decay = std::exp(-(X + Y));
  const double of_damping = 2 * (Y * Y - 3 * Y + 3) - decay * (2 * (X * X + 3 * X + 3) + (X + 1) * (X * X - Y * Y));
  const double of_force = -2 * (Y * Y - 2 * Y + 2) + 2 * decay * (X * X + 2 * X + 2);
  return -(d * of_damping + f * of_force) / (2 * Y);
}

void require_amplitude(const char* name, double x) {
  if (!(x > 0) || !std::isfinite(x)) {
    throw InvalidInput(name, shortest(x), "is no distance from the equilibrium", "give a number above 0");
  }
}

}  // namespace

Decay::Decay(const FreeMotion& motion)
    : beta_(motion.beta()),
      cycle_time_(std::numbers::pi *
                  (1 / motion.frequency(Regime::deflating) + 1 / motion.frequency(Regime::inflating))) {
  const double R = motion.equilibrium();
  const double r2 = R * R;
  const double r3 = r2 * R;
  const Inertia<double>& i = motion.inertia(Regime::deflating);
  const double M = i.mass(r3, R);
  const double beta_slope =
      (6 * i.m4 * r2 + i.centripetal_slope(r2, r3) - beta_ * i.mass_slope(r3)) / M;  // of (M'/2 + Q)/M
  const Jet<double> F = motion.force().at(R);
  force_ = F.second / (4 * beta_ * F.first);
  damping_ = beta_slope / (2 * beta_ * beta_);
}

Estimate Decay::undershoot(double x) const {
  require_amplitude("x", x);
  const double X = 2 * beta_ * x;
  const double Y = lambert_map(X);
  return {Y / (2 * beta_), std::abs(correction(X, Y, force_, damping_)) / (2 * beta_)};
}

Estimate Decay::corrected_undershoot(double x) const {
  const Estimate plain = undershoot(x);
  const double X = 2 * beta_ * x;
  const double by = correction(X, 2 * beta_ * plain.value, force_, damping_) / (2 * beta_);
  return {plain.value + by, by * by / plain.value};
}

Estimate Decay::greatest_undershoot() const { return {1 / (2 * beta_), std::abs(force_ - damping_) / (2 * beta_)}; }

double Decay::after_cycle_corrected(double x) const {
  const double y = corrected_undershoot(x).value;
  return y - 4 * beta_ * force_ / 3 * y * y;  // inflation: F' y^2/2 - F'' y^3/6 = F' x^2/2 + F'' x^3/6
}

Estimate Decay::amplitude(double first, long cycles) const {
  require_amplitude("first", first);
  if (cycles < 0) throw InvalidInput("cycles", std::to_string(cycles), "is no number of cycles", "give 0 or more");
  constexpr long one_by_one = 1000;  // by then 1/x has settled to its law within 1/cycles
  double plain = first;
  double corrected = first;
  const long mapped = std::min(cycles, one_by_one);
  for (long i = 0; i < mapped; ++i) {
    plain = undershoot(plain).value;
    corrected = after_cycle_corrected(corrected);
  }
  const auto later = [&](double x) { return 1 / (1 / x + 4 * beta_ / 3 * static_cast<double>(cycles - mapped)); };
  return {later(plain), std::abs(later(corrected) - later(plain))};
}

double Decay::cycles_until(double first, double amplitude) const {
  require_amplitude("first", first);
  require_amplitude("amplitude", amplitude);
  return std::max(0.0, (1 / amplitude - 1 / first) * 3 / (4 * beta_));
}

}  // namespace turgor
