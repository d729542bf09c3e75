#pragma once
// The folder that `turgor fem flow` leaves behind, and goes on with.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "turgor/fem/checkpoint.hpp"
#include "turgor/fem/flow_problem.hpp"
#include "turgor/fem/flow_tables.hpp"
#include "turgor/run/result_folder.hpp"

namespace turgor {

class TableFile;

/// What to do about an earlier run in the same folder.
enum class EarlierRun { refuse, replace, resume };

/// The folder of a run: tables that grow row by row, fields, checkpoints, and run.json, which says "running" until the
/// end. What was handed over is on disk when the call returns; a checkpoint knows how much of it belongs to it, and a
/// run that is resumed cuts off the rest.
class FlowRunFolder {
 public:
  /// Creates the folder and writes case.toml and resolved.toml, or opens it at its newest checkpoint that can be read.
  /// @throws InvalidInput when it exists and should not, or the other way round; when it belongs to another case,
  /// naming what differs; when its run is complete or still under way; when it cannot be written
  FlowRunFolder(std::filesystem::path path, const Case& c, EarlierRun earlier);
  ~FlowRunFolder();
  FlowRunFolder(const FlowRunFolder&) = delete;
  FlowRunFolder& operator=(const FlowRunFolder&) = delete;
  FlowRunFolder(FlowRunFolder&&) = delete;
  FlowRunFolder& operator=(FlowRunFolder&&) = delete;

  /// Where to go on; nothing at the beginning of a run.
  [[nodiscard]] const std::optional<Checkpoint>& start() const { return start_; }
  /// What was wrong with the newest checkpoint; empty when nothing was.
  [[nodiscard]] const std::string& warning() const { return warning_; }

  // All throw ComputationFailed when a file cannot be written, or a number is not finite.
  void append(const FlowRow& row);
  void append(const SolverRow& row);
  /// Writes fields/flow-NNNNN.vtu and enters it into fields.pvd.
  /// @return "flow-NNNNN"
  std::string add_field(double time, const VtuGrid& field);
  /// Writes profile.csv, which `turgor profile` and `model.profile` read.
  void write_profile(const std::vector<OutflowPoint>& points);
  /// Completes what the solver has put into it, and keeps it.
  void save(Checkpoint checkpoint);
  /// Writes run.json, the last of all; a complete run needs its checkpoints no more.
  void finish(const std::string& run_json, bool complete);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  void begin(const Case& c);
  void resume(const Case& c);
  void open_tables(const Case& c);
  void write_series() const;
  void remove_fields_from(std::uint64_t first) const;

  ResultFolder folder_;
  CheckpointFiles checkpoints_;
  OutputSettings output_;
  HistoryKind kind_;
  std::uint64_t case_hash_;
  std::optional<Checkpoint> start_;
  std::string warning_;
  std::unique_ptr<TableFile> history_;
  std::unique_ptr<TableFile> solver_;
  std::vector<VtuInstant> series_;
};

}  // namespace turgor
