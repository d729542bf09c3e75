#include "turgor/statics/energy.hpp"

#include <cmath>
#include <numbers>

#include "turgor/statics/statics.hpp"

namespace turgor {

double working_volume(const Parameters<double>& p, double R) {
  const double cube = 2 * std::numbers::pi / 3 * power<3>(p.radius * R);
  if (!has_table(p.closure)) return 2 * cube;
  const double kappa = kappa_at(p, R);
  const double rho = std::sqrt((1 - kappa) * (1 + kappa));
  return cube * (1 + power<3>(rho));
}

double strain_energy_of(const Parameters<double>& p, double R) {
  return 4 * std::numbers::pi * p.radius * p.radius * p.thickness * strain_energy(p.material, R).value;
}

double potential_energy(const Parameters<double>& p, double R, double pressure) {
  return strain_energy_of(p, R) - pressure * working_volume(p, R);
}

std::vector<Well> wells(const Parameters<double>& p, double pressure) {
  const std::vector<Equilibrium> states = equilibria(p, pressure);
  const auto energy = [&](std::size_t i) { return potential_energy(p, states[i].stretch, pressure); };
  std::vector<Well> found;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!states[i].stable) continue;
    Well well{states[i].stretch, energy(i), {}, {}};
    if (i > 0 && !states[i - 1].stable) well.barrier_below = energy(i - 1) - well.energy;
    if (i + 1 < states.size() && !states[i + 1].stable) well.barrier_above = energy(i + 1) - well.energy;
    found.push_back(well);
  }
  return found;
}

}  // namespace turgor
