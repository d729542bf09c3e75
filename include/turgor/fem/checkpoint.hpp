#pragma once
// The state of a computation as a file, from which it goes on.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace turgor {

/// A state, and how much had been written when it was reached.
struct Checkpoint {
  std::uint64_t case_hash = 0;      ///< of the resolved case
  std::uint64_t history_rows = 0;   ///< in history.csv
  std::uint64_t solver_rows = 0;    ///< in solver.csv
  long step = 0;                    ///< steps done
  double time = 0;                  ///< reached [s]
  double wall_seconds = 0;          ///< spent so far
  std::vector<double> field_times;  ///< [s], of the files in fields/
  std::vector<double> times;        ///< [s], of the levels that `arrays` hold; the solver's own order
  std::map<std::string, std::vector<double>> arrays;
};

/// An array of a checkpoint.
/// @throws ComputationFailed when it is missing or of another size
[[nodiscard]] const std::vector<double>& array_of(const Checkpoint& checkpoint, const std::string& name,
                                                  std::size_t size);

/// A text's fingerprint: its CRC-64.
[[nodiscard]] std::uint64_t fingerprint(const std::string& text);

/// Magic, version, everything, and a CRC-64 of it; numbers as they are in memory.
/// @throws ComputationFailed naming the array, when a number is not finite
[[nodiscard]] std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// @throws ComputationFailed with the reason when the bytes are no whole checkpoint
[[nodiscard]] Checkpoint parse_checkpoint(const std::string& bytes);

/// The last two checkpoints in a folder: checkpoint.bin, and before that checkpoint.previous.bin.
class CheckpointFiles {
 public:
  explicit CheckpointFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes beside, syncs and renames: whenever the process or the machine stops, a whole checkpoint is there.
  /// @throws ComputationFailed when it cannot be written, or a number is not finite
  void save(const Checkpoint& checkpoint) const;

  struct Loaded {
    Checkpoint checkpoint;
    std::string warning;  ///< that the newest one cannot be read; empty otherwise
  };
  /// The newest one that is whole.
  /// @throws InvalidInput when there is none, with what is wrong with those that are there
  [[nodiscard]] Loaded load() const;

  /// Removes them: there is nothing to go on with.
  void remove() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace turgor
