#pragma once
// How a program ends: exit codes, and messages for what goes wrong.

#include <functional>

namespace turgor::cli {

inline constexpr int exit_done = 0;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_expectation_missed = 3;
inline constexpr int exit_failed = 4;
inline constexpr int exit_interrupted = 130;

/// Runs a command and turns what it throws into messages on standard error and an exit code. With `json` the issues are
/// also printed as a JSON document on standard output.
int guarded(bool json, const std::function<int()>& command);

}  // namespace turgor::cli
