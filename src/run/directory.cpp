#include "turgor/run/directory.hpp"

#include "turgor/run/report.hpp"

namespace turgor {

RunDirectory::RunDirectory(std::filesystem::path path, const Case& c, bool force)
    : folder_(std::move(path),
              {"run directory",
               {"case.toml", "resolved.toml", "run.json", "trajectory.csv", "dimensionless.csv", "events.csv",
                "force.json", "force.csv"},
               {"history", "portrait", "force"}},
              force) {
  folder_.write_first(c.motion ? "force.json" : "run.json", "{ \"status\": \"running\" }\n");
  folder_.write_first("case.toml", c.source);
  folder_.write_first("resolved.toml", c.resolved);
}

void RunDirectory::write(const Case& c, const RunResult& result) {
  folder_.write("resolved.toml", resolved_with(c, result.choice.model));
  folder_.write("trajectory.csv", trajectory_csv(c, result));
  folder_.write("dimensionless.csv", dimensionless_csv(c, result));
  folder_.write("events.csv", events_csv(c, result));
  folder_.write("run.json", run_json(c, result));
}

void RunDirectory::write(const Case& c, const ForceHistory& history) {
  folder_.write("force.csv", force_csv(c));
  folder_.write("force.json", force_json(c, history));
}

}  // namespace turgor
