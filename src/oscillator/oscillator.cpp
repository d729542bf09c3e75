#include "turgor/oscillator/oscillator.hpp"

#include <algorithm>
#include <cmath>

namespace turgor {

std::string_view name_of(Model model) {
  switch (model) {
    case Model::full: return "full";
    case Model::orifice: return "orifice";
    case Model::long_channel: return "long-channel";
  }
  return "";
}

std::string_view equation_of(Model model) {
  switch (model) {
    case Model::full: return "(2.22)";
    case Model::orifice: return "(2.23)";
    case Model::long_channel: return "(2.25)";
  }
  return "";
}

std::string_view name_of(Closure closure) {
  switch (closure) {
    case Closure::theoretical: return "theoretical";
    case Closure::corrected: return "corrected";
    case Closure::potential: return "potential";
    case Closure::profile: return "profile";
    case Closure::calibrated: return "calibrated";
  }
  return "";
}

Scales<double> natural_scales(const Parameters<double>& p, const PressureProgram<double>& program, double t_end) {
  const double stiffness = p.thickness * strain_energy(p.material, 1.0).second / p.radius;  // dE/dR at R = 1 [Pa]
  const PressureRange<double> range = range_of(program, t_end);
  const double greatest = std::max(std::abs(range.least), std::abs(range.greatest));
  Scales<double> scales{p.radius, greatest > 0 ? greatest : stiffness, 1.0};
  const Groups<double> g = groups(p, scales);
  const double channel = g.b * closure_factors(p, force_table(p), 1.0).channel.inertial;
  const double mass = (g.a0 + channel + g.m) / g.K;  // M_- of (2.22) at R = 1
  scales.time = std::sqrt(mass * scales.pressure / stiffness);
  return scales;
}

}  // namespace turgor
