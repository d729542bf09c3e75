#pragma once
// Errors of turgor as Python exceptions, and Ctrl-C.

#include <pybind11/pybind11.h>

#include <chrono>

namespace turgor::python {

/// InvalidInput becomes turgor.InvalidInput, ComputationFailed turgor.ComputationFailed.
void translate_errors();

/// What a long computation asks now and then, without the interpreter's lock: whether Python has something to say.
class Interruption {
 public:
  /// @param progress  called with the time or number reached, or None
  explicit Interruption(pybind11::object progress) : progress_(std::move(progress)) {}

  /// Some twenty times a second takes the lock, calls `progress`, and lets signals through.
  /// @throws pybind11::error_already_set what `progress` raises, or KeyboardInterrupt
  void reach(double value);

 private:
  pybind11::object progress_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace turgor::python
