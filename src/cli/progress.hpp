#pragma once

#include <chrono>
#include <string>

namespace turgor::cli {

/// One line on standard error for work that takes longer than a moment: share, rate, time left. Silent when that is no
/// terminal.
class ProgressLine {
 public:
  /// @param what    the unit that is counted: "members", "simulated seconds"
  /// @param all     how many of it there are
  /// @param before  how many were done before
  ProgressLine(std::string what, double all, bool wanted, double before = 0);

  /// How many are done; cheap enough to be called after every step.
  void reach(double done);
  /// Clears the line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  double all_;
  double before_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace turgor::cli
