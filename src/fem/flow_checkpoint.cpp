#include "turgor/fem/flow_checkpoint.hpp"

#include "turgor/base/errors.hpp"

namespace turgor {

namespace {

constexpr const char* reduction_name = "reduced step";
constexpr const char* energies_name = "powers and works";

std::string numbered(const char* name, std::size_t i) { return std::string(name) + " " + std::to_string(i); }

}  // namespace

void save_flow(FlowSolver& solver, const StepControl& control, const EnergyAccount& energies, Checkpoint& checkpoint) {
  solver.forget_factors();
  checkpoint.times.clear();
  for (std::size_t i = 0; i < solver.levels().size(); ++i) {
    const FlowLevel& level = solver.levels()[i];
    checkpoint.times.push_back(level.time);
    checkpoint.arrays[numbered("level", i)] = level.unknowns;
    if (!solver.definition().wall) continue;
    checkpoint.arrays[numbered("places", i)] = level.positions;
    checkpoint.arrays[numbered("mesh velocities", i)] = level.mesh_velocities;
  }
  checkpoint.arrays[reduction_name] = {control.reduction()};
  checkpoint.arrays[energies_name] = energies.state();
}

void load_flow(const Checkpoint& checkpoint, FlowSolver& solver, StepControl& control, EnergyAccount& energies) {
  const auto unknowns = static_cast<std::size_t>(solver.space().size());
  const std::size_t places = 2 * solver.space().nodes().size();
  std::vector<FlowLevel> levels;
  for (std::size_t i = 0; i < checkpoint.times.size(); ++i) {
    FlowLevel level{checkpoint.times[i], array_of(checkpoint, numbered("level", i), unknowns)};
    if (solver.definition().wall) {
      level.positions = array_of(checkpoint, numbered("places", i), places);
      level.mesh_velocities = array_of(checkpoint, numbered("mesh velocities", i), places);
    }
    levels.push_back(std::move(level));
  }
  if (levels.size() < 2) throw ComputationFailed("the checkpoint has too few time levels");
  solver.start(std::move(levels));
  control.restore(checkpoint.step, array_of(checkpoint, reduction_name, 1)[0]);
  energies.restore(array_of(checkpoint, energies_name, EnergyAccount::numbers));
}

}  // namespace turgor
