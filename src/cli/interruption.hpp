#pragma once
// Ctrl-C and SIGTERM as a question that a computation asks now and then.

#include <csignal>
#include <ctime>

namespace turgor::cli {

namespace detail {
inline volatile std::sig_atomic_t interrupted = 0;  // NOLINT: a signal handler can reach nothing else

inline volatile std::time_t since = 0;  // NOLINT: likewise

/// A second signal ends the program at once; one right after the first is the same one, since `timeout` and mpirun send
/// theirs to a process and again to its group.
inline void on_signal(int number) {
  if (interrupted == 0) {
    since = std::time(nullptr);
    interrupted = 1;
  } else if (std::time(nullptr) > since + 1) {
    (void)std::signal(number, SIG_DFL);
    (void)std::raise(number);
  }
}
}  // namespace detail

/// From here on the first SIGINT or SIGTERM only makes interrupted() true.
inline void catch_interruptions() {
  (void)std::signal(SIGINT, detail::on_signal);
  (void)std::signal(SIGTERM, detail::on_signal);
}
[[nodiscard]] inline bool interrupted() { return detail::interrupted != 0; }

}  // namespace turgor::cli
