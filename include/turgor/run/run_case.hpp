#pragma once
// One case from start to finish: oscillator, trajectory, energies, quantities of interest, warnings.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/ensemble/ensemble.hpp"
#include "turgor/integrate/simulate.hpp"
#include "turgor/oscillator/selection.hpp"
#include "turgor/run/energy.hpp"

namespace turgor {

/// A quantity of interest in SI units; nothing when the run does not have it (no fall without a fall).
struct Quantity {
  std::string name;
  std::string unit;
  std::optional<double> value;
};

/// What `name = "auto"` found, or what an explicitly chosen model leaves out.
struct ModelChoice {
  Model model;
  bool automatic;
  double least_stretch;  ///< the range over which terms were compared
  double greatest_stretch;
  std::vector<std::pair<Model, std::vector<DroppedTerm>>> dropped;  ///< for each simpler model that was considered
};

/// An assumption of the model that this run strains, with the numbers.
struct Warning {
  std::string name;  ///< "thin-wall", "reynolds", ...
  std::string text;
};

struct ExpectationResult {
  Expectation expected;
  std::optional<double> found;
  bool met;
};

/// The result of a run. Times and rates in the trajectory are dimensionless on the oscillator's scales.
struct RunResult {
  std::unique_ptr<Oscillator<double>> oscillator;
  ModelChoice choice;
  std::unique_ptr<Trajectory<double>> trajectory;
  std::unique_ptr<EnergyLedger> energies;  ///< refers to the two above
  std::vector<Quantity> quantities;
  std::vector<Warning> warnings;
  std::vector<ExpectationResult> expectations;
  double integration_seconds = 0;

  /// "complete", "failed" or "interrupted".
  [[nodiscard]] std::string status() const;
  [[nodiscard]] bool expectations_met() const;
  /// The value of a quantity of interest by name.
  [[nodiscard]] std::optional<double> quantity(std::string_view name) const;
};

/// Called now and then with the simulated time reached [s]; returning false ends the run as interrupted.
using Progress = std::function<bool(double)>;

/// Runs a case. Trouble during integration is reported in the trajectory's outcome, not thrown.
[[nodiscard]] RunResult run_case(const Case& c, const Progress& progress = {});

/// The motion alone: the oscillator, the trajectory and the choice of the model; nothing else of the result is there.
[[nodiscard]] RunResult run_motion(const Case& c, const Progress& progress = {});

/// The result of an earlier run from what cannot be computed again without integrating: the rest follows.
/// @param choice  model, automatic and the range of stretches
[[nodiscard]] RunResult restored_run(const Case& c, const ModelChoice& choice, Trajectory<double> trajectory,
                                     double integration_seconds);

/// What a summary has to hold so that these quantities can be had.
/// @param asked  indices in quantity_names()
[[nodiscard]] SummaryOptions needed_for(std::span<const std::size_t> asked);

/// A motion or a whole run, summed up; its steps stay in the trajectory.
[[nodiscard]] MemberSummary summary_of(const RunResult& result, const SummaryOptions& options);

/// Quantities of interest in SI units; nothing where the run does not have one.
/// @param summary  with what needed_for(asked) says
/// @param steps    of the trajectory, if needed_for(asked) says so
/// @param asked    indices in quantity_names(); only what these need is computed
[[nodiscard]] std::vector<std::optional<double>> evaluate_quantities(const Oscillator<double>& oscillator,
                                                                     const MemberSummary& summary,
                                                                     std::span<const TrajectoryStep<double>> steps,
                                                                     std::span<const std::size_t> asked);

/// The question a case asks of its oscillator.
[[nodiscard]] Member make_member(const Case& c, Model model);

/// The oscillator of a case with a given model, on natural scales: the case's own scales only shape reports, so that
/// they cannot change what the integrator does.
[[nodiscard]] Oscillator<double> make_oscillator(const Case& c, Model model);

/// State of the balloon in SI units at one time.
struct PhysicalState {
  double time;            ///< [s]
  double stretch;         ///< [1]
  double stretch_rate;    ///< [1/s]
  double radius;          ///< [m]
  double gauge_pressure;  ///< at the inlet [Pa]
  Regime regime;
  double volume;     ///< of liquid in the balloon, the cap inside the channel left out [m^3]
  double flow_rate;  ///< into the balloon, eq. (2.1) [m^3/s]
};
/// @param time  dimensionless, within the trajectory
[[nodiscard]] PhysicalState physical_state(const Oscillator<double>& oscillator, const Trajectory<double>& trajectory,
                                           double time);

}  // namespace turgor
