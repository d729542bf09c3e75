// Reads a case file, integrates it and prints where the balloon is at half time; then a balloon made in code.

#include <iostream>

#include "turgor/case/case.hpp"
#include "turgor/integrate/simulate.hpp"

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const turgor::Case c = turgor::read_case(argv[1]);
  const turgor::Oscillator<double> oscillator(turgor::Model::full, c.parameters, c.pressure, c.scales);
  const double end = c.solve.t_end / c.scales.time;
  const auto trajectory = turgor::simulate(oscillator, 0.0, c.stretch, c.stretch_rate * c.scales.time, end, {});
  std::cout << "R = " << trajectory.at(end / 2).stretch << " after " << trajectory.events.size() << " events\n";

  turgor::Parameters<double> water_balloon{
      .radius = 0.05,
      .thickness = 0.0005,
      .solid_density = 950,
      .fluid_density = 1000,
      .fluid_viscosity = 1e-3,
      .orifice_radius = 0.005,
      .channel_length = 0.1,
      .material = turgor::Gent<double>{.mu = 4e5, .jm = 30},
  };
  const auto pressure = turgor::constant_pressure(3e3);
  const auto scales = turgor::natural_scales(water_balloon, pressure, 10.0);
  const turgor::Oscillator<double> other(turgor::Model::full, water_balloon, pressure, scales);
  std::cout << "R = " << turgor::simulate(other, 0.0, 1.0, 0.0, 10.0, {}).last.stretch << "\n";
}
