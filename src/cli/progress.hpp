#pragma once

#include <boost/timer/progress_display.hpp>
#include <chrono>
#include <optional>

namespace turgor::cli {

/// A progress bar on standard error for runs that take longer than a moment; silent when that is no terminal.
class ProgressBar {
 public:
  /// @param end  simulated time at which the run is done [s]
  ProgressBar(double end, bool wanted);

  /// Simulated time reached [s]; cheap enough to be called after every step.
  void reach(double time);
  void finish();

 private:
  double end_;
  bool shown_;
  long calls_ = 0;
  unsigned long done_ = 0;
  std::chrono::steady_clock::time_point start_;
  std::optional<boost::timer::progress_display> bar_;
};

}  // namespace turgor::cli
