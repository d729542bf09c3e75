#pragma once
// A parameter study from start to finish.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/sweep/plan.hpp"

namespace turgor {

class Ranks;

/// How far a sweep is, in members.
struct SweepProgress {
  std::uint64_t done;      ///< of all
  std::uint64_t computed;  ///< by this process and its fellow ranks; the rest was there before
  std::uint64_t all;
};

struct SweepOptions {
  std::filesystem::path output;
  bool resume = false;  ///< go on from the journal that an unfinished sweep has left
  bool force = false;   ///< replace a result, or begin anew in spite of a journal
  int threads = 0;      ///< 0: one for each core
  /// Called after each finished chunk, never by two threads at once; returning false ends the sweep after the chunks
  /// that are under way.
  std::function<bool(const SweepProgress&)> progress{};
};

/// One number of all members that have it.
struct QuantitySummary {
  std::string name;
  std::string unit;
  std::uint64_t count = 0;  ///< members that have it
  double least = 0;
  double mean = 0;
  double greatest = 0;
};

/// Some members, for pictures: all of them where a picture can show as many.
struct SweepSample {
  std::vector<std::uint64_t> members;       ///< increasing
  std::vector<std::vector<double>> values;  ///< for each asked quantity, one number per member in the sample
};

struct SweepSummary {
  std::uint64_t members = 0;
  std::uint64_t failed = 0;
  std::vector<std::pair<std::string, std::uint64_t>> failures;  ///< reasons, in order of the first member that has each
  std::vector<QuantitySummary> quantities;
  SweepSample sample;
};

struct SweepResult {
  bool complete = false;  ///< false: interrupted, what was finished is kept
  SweepProgress progress{};
  double seconds = 0;    ///< of computing
  SweepSummary summary;  ///< when complete
};

/// Runs the members of a case's sweep and writes one NetCDF-4 file. While it is under way, finished members are kept in
/// OUTPUT.part, from which `resume` goes on; the file is the same to the last bit however often that happens, and for
/// any number of threads and ranks.
/// @param ranks  fellow processes; all call this, and rank 0 alone gets a result
/// @throws InvalidInput when the case has no sweep, or output, resume and force do not fit what is there
/// @throws ComputationFailed when a file cannot be written; what was finished is kept
[[nodiscard]] SweepResult run_sweep(const Case& c, const SweepOptions& options, Ranks* ranks = nullptr);

}  // namespace turgor
