#include "tube_theory.hpp"

#include <cmath>
#include <numbers>

namespace turgor {

namespace {

using Complex = std::complex<double>;

/// I0 (n = 0) or I1 by its series, which for |z| < 60 halfway between the axes loses at most eight digits.
Complex bessel_i(int n, Complex z) {
  Complex term = n == 0 ? 1.0 : z / 2.0;
  Complex sum = term;
  for (int j = 1; j < 200; ++j) {
    term *= z * z / (4.0 * j * (j + n));
    sum += term;
  }
  return sum;
}

}  // namespace

Complex bessel_ratio(Complex z) {
  Complex ratio = 0;
  for (int n = 40 + static_cast<int>(2 * std::abs(z)); n > 0; --n) ratio = 1.0 / (2.0 * n / z + ratio);
  return ratio;
}

double Tube::long_wave_speed() const { return std::sqrt(stiffness * radius / (2 * density)); }

double Tube::frequency(double k) const {
  const double added = density / (k * bessel_ratio(k * radius).real());
  return std::sqrt((stiffness + tension * k * k) / (mass + added));
}

StandingWave::StandingWave(const Tube& tube, double k, double amplitude)
    : tube_(tube), k_(k), s_(0, tube.frequency(k)) {
  if (tube_.viscosity > 0) {  // secants
    Complex before = s_ * Complex(0.99, 0.01);
    for (int i = 0; i < 50 && std::abs(s_ - before) > 1e-13 * std::abs(s_); ++i) {
      const Complex here = defect(s_);
      const Complex next = s_ - here * (s_ - before) / (here - defect(before));
      before = s_;
      s_ = next;
    }
  }
  scale_ = amplitude * s_ / wall_rate(s_);
}

Complex StandingWave::wave_number(Complex s) const { return std::sqrt(k_ * k_ + s * tube_.density / tube_.viscosity); }

Complex StandingWave::wall_rate(Complex s) const {
  const Complex potential = bessel_ratio(k_ * tube_.radius);
  if (tube_.viscosity == 0) return potential;
  const Complex kappa = wave_number(s);
  return potential - k_ / kappa * bessel_ratio(kappa * tube_.radius);
}

Complex StandingWave::defect(Complex s) const {
  const Complex wall =
      tube_.mass * s + (tube_.stiffness + tube_.tension * k_ * k_) / s - 2 * tube_.viscosity / tube_.radius;
  return wall * wall_rate(s) + tube_.density * s / k_;
}

Point2 StandingWave::velocity(const Point2& x, double t) const {
  const Complex wave = scale_ * std::exp(s_ * t);
  const double outside = bessel_i(0, k_ * tube_.radius).real();
  Complex radial = bessel_i(1, k_ * x[0]) / outside;
  Complex axial = bessel_i(0, k_ * x[0]) / outside;
  if (tube_.viscosity > 0) {
    const Complex kappa = wave_number(s_);
    const Complex wall = bessel_i(0, kappa * tube_.radius);
    radial -= k_ / kappa * bessel_i(1, kappa * x[0]) / wall;
    axial -= bessel_i(0, kappa * x[0]) / wall;
  }
  return {(wave * radial).real() * std::cos(k_ * x[1]), -(wave * axial).real() * std::sin(k_ * x[1])};
}

double StandingWave::displacement(double z, double t) const {
  return (scale_ * wall_rate(s_) / s_ * std::exp(s_ * t)).real() * std::cos(k_ * z);
}

double PressurePulse::operator()(double t) const {
  if (t > duration * (1 + 1e-9)) return 0;
  return smooth ? height / 2 * (1 - std::cos(2 * std::numbers::pi * t / duration)) : height;
}

double PressurePulse::response(double omega, double t) const {
  const double forced = 2 * std::numbers::pi / duration;
  const auto from_rest = [&](double since) {
    if (since <= 0) return 0.0;
    const double own = std::cos(omega * since);
    if (!smooth) return 1 - own;
    return (1 - own - (std::cos(forced * since) - own) / (1 - std::pow(forced / omega, 2))) / 2;
  };
  return height * (from_rest(t) - from_rest(t - duration));
}

double pulse_displacement(const Tube& tube, const PressurePulse& pulse, double z, double t) {
  constexpr int waves = 400;  // with tension, the last ones' amplitudes are 1e-7 of the first one's
  double sum = 0;
  for (int n = 0; n < waves; ++n) {
    const double k = (n + 0.5) * std::numbers::pi / tube.length;
    const double stiffness = tube.stiffness + tube.tension * k * k;
    sum += 2 / (k * tube.length) / stiffness * pulse.response(tube.frequency(k), t) * std::sin(k * z);
  }
  return sum;
}

}  // namespace turgor
