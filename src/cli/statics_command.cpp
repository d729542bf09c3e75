// turgor statics: the balloon at rest.

#include <iostream>

#include "commands.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/run/static_study.hpp"
#include "turgor/view/static_pictures.hpp"

namespace turgor::cli {

namespace {

double read_compliance(const std::string& text) {
  const double value = parse_argument("--compliance", text, "m^3/Pa");
  if (value < 0) {
    throw InvalidInput("--compliance", "\"" + text + "\"", "out of range",
                       "allowed is >= 0 m^3/Pa; 0 prescribes the volume itself");
  }
  return value;
}

StaticQuestions questions_of(const StaticsArguments& arguments, const Case& c) {
  StaticQuestions questions;
  if (!arguments.compliance.empty()) questions.compliance = read_compliance(arguments.compliance);
  for (const std::string& text : arguments.over) questions.over.push_back(read_key_range(c, "--over", text));
  if (questions.over.size() > 2) {
    throw InvalidInput("--over", std::to_string(questions.over.size()) + " keys", "too many", "give one or two");
  }
  if (questions.over.size() == 2 && questions.over[0].key == questions.over[1].key) {
    throw InvalidInput("--over", questions.over[0].key, "is given twice", "give two different keys");
  }
  return questions;
}

/// Draws what there is to draw; returns the first problem.
std::string draw(const Case& c, const StaticStudy& study, const std::filesystem::path& folder) {
  std::string problem = draw_statics(c, study, folder);
  if (problem.empty() && study.over) problem = draw_over(c, study, folder);
  if (const auto map = mooney_rivlin_map(c); problem.empty() && map) {
    problem = draw_bistability_map(map->map, {"Mooney-Rivlin balloons: two stable states", "S1/S2 [1]", "P0/S2 [1]"},
                                   {{map->ratio, study.pressure / map->unit}}, folder, "bistability");
  }
  return problem;
}

}  // namespace

CLI::App* add_statics(CLI::App& app, StaticsArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "statics", "the balloon at rest: equilibria, limit points, bistable pressures, energy barriers, jumps");
  add_case(*command, arguments.input);
  command
      ->add_option("--over", arguments.over,
                   "also against a key of the case: --over 'material.s1=1 MPa:2 MPa'; twice: limit points in the plane "
                   "of two keys")
      ->allow_extra_args(false)
      ->type_name("KEY=FROM:TO");
  command
      ->add_option("--compliance", arguments.compliance,
                   "of the supply that fills the balloon, such as \"2e-8 m^3/Pa\": also the jumps with it")
      ->type_name("VALUE");
  add_results(*command, arguments.results, "none, the results go to the screen");
  return command;
}

int print_statics(const StaticsArguments& arguments) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  const StaticStudy study = study_statics(c, questions_of(arguments, c));
  const std::string json = statics_json(c, study);
  std::string problem;
  const std::string& directory = arguments.results.directory;
  if (!directory.empty()) {
    const ResultFolder folder(directory,
                              {"statics directory",
                               {"case.toml", "resolved.toml", "statics.csv", "branches.csv", "statics.json"},
                               {"statics", "over", "plane", "bistability"}},
                              arguments.results.force);
    folder.write_first("case.toml", c.source);
    folder.write("resolved.toml", c.resolved);
    folder.write("statics.csv", statics_csv(c, study));
    if (study.over) folder.write("branches.csv", branches_csv(study));
    folder.write("statics.json", json);
    if (c.output.pictures && !arguments.results.no_pictures) problem = draw(c, study, folder.path());
  }
  if (arguments.input.json) {
    std::cout << json;
  } else {
    std::cout << statics_text(c, study);
    if (!directory.empty()) std::cout << "  written to " << directory << "\n";
  }
  if (!problem.empty()) std::cerr << "warning: " << problem << "\n";
  return exit_done;
}

}  // namespace turgor::cli
