#pragma once
// The state of a flow solver in a checkpoint.

#include <string>

#include "turgor/fem/checkpoint.hpp"
#include "turgor/fem/energy_account.hpp"
#include "turgor/fem/flow_solver.hpp"
#include "turgor/fem/step_control.hpp"

namespace turgor {

/// Makes the solver forget its factors, so that going on and starting again give the same bits.
void save_flow(FlowSolver& solver, const StepControl& control, const EnergyAccount& energies, Checkpoint& checkpoint);

/// @throws ComputationFailed when arrays are missing or of another size
void load_flow(const Checkpoint& checkpoint, FlowSolver& solver, StepControl& control, EnergyAccount& energies);

}  // namespace turgor
