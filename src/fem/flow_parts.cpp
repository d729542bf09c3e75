#include "flow_parts.hpp"

#include <numbers>
#include <string>

namespace turgor {

BalloonMesh mesh_of(const Case& c, double radius) {
  return balloon_mesh({.orifice_radius = c.parameters.orifice_radius,
                       .channel_length = c.parameters.channel_length,
                       .radius = radius,
                       .rim = c.fem.h_rim,
                       .orifice = c.fem.h_orifice,
                       .wall = c.fem.h_wall});
}

FlowDefinition liquid_of(const Case& c) {
  FlowDefinition flow;
  flow.density = c.parameters.fluid_density;
  flow.viscosity = c.parameters.fluid_viscosity;
  flow.slip = c.inlet.slip;
  flow.tangential_zero = !c.inlet.tangential_free;
  flow.total_pressure = c.inlet.total_pressure;
  flow.inflow_penalty = c.inlet.inflow_penalty;
  flow.inlet_pressure = [&c](double t) { return c.pressure(t); };
  return flow;
}

FlowSize size_of(const FlowSpace& space) {
  return {static_cast<long>(space.cells().size()), static_cast<long>(space.size())};
}

double channel_volume(const Case& c) {
  const double a = c.parameters.orifice_radius;
  return std::numbers::pi * a * a * c.parameters.channel_length;
}

FlowRow row_of(const Case& c, double time, const FlowBalance& b, const EnergyAccount& energies) {
  FlowRow row{};
  row.time = time;
  row.gauge_pressure = c.pressure(time);
  row.force = b.force;
  row.flow_rate = b.inflow;
  row.volume = b.volume - channel_volume(c);
  row.area = b.area;
  row.kinetic = b.kinetic_energy;
  row.viscous_power = energies.power(EnergyAccount::viscous);
  row.viscous_work = energies.work(EnergyAccount::viscous);
  row.stabilisation_power = energies.power(EnergyAccount::stabilisation);
  row.stabilisation_work = energies.work(EnergyAccount::stabilisation);
  row.inlet_power = energies.power(EnergyAccount::inlet);
  row.inlet_work = energies.work(EnergyAccount::inlet);
  row.wall_power = energies.power(EnergyAccount::wall);
  row.wall_work = energies.work(EnergyAccount::wall);
  row.damping_power = energies.power(EnergyAccount::damping);
  row.damping_work = energies.work(EnergyAccount::damping);
  return row;
}

std::vector<Warning> factorisation_warnings(const FlowSolver& solver) {
  const long failures = solver.linear_solver().failures();
  if (failures == 0) return {};
  return {{"factorisation", "MUMPS failed to factorise " + std::to_string(failures) + " times; UMFPACK took over"}};
}

}  // namespace turgor
