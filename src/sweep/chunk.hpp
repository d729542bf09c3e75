#pragma once
// Members are computed, stored and sent in chunks of fixed size, whatever the number of threads and ranks.

#include <cstdint>
#include <string>
#include <vector>

#include "turgor/case/case_template.hpp"
#include "turgor/sweep/members.hpp"
#include "turgor/sweep/plan.hpp"

namespace turgor {

inline constexpr std::uint64_t chunk_size = 256;

/// Stands for an outcome where the values of a member do not make a case.
inline constexpr int invalid_member = -1;

/// The results of consecutive members as rows of numbers.
struct ChunkResult {
  /// Columns of a row: outcome, model (-1: none), 1 + index of the message (0: none), quantities, times of events,
  /// stretches of events.
  static constexpr std::size_t leading_columns = 3;

  std::size_t width = 0;
  std::vector<double> rows;
  std::vector<std::string> messages;

  [[nodiscard]] std::size_t size() const { return rows.size() / width; }
  [[nodiscard]] const double* row(std::size_t i) const { return rows.data() + i * width; }

  /// As bytes, for a file or another process of the same machine type.
  [[nodiscard]] std::string encode() const;
  /// @throws ComputationFailed when the bytes are not what encode() wrote
  [[nodiscard]] static ChunkResult decode(const std::string& bytes);
};

/// Makes and runs the members of one sweep on one thread.
class ChunkRunner {
 public:
  /// @param c  a case with a sweep
  ChunkRunner(const Case& c, SweepPlan plan);

  [[nodiscard]] ChunkResult run(std::uint64_t chunk);

 private:
  SweepPlan plan_;
  CaseTemplate template_;
  MemberQuestions asked_;
};

/// How many chunks a number of members makes.
[[nodiscard]] constexpr std::uint64_t chunks_of(std::uint64_t members) {
  return (members + chunk_size - 1) / chunk_size;
}

/// What is asked of each member of a case's sweep.
[[nodiscard]] MemberQuestions questions_of(const SweepSettings& settings);

}  // namespace turgor
