// turgor._core: what turgor's Python package is made of. Only the package uses it; its own functions are in
// turgor/*.py.

#include "errors.hpp"
#include "parts.hpp"
#include "turgor/base/version.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace turgor::python;
  module.attr("version") = std::string(turgor::version);
  module.attr("compiler") = std::string(turgor::compiler);
  translate_errors();
  bind_case(module);
  bind_run(module);
  bind_studies(module);
  bind_flow(module);
}
