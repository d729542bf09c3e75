#pragma once
// The forces that `turgor fem flow` has computed for a case.

#include <filesystem>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// A row of its history.csv, as far as forces go.
struct FemForces {
  double time;        ///< [s]
  double force;       ///< integral of the gauge pressure over the wall [N]
  double force_mode;  ///< work of the liquid on the moving wall per dr [N]
};

struct FemHistory {
  std::string status;           ///< of the run; "running" also when it was killed
  std::string report;           ///< its run.json
  std::vector<FemForces> rows;  ///< at least one, in order of time
  std::vector<Warning> warnings;
};

/// Reads the run directory of a case as far as the run has come.
/// @throws InvalidInput when it is none, or of another case, naming the first key that differs ([model], [output],
/// [scales], [fem] and the rows asked for may); when a row is no number or does not follow the case's motion
[[nodiscard]] FemHistory read_fem_history(const Case& c, const std::filesystem::path& folder);

}  // namespace turgor
