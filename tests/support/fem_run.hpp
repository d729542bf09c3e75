#pragma once
// Run directories of `turgor fem` whose results are made up.

#include <functional>

#include "program.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/case.hpp"
#include "turgor/run/membrane_study.hpp"
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

/// Writes what both kinds of run directories have, around the rows of a table.
inline void write_run(const std::filesystem::path& folder, const Case& c, const MadeUpRun& run,
                      const std::string& header, const std::function<std::string(double t)>& row) {
  std::filesystem::create_directories(folder);
  write(folder / "resolved.toml", c.resolved);
  write(folder / "run.json", "{\"status\": \"" + run.status + "\", \"message\": \"why\", \"steps\": 7}");
  std::string text = header;
  for (const double t : requested_times(c.solve)) {
    if (t <= run.end) text += row(t);
  }
  write(folder / "history.csv", text);
}

/// Writes resolved.toml, run.json and a history.csv with a row for each requested time, its columns in another order
/// than `turgor fem flow` writes them.
inline void write_fem_run(const std::filesystem::path& folder, const Case& c,
                          const std::function<MadeUpForces(double t)>& forces, const MadeUpRun& run = {}) {
  const std::string header =
      "force_mode [N],t [" + run.time_unit + "],kinetic [J],r [" + run.length_unit + "],force [N]\n";
  write_run(folder, c, run, header, [&](double t) {
    const MadeUpForces at = forces(t);
    return shortest(at.force_mode) + "," + shortest(t / run.seconds) + ",-," +
           shortest(dictated_motion(c).at(t).radius / run.metres) + "," + shortest(at.force) + "\n";
  });
}

/// The same of an elastic balloon, as `turgor fem fsi` has them, with a given effective radius [m]; its volume is that
/// of the sphere, its elastic energy 7 J.
inline void write_fsi_run(const std::filesystem::path& folder, const Case& c,
                          const std::function<double(double t)>& radius, const MadeUpRun& run = {}) {
  const std::string header = "p_gauge [kPa],t [" + run.time_unit + "],kinetic [J],r_eff [" + run.length_unit +
                             "],dr_effdt [" + run.length_unit + "/" + run.time_unit + "],volume [m^3],elastic [J]\n";
  write_run(folder, c, run, header, [&](double t) {
    return shortest(c.pressure(t) / 1000) + "," + shortest(t / run.seconds) + ",-," + shortest(radius(t) / run.metres) +
           ",0.5," + shortest(balloon_volume(c.parameters, radius(t) / c.parameters.radius)) + ",7\n";
  });
}

}  // namespace turgor::test
