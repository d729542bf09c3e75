#pragma once
// The folder a run leaves behind.

#include <filesystem>
#include <vector>

#include "turgor/run/run_case.hpp"

namespace turgor {

/// A run directory. While a run is under way its run.json says "running", so that a folder left by a killed process
/// never passes as complete.
class RunDirectory {
 public:
  /// Creates the folder and writes case.toml and resolved.toml.
  /// @param force  replace an earlier run in an existing folder; only files that runs write are touched
  /// @throws InvalidInput when the folder exists (without force), is not a folder, or cannot be written
  RunDirectory(std::filesystem::path path, const Case& c, bool force);

  /// Writes the tables and, last and in one move, run.json.
  /// @throws ComputationFailed when a file cannot be written
  void write(const Case& c, const RunResult& result);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void write_file(const std::string& name, const std::string& text) const;

  std::filesystem::path path_;
};

}  // namespace turgor
