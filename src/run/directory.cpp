#include "turgor/run/directory.hpp"

#include <fstream>

#include "turgor/base/errors.hpp"
#include "turgor/run/report.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

InvalidInput unusable(const fs::path& path, std::string problem, std::string advice) {
  return InvalidInput("", "", "run directory " + path.string() + ": " + std::move(problem), std::move(advice));
}

void remove_earlier_run(const fs::path& folder) {
  std::error_code ignored;
  for (const char* table : {"case.toml", "resolved.toml", "run.json", "trajectory.csv", "dimensionless.csv",
                            "events.csv", "force.json", "force.csv"}) {
    fs::remove(folder / table, ignored);
    fs::remove(folder / (std::string(table) + ".part"), ignored);
  }
  for (const char* picture : {"history", "portrait", "force"}) {
    for (const char* ending : {".svg", ".png", ".gp", ".log"})
      fs::remove(folder / (std::string(picture) + ending), ignored);
  }
}

}  // namespace

RunDirectory::RunDirectory(fs::path path, const Case& c, bool force) : path_(std::move(path)) {
  std::error_code error;
  if (fs::exists(path_, error)) {
    if (!fs::is_directory(path_, error)) throw unusable(path_, "is a file", "choose another name with -o DIR");
    if (!force) throw unusable(path_, "exists already", "choose another with -o DIR, or replace it with --force");
    remove_earlier_run(path_);
  } else if (!fs::create_directories(path_, error) || error) {
    throw unusable(path_, "cannot be created (" + error.message() + ")", "choose a place you may write to with -o DIR");
  }
  try {
    write_file(c.motion ? "force.json" : "run.json", "{ \"status\": \"running\" }\n");
    write_file("case.toml", c.source);
    write_file("resolved.toml", c.resolved);
  } catch (const ComputationFailed&) {
    throw unusable(path_, "cannot be written to", "choose a place you may write to with -o DIR");
  }
}

void RunDirectory::write(const Case& c, const RunResult& result) {
  write_file("resolved.toml", resolved_with(c, result.choice.model));
  write_file("trajectory.csv", trajectory_csv(c, result));
  write_file("dimensionless.csv", dimensionless_csv(c, result));
  write_file("events.csv", events_csv(c, result));
  write_file("run.json", run_json(c, result));
}

void RunDirectory::write(const Case& c, const ForceHistory& history) {
  write_file("force.csv", force_csv(c));
  write_file("force.json", force_json(c, history));
}

/// Writes beside and renames, so that a file is either the old one or the whole new one.
void RunDirectory::write_file(const std::string& name, const std::string& text) const {
  const fs::path partial = path_ / (name + ".part");
  {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.flush();
    if (!stream) throw ComputationFailed("cannot write " + partial.string() + ": is the disk full?");
  }
  std::error_code error;
  fs::rename(partial, path_ / name, error);
  if (error) throw ComputationFailed("cannot write " + (path_ / name).string() + ": " + error.message());
}

}  // namespace turgor
