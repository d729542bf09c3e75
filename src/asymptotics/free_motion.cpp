#include "turgor/asymptotics/free_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

RestoringForce::RestoringForce(const Oscillator<double>& oscillator, double pressure)
    : material_(oscillator.parameters().material), factor_(oscillator.elastic_factor()), pressure_(pressure) {}

double RestoringForce::elastic_curvature(double R) const {
  constexpr double step = 1e-40;  // its square vanishes beside R: the derivative is exact to rounding
  return factor_ * strain_energy(material_, std::complex<double>(R, step)).second.imag() / step;
}

Jet<double> RestoringForce::at(double R) const {
  const Jet<double> w = strain_energy(material_, R);
  return {factor_ * w.first - R * R * pressure_, factor_ * w.second - 2 * R * pressure_,
          elastic_curvature(R) - 2 * pressure_};
}

double RestoringForce::third(double R) const {
  const double h = 1e-4 * R;  // truncation h^2, rounding 1e-16/h: it only judges errors and corrects small terms
  return (elastic_curvature(R + h) - elastic_curvature(R - h)) / (2 * h);
}

FreeMotion::FreeMotion(const Oscillator<double>& oscillator, double pressure, double stretch)
    : model_(oscillator.model()),
      scales_(oscillator.scales()),
      force_(oscillator, pressure),
      inflating_(oscillator.inertia(Regime::inflating)),
      deflating_(oscillator.inertia(Regime::deflating)) {
  const Closure closure = oscillator.parameters().closure;
  if (has_table(closure)) {
    throw InvalidInput("model.closure", "\"" + std::string(name_of(closure)) + "\"",
                       "has no closed approximations: they rest on masses that are powers of R",
                       "use \"corrected\" or \"theoretical\"");
  }
  const Groups<double>& g = oscillator.dimensionless_groups();
  if (model_ == Model::orifice) deflation_ = {g.C1, g.C2};
  if (model_ == Model::long_channel) deflation_ = {g.C1_long, g.C2_long};
  if (!std::isfinite(pressure)) throw InvalidInput("pressure", shortest(pressure), "is not finite");
  greatest_ = stretch_limit(oscillator.parameters().material);
  const auto states = equilibria(oscillator.parameters(), pressure * scales_.pressure);
  find_well(states, stretch);
}

void FreeMotion::find_well(const std::vector<Equilibrium>& states, double stretch) {
  if (!(stretch > 0) || !(stretch < greatest_)) {
    throw InvalidInput("stretch", shortest(stretch), "is no stretch of this balloon",
                       "a number above 0, below the stretch at which the wall locks");
  }
  least_ = 0;
  std::string list;
  for (const auto& [R, stable] : states) {
    list += (list.empty() ? "equilibria are " : ", ") + shortest(R) + (stable ? " (stable)" : " (unstable)");
    if (!stable && R <= stretch) least_ = R;
    if (!stable && R >= stretch) greatest_ = std::min(greatest_, R);
  }
  for (const auto& [R, stable] : states) {
    if (stable && R > least_ && R < greatest_) equilibrium_ = R;
  }
  if (!(equilibrium_ > 0)) {
    throw InvalidInput("stretch", shortest(stretch), "lies in the well of no stable equilibrium",
                       list.empty() ? "this pressure has no equilibria" : list);
  }
}

double FreeMotion::frequency(Regime regime) const {
  const double R = equilibrium_;
  return std::sqrt(force_.at(R).first / inertia(regime).mass(R * R * R, R));
}

double FreeMotion::beta() const {
  const double R = equilibrium_;
  const double cube = R * R * R;
  return (deflating_.mass_slope(cube) / 2 + deflating_.centripetal(cube)) / deflating_.mass(cube, R);
}

TimeScales FreeMotion::time_scales() const {
  const double slope = force_.at(equilibrium_).first;
  return {scales_.time / frequency(Regime::deflating), scales_.time / frequency(Regime::inflating),
          power<4>(equilibrium_) / slope, 1 / slope};
}

const DeflationConstants& FreeMotion::require_deflation() const {
  if (!deflation_) {
    throw InvalidInput("model.name", "full", "the asymptotic expansions of deflation are those of (2.23) and (2.25)",
                       "choose \"orifice\" or \"long-channel\"");
  }
  return *deflation_;
}

void require_above_equilibrium(const FreeMotion& motion, double start) {
  if (start > motion.equilibrium() && start < motion.greatest()) return;
  throw InvalidInput(
      "start", shortest(start), "deflation from rest starts above its stable equilibrium, in the same well",
      "above " + shortest(motion.equilibrium()) +
          (std::isfinite(motion.greatest()) ? " and below " + shortest(motion.greatest()) : std::string()));
}

void require_time(double T) {
  if (!(T >= 0)) throw InvalidInput("T", shortest(T), "is no time since the start", "give a number of 0 or more");
}

}  // namespace turgor
