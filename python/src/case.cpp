// Cases from text or files.

#include <pybind11/stl.h>

#include "parts.hpp"
#include "turgor/case/units.hpp"

namespace turgor::python {

namespace py = pybind11;

void bind_case(py::module_& module) {
  using Overrides = std::vector<std::string>;
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  py::class_<Case, std::shared_ptr<Case>>(module, "Case")
      .def_readonly("title", &Case::title)
      .def_readonly("source", &Case::source)
      .def_readonly("resolved", &Case::resolved)
      .def_property_readonly("file", [](const Case& c) { return c.file.string(); })
      .def_property_readonly("t_end", [](const Case& c) { return c.solve.t_end; })
      .def_property_readonly("dictates_motion", [](const Case& c) { return c.motion.has_value(); })
      .def("pressure", [](const Case& c, const Array& times) {
        return py::vectorize([&c](double t) { return c.pressure(t); })(times);
      });
  module.def(
      "parse_case",
      [](const std::string& text, const std::string& file, const Overrides& overrides) {
        return std::make_shared<Case>(parse_case(text, file, overrides));
      },
      unlocked);
  module.def(
      "read_case",
      [](const std::string& file, const Overrides& overrides) {
        return std::make_shared<Case>(read_case(file, overrides));
      },
      unlocked);
  module.def("schema_json", [] { return schema_json(case_schema()); });
  module.def("parse_argument", &parse_argument);
}

}  // namespace turgor::python
