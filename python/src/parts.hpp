#pragma once
// The parts of the module, and what they share.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>

#include "turgor/case/case.hpp"

namespace turgor::python {

/// A case never changes, so that results and threads can share it.
using SharedCase = std::shared_ptr<const Case>;

using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

void bind_case(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_studies(pybind11::module_& module);
void bind_flow(pybind11::module_& module);

}  // namespace turgor::python
