// turgor._sweep: parameter studies.

#include <pybind11/stl.h>

#include "errors.hpp"
#include "turgor/sweep/run_sweep.hpp"

namespace turgor::python {

namespace py = pybind11;

namespace {

/// Runs a case's sweep into a NetCDF file; progress(done, all) is called now and then.
py::dict sweep(const std::string& text, const std::string& file, const std::vector<std::string>& overrides,
               const std::string& output, bool resume, bool force, int threads, py::object progress) {
  SweepResult result;
  std::exception_ptr stopped;
  {
    SweepOptions options{.output = output, .resume = resume, .force = force, .threads = threads};
    Interruption interruption(std::move(progress));
    const py::gil_scoped_release unlocked;
    options.progress = [&](const SweepProgress& p) {
      try {
        interruption.reach(static_cast<double>(p.done) / static_cast<double>(p.all));
        return true;
      } catch (...) {  // the members under way are to be kept first
        stopped = std::current_exception();
        return false;
      }
    };
    const Case c = parse_case(text, file, overrides);
    require_free_motion(c);
    result = run_sweep(c, options);
  }
  if (stopped) std::rethrow_exception(stopped);
  py::dict failures;
  for (const auto& [reason, count] : result.summary.failures) failures[py::str(reason)] = count;
  py::dict out;
  out["members"] = result.progress.all;
  out["computed"] = result.progress.computed;
  out["seconds"] = result.seconds;
  out["failed"] = result.summary.failed;
  out["failures"] = failures;
  return out;
}

}  // namespace

}  // namespace turgor::python

PYBIND11_MODULE(_sweep, module) {
  turgor::python::translate_errors();
  module.def("sweep", &turgor::python::sweep);
}
