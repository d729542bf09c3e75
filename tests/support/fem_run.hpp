#pragma once
// Run directories of `turgor fem flow` whose forces are made up.

#include <functional>

#include "program.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/case.hpp"
#include "turgor/run/report.hpp"

namespace turgor::test {

struct MadeUpForces {
  double force;
  double force_mode;
};

/// How a made-up run is written.
struct MadeUpRun {
  std::string status = "complete";
  double end = 1e300;  ///< rows up to this time [s]
  std::string time_unit = "s";
  double seconds = 1;  ///< in it
  std::string length_unit = "m";
  double metres = 1;
};

/// Writes resolved.toml, run.json and a history.csv with a row for each requested time, its columns in another order
/// than `turgor fem flow` writes them.
inline void write_fem_run(const std::filesystem::path& folder, const Case& c,
                          const std::function<MadeUpForces(double t)>& forces, const MadeUpRun& run = {}) {
  std::filesystem::create_directories(folder);
  write(folder / "resolved.toml", c.resolved);
  write(folder / "run.json", "{\"status\": \"" + run.status + "\", \"message\": \"why\", \"steps\": 7}");
  std::string text = "force_mode [N],t [" + run.time_unit + "],kinetic [J],r [" + run.length_unit + "],force [N]\n";
  for (const double t : requested_times(c.solve)) {
    if (t > run.end) break;
    const MadeUpForces at = forces(t);
    text += shortest(at.force_mode) + "," + shortest(t / run.seconds) + ",-," +
            shortest(dictated_motion(c).at(t).radius / run.metres) + "," + shortest(at.force) + "\n";
  }
  write(folder / "history.csv", text);
}

}  // namespace turgor::test
