#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace turgor::cli {

namespace {
constexpr unsigned long divisions = 1000;
}

ProgressBar::ProgressBar(double end, bool wanted)
    : end_(end), shown_(wanted && isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()) {}

void ProgressBar::reach(double time) {
  if (!shown_ || ++calls_ % 256 != 0) return;  // the clock is not asked after every step
  if (!bar_) {
    if (std::chrono::steady_clock::now() - start_ < std::chrono::milliseconds(500)) return;
    bar_.emplace(divisions, std::cerr);
  }
  const auto reached = static_cast<unsigned long>(std::clamp(time / end_, 0.0, 1.0) * divisions);
  if (reached > done_) *bar_ += reached - done_;
  done_ = std::max(done_, reached);
}

void ProgressBar::finish() {
  if (bar_) std::cerr << "\n";
  shown_ = false;
}

}  // namespace turgor::cli
