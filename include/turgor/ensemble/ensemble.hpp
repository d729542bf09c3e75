#pragma once
// Many balloons at once: SIMD lanes, each with a balloon of its own on its own clock, refilled as they finish.

#include <span>
#include <string_view>

#include "turgor/integrate/simulate.hpp"

namespace turgor {

/// One balloon of an ensemble, as simulate() takes it, from time 0 on. keep_going is not called.
struct Member {
  Oscillator<double> oscillator;
  double stretch;
  double rate;
  double end_time;
  SimulationOptions<double> options;
};

/// What is wanted beyond the states at the ends and the events' count: each costs time.
struct SummaryOptions {
  bool energies = false;   ///< work, dissipation and the error of their balance
  bool flow = false;       ///< greatest flow
  bool steps = false;      ///< keep R(T) of every step: a hundred bytes each
  std::size_t events = 0;  ///< keep that many first events
};

/// What remains of a trajectory: dimensionless, on the oscillator's scales.
struct MemberSummary {
  Outcome outcome = Outcome::reached_end;
  std::string message;
  double initial_stretch = 0;
  Point<double> last{};
  double least_stretch = 0;
  double greatest_stretch = 0;
  double peak_time = 0;  ///< of the greatest stretch, the earliest of equals
  long events = 0;
  double first_event_time = 0;  ///< only if there was an event
  double inlet_work = 0;        ///< with SummaryOptions::energies
  double dissipated = 0;
  double energy_error = 0;   ///< as EnergyLedger::closure_error()
  double greatest_flow = 0;  ///< greatest |dR/dT| (2 - eps)/(eps (1 - eps)) of (2.1), with SummaryOptions::flow
  std::vector<RegimeEvent<double>> first_events;
  std::vector<TrajectoryStep<double>> steps;  ///< only R of them
};

/// Which instructions to use; results of different ones agree within the tolerance, those of the same one to the bit.
enum class InstructionSet {
  scalar,
  avx2,    ///< with FMA: 4 lanes
  avx512,  ///< F, CD, BW, DQ, VL: 8 lanes
};
[[nodiscard]] std::string_view name_of(InstructionSet set);
/// The widest that this machine has.
[[nodiscard]] InstructionSet best_instruction_set();

/// Integrates all members on the calling thread. A member's summary depends on that member and the instruction set
/// alone, not on its companions.
/// @param summaries  one for each member
/// @param set        must be one that this machine has
/// @throws InvalidInput as simulate(), for the first member that cannot start
void integrate_ensemble(std::span<const Member> members, const SummaryOptions& options,
                        std::span<MemberSummary> summaries, InstructionSet set = best_instruction_set());

}  // namespace turgor
