#pragma once
// What `turgor fem` has computed for a case.

#include <filesystem>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// A row of history.csv of `turgor fem flow`, as far as forces go.
struct FemForces {
  double time;        ///< [s]
  double force;       ///< integral of the gauge pressure over the wall [N]
  double force_mode;  ///< work of the liquid on the moving wall per dr [N]
};

/// A row of history.csv of `turgor fem fsi`, as far as the model has the like.
struct FemRadius {
  double time;            ///< [s]
  double gauge_pressure;  ///< at the inlet [Pa]
  double radius;          ///< r_eff = sqrt(S/pi + r_ch^2)/2 of the wall's area S, section 2.5 of the paper [m]
  double rate;            ///< [m/s]
  double volume;          ///< of the balloon [m^3]
  double elastic;         ///< energy of the wall [J]
};

/// A run directory.
template <class Row>
struct FemRun {
  std::string status;     ///< of the run; "running" also when it was killed
  std::string report;     ///< its run.json
  std::vector<Row> rows;  ///< at least one, in order of time
  std::vector<Warning> warnings;
};
using FemHistory = FemRun<FemForces>;
using FemResponse = FemRun<FemRadius>;

/// Reads the run directory of a case of dictated motion as far as the run has come.
/// @throws InvalidInput when it is none, or of another case, naming the first key that differs ([model], [output],
/// [scales], [fem], [wall], [expect] and the rows asked for may); when a row is no number or does not follow the case's
/// motion
[[nodiscard]] FemHistory read_fem_history(const Case& c, const std::filesystem::path& folder);

/// Reads the run directory of an elastic balloon as far as the run has come.
/// @throws InvalidInput when it is none, or of another case ([model], [output], [scales], [fem], [expect] and the rows
/// asked for may differ); when a row is no number or does not have the pressure of the case's program
[[nodiscard]] FemResponse read_fem_response(const Case& c, const std::filesystem::path& folder);

}  // namespace turgor
