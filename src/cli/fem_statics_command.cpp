#include "fem_statics_command.hpp"

#include <iostream>

#include "guarded.hpp"
#include "numbers.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/membrane_study.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/view/membrane_picture.hpp"

namespace turgor::cli {

namespace {

std::optional<double> quantity(const char* name, const std::string& text, const char* unit) {
  if (text.empty()) return std::nullopt;
  return parse_argument(name, text, unit);
}

MembraneQuestions questions_of(const FemStaticsArguments& arguments) {
  MembraneQuestions questions;
  if (!arguments.up_to.empty()) {
    questions.up_to = plain_number(arguments.up_to);
    if (!questions.up_to) throw InvalidInput("--up-to", arguments.up_to, "is not a number", "write for example 2.2");
  }
  questions.pressure = quantity("--pressure", arguments.pressure, "Pa");
  questions.volume = quantity("--volume", arguments.volume, "m^3");
  if (questions.volume && !(*questions.volume > 0)) {
    throw InvalidInput("--volume", "\"" + arguments.volume + "\"", "out of range", "allowed is > 0 m^3");
  }
  questions.limit_point = arguments.limit_point;
  return questions;
}

}  // namespace

CLI::App* add_fem_statics(CLI::App& fem, FemStaticsArguments& arguments) {
  CLI::App* command = fem.add_subcommand(
      "statics", "the elastic wall at rest: the curve of pressure, limit points, stability, shapes; no flow");
  add_case(*command, arguments.input);
  command
      ->add_option("--up-to", arguments.up_to,
                   "stretch at which the curve ends; default: 2.2, or beyond the last state that (3.1) has")
      ->type_name("STRETCH");
  command
      ->add_option("--pressure", arguments.pressure,
                   "gauge pressure of equilibria, with a unit: \"41.3 kPa\"; default: the case's last")
      ->type_name("QUANTITY");
  command->add_option("--volume", arguments.volume, "also the state that has this volume: \"200 L\"")
      ->type_name("QUANTITY");
  command->add_flag("--limit-point", arguments.limit_point, "fail when there is no limit point");
  add_results(*command, arguments.results, "none, the results go to the screen");
  return command;
}

int print_fem_statics(const FemStaticsArguments& arguments) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  const MembraneStudy study = study_membrane(c, questions_of(arguments));
  const std::string json = membrane_json(c, study);
  std::string problem;
  const std::string& directory = arguments.results.directory;
  if (!directory.empty()) {
    const ResultFolder folder(
        directory,
        {"statics directory", {"case.toml", "resolved.toml", "statics.csv", "shapes.csv", "statics.json"}, {"statics"}},
        arguments.results.force);
    folder.write_first("case.toml", c.source);
    folder.write("resolved.toml", c.resolved);
    folder.write("statics.csv", membrane_csv(c, study));
    folder.write("shapes.csv", shapes_csv(c, study));
    folder.write("statics.json", json);
    if (c.output.pictures && !arguments.results.no_pictures) problem = draw_membrane(c, study, folder.path());
  }
  if (arguments.input.json) {
    std::cout << json;
  } else {
    std::cout << membrane_text(c, study);
    if (!directory.empty()) std::cout << "  written to " << directory << "\n";
  }
  if (!problem.empty()) std::cerr << "warning: " << problem << "\n";
  return exit_done;
}

}  // namespace turgor::cli
