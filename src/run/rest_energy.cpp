#include "turgor/run/rest_energy.hpp"

#include <algorithm>
#include <numbers>

#include "turgor/run/membrane_study.hpp"

namespace turgor {

RestEnergy::RestEnergy(const Case& c, double volume) {
  const Membrane membrane = membrane_of(c);
  const MembraneState slack = slack_state(membrane);
  const auto add = [&](const MembraneState& state) {
    volumes_.push_back(state.volume);
    energies_.push_back(2 * std::numbers::pi * membrane.elastic(state.places).value);
    pressures_.push_back(state.pressure);
  };
  constexpr double more = 1.001;  // so that a balloon that hardly moves has a curve too
  const double end = std::max(volume, more * slack.volume);
  for (const MembraneState& state : inflation_curve(membrane, slack, end).states) add(state);
}

double RestEnergy::operator()(double volume) const {
  const auto after = std::ranges::upper_bound(volumes_, volume);
  if (after == volumes_.begin()) return 0;
  if (after == volumes_.end()) return energies_.back();
  const auto i = static_cast<std::size_t>(after - volumes_.begin());
  const double h = volumes_[i] - volumes_[i - 1];
  const double s = (volume - volumes_[i - 1]) / h;
  const double rest = 1 - s;
  return rest * rest * ((1 + 2 * s) * energies_[i - 1] + s * h * pressures_[i - 1]) +
         s * s * ((1 + 2 * rest) * energies_[i] - rest * h * pressures_[i]);
}

}  // namespace turgor
