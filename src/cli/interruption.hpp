#pragma once
// Ctrl-C and SIGTERM as a question that a computation asks now and then.

#include <csignal>

namespace turgor::cli {

namespace detail {
inline volatile std::sig_atomic_t interrupted = 0;  // NOLINT: a signal handler can reach nothing else

/// A second signal ends the program at once.
inline void on_signal(int number) {
  interrupted = 1;
  (void)std::signal(number, SIG_DFL);
}
}  // namespace detail

/// From here on the first SIGINT or SIGTERM only makes interrupted() true.
inline void catch_interruptions() {
  (void)std::signal(SIGINT, detail::on_signal);
  (void)std::signal(SIGTERM, detail::on_signal);
}
[[nodiscard]] inline bool interrupted() { return detail::interrupted != 0; }

}  // namespace turgor::cli
