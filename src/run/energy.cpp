#include "turgor/run/energy.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace turgor {

EnergyLedger::EnergyLedger(const Oscillator<double>& oscillator, const Trajectory<double>& trajectory)
    : oscillator_(oscillator), trajectory_(trajectory) {
  Flux sum{0, 0};
  before_step_.reserve(trajectory.steps.size() + 1);
  for (const auto& step : trajectory.steps) {
    before_step_.push_back(sum);
    const Flux flux = over_step(step, 1.0);
    sum.work += flux.work;
    sum.dissipated += flux.dissipated;
  }
  before_step_.push_back(sum);
}

/// From the beginning of a step to theta. The integrands are smooth there, and polynomials of low degree times powers
/// of R.
EnergyLedger::Flux EnergyLedger::over_step(const TrajectoryStep<double>& step, double theta) const {
  if (step.regime == Regime::rest || !(theta > 0)) return {0, 0};
  const SmoothPressure<double>& pressure = oscillator_.pressure().after(step.start);
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  const double work = Gauss::integrate(
      [&](double x) {
        const double R = step.stretch_at(x);
        return oscillator_.area(R) * pressure(step.start + x * step.duration) * step.rate_at(x);
      },
      0.0, theta);
  double dissipated = 0;
  if (!oscillator_.conserves_energy(step.regime)) {
    dissipated = Gauss::integrate(
        [&](double x) {
          const auto c = oscillator_.flow_coefficients(step.regime, step.stretch_at(x));
          const double v = step.rate_at(x);
          return -(c.mass_slope / 2 + c.centripetal) * v * v * v;
        },
        0.0, theta);
  }
  return {work * step.duration, dissipated * step.duration};
}

double EnergyLedger::kinetic(const Point<double>& point) const {
  if (point.regime == Regime::rest || point.rate == 0) return 0;
  return oscillator_.flow_coefficients(point.regime, point.stretch).mass * point.rate * point.rate / 2;
}

Energies EnergyLedger::at(double time) const {
  const Point<double> point = trajectory_.at(time);
  Flux flux = before_step_.back();
  if (time < trajectory_.last.time && !trajectory_.steps.empty()) {
    const auto& step = trajectory_.step_at(time);
    flux = before_step_[static_cast<std::size_t>(&step - trajectory_.steps.data())];
    const Flux part = over_step(step, (time - step.start) / step.duration);
    flux.work += part.work;
    flux.dissipated += part.dissipated;
  }
  const double unit = oscillator_.scales().energy();
  return {unit * kinetic(point), unit * oscillator_.elastic_energy(point.stretch), unit * flux.work,
          unit * flux.dissipated};
}

double EnergyLedger::closure_error() const {
  if (trajectory_.steps.empty()) return 0;
  const Energies first = at(trajectory_.steps.front().start);
  const Energies last = at(trajectory_.last.time);
  double largest = 0;
  const auto include = [&](const Energies& e) {
    largest = std::max({largest, e.kinetic, std::abs(e.elastic), std::abs(e.inlet_work), e.dissipated});
  };
  for (const auto& step : trajectory_.steps) include(at(step.start));
  include(last);
  if (largest == 0) return 0;
  const double defect = last.kinetic + last.elastic - last.inlet_work + last.dissipated - first.kinetic - first.elastic;
  return std::abs(defect) / largest;
}

}  // namespace turgor
