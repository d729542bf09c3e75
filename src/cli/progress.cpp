#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "turgor/base/text.hpp"

namespace turgor::cli {

namespace {

constexpr auto patience = std::chrono::milliseconds(500);  // shorter work shows nothing
constexpr auto interval = std::chrono::milliseconds(200);

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

}  // namespace

ProgressLine::ProgressLine(std::string what, double all, bool wanted, double before)
    : what_(std::move(what)),
      all_(all),
      before_(before),
      shown_(wanted && isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      next_(start_ + patience) {}

void ProgressLine::reach(double done) {
  if (!shown_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + interval;
  drawn_ = true;
  const double rate = (done - before_) / std::chrono::duration<double>(now - start_).count();
  const double share = std::clamp(done / all_, 0.0, 1.0);
  std::cerr << "\r\033[K" << static_cast<int>(100 * share) << " %  " << rounded(done, 7) << " of " << rounded(all_, 10)
            << " " << what_ << ", " << rounded(rate, 3) << "/s";
  if (rate > 0) std::cerr << ", " << duration_text((all_ - done) / rate) << " left";
  std::cerr << std::flush;
}

void ProgressLine::finish() {
  if (drawn_) std::cerr << "\r\033[K" << std::flush;
  shown_ = false;
}

}  // namespace turgor::cli
