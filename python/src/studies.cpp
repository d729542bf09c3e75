// Questions whose answers are documents: each returns the texts of the command of the same name, numbers as the
// shortest text that reads back as the same double.

#include <pybind11/stl.h>

#include "parts.hpp"
#include "turgor/case/key_range.hpp"
#include "turgor/case/profile.hpp"
#include "turgor/case/units.hpp"
#include "turgor/material/material.hpp"
#include "turgor/run/asymptotics.hpp"
#include "turgor/run/force_history.hpp"
#include "turgor/run/force_study.hpp"
#include "turgor/run/info.hpp"
#include "turgor/run/portrait_report.hpp"
#include "turgor/run/response_verification.hpp"
#include "turgor/run/static_study.hpp"
#include "turgor/run/verification.hpp"

namespace turgor::python {

namespace py = pybind11;

namespace {

using Texts = std::vector<std::string>;

Texts info(const Case& c) {
  require_free_motion(c);
  const CaseInfo info = case_info(c);
  return {info_json(c, info), info_text(c, info)};
}

Texts statics(const Case& c, const Texts& over, std::optional<double> compliance) {
  StaticQuestions questions{compliance, {}};
  for (const std::string& text : over) questions.over.push_back(read_key_range(c, "over", text));
  const StaticStudy study = study_statics(c, questions);
  return {statics_json(c, study), statics_text(c, study), statics_csv(c, study),
          study.over ? branches_csv(study) : std::string()};
}

Texts asymptotics(const Case& c, std::optional<double> start) {
  const AsymptoticsReport report = asymptotics_report(c, start);
  return {asymptotics_json(c, report), asymptotics_text(c, report)};
}

Texts portrait(const Case& c, std::optional<double> pressure, const std::array<double, 4>& window) {
  const auto [least, greatest, deflation, inflation] = window;
  const PortraitStudy study = study_portrait(c, {pressure, {least, greatest, deflation, inflation}});
  return {portrait_json(c, study), portrait_text(c, study), portrait_csv(study)};
}

Texts force(const Case& c) {
  const ForceHistory history = force_history(c);
  return {force_json(c, history), force_summary(c, history), force_csv(c)};
}

OutflowProfile profile_of(const std::string& file) {
  return file.empty() ? OutflowProfile::uniform() : read_profile(file);
}

Texts coefficients(const std::vector<double>& kappas, const std::string& profile, int harmonics) {
  const std::vector<CoefficientRow> rows = coefficient_table(kappas, profile_of(profile), harmonics);
  return {coefficients_json(rows), coefficients_text(rows), coefficients_csv(rows)};
}

template <class AnyVerification>
Texts report(const Case& c, const AnyVerification& verification) {
  return {verification_json(c, verification), verification_summary(c, verification), verification_csv(c, verification)};
}

Texts verify_case(const Case& c, const std::string& folder) {
  if (c.motion) return report(c, verify(c, read_fem_history(c, folder)));
  return report(c, verify_response(c, read_fem_response(c, folder)));
}

py::list materials() {
  py::list all;
  for (const MaterialEntry& entry : catalogue()) {
    const py::dict constants;
    for (const MaterialConstant& c : entry.constants) constants[py::str(std::string(c.key))] = std::string(c.unit);
    all.append(
        py::make_tuple(std::string(entry.name), std::string(entry.energy), std::string(entry.reference), constants));
  }
  return all;
}

}  // namespace

void bind_studies(py::module_& module) {
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  module.def("info", &info, unlocked);
  module.def("statics", &statics, unlocked);
  module.def("asymptotics", &asymptotics, unlocked);
  module.def("portrait", &portrait, unlocked);
  module.def("force", &force, unlocked);
  module.def("coefficients", &coefficients, unlocked);
  module.def("verify", &verify_case, unlocked);
  module.def("materials", &materials);
}

}  // namespace turgor::python
