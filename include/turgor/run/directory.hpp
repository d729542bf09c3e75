#pragma once
// The folder a run or a force history leaves behind.

#include <filesystem>

#include "turgor/run/force_history.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// A run directory. While the work is under way run.json, or force.json of a dictated motion, says "running", so that a
/// folder left by a killed process never passes as complete.
class RunDirectory {
 public:
  /// Creates the folder and writes case.toml and resolved.toml.
  /// @param force  replace an earlier run in an existing folder; only files that turgor writes are touched
  /// @throws InvalidInput when the folder exists (without force), is not a folder, or cannot be written
  RunDirectory(std::filesystem::path path, const Case& c, bool force);

  /// Writes the tables and, last and in one move, run.json.
  /// @throws ComputationFailed when a file cannot be written
  void write(const Case& c, const RunResult& result);
  /// The same for a force history: its table, and last force.json.
  void write(const Case& c, const ForceHistory& history);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  ResultFolder folder_;
};

}  // namespace turgor
