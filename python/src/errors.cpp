#include "errors.hpp"

#include "turgor/base/errors.hpp"

namespace turgor::python {

namespace py = pybind11;

namespace {

/// turgor.errors.InvalidInput(message, issues), raised.
void raise_invalid(const InvalidInput& error) {
  const py::module_ errors = py::module_::import("turgor.errors");
  const py::object make_issue = errors.attr("Issue");
  py::list issues;
  std::string message;
  for (Issue issue : error.issues()) {
    if (issue.file == "--set") issue.file.clear();
    message += (message.empty() ? "" : "\n") + issue.text();
    issues.append(make_issue(issue.key, issue.value, issue.problem, issue.advice, issue.file, issue.line));
  }
  const py::object type = errors.attr("InvalidInput");
  PyErr_SetObject(type.ptr(), type(message, issues).ptr());
}

}  // namespace

void translate_errors() {
  py::register_local_exception_translator([](std::exception_ptr pointer) {  // NOLINT: as pybind11 has it
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const InvalidInput& error) {
      raise_invalid(error);
    } catch (const ComputationFailed& error) {
      const py::object type = py::module_::import("turgor.errors").attr("ComputationFailed");
      PyErr_SetString(type.ptr(), error.what());
    }
  });
}

void Interruption::reach(double value) {
  constexpr std::chrono::milliseconds pause(50);
  const auto now = std::chrono::steady_clock::now();
  if (now < last_ + pause) return;
  last_ = now;
  const py::gil_scoped_acquire lock;
  if (!progress_.is_none()) progress_(value);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace turgor::python
