// turgor portrait: the phase plane of a balloon at one constant pressure.

#include <iostream>

#include "commands.hpp"
#include "numbers.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/portrait_report.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/view/portrait_picture.hpp"

namespace turgor::cli {

namespace {

PortraitQuestion question_of(const PortraitArguments& arguments) {
  PortraitQuestion question;
  if (!arguments.pressure.empty()) question.pressure = parse_argument("--pressure", arguments.pressure, "Pa");
  if (!arguments.stretches.empty()) {
    const NumberRange range = number_range("--stretch-range", arguments.stretches);
    for (const auto& R : {range.from, range.to}) {
      if (R && !(*R > 0)) throw InvalidInput("--stretch-range", arguments.stretches, "stretches are positive");
    }
    question.window.least_stretch = range.from.value_or(0);
    question.window.greatest_stretch = range.to.value_or(0);
  }
  if (!arguments.rates.empty()) {
    const NumberRange range = number_range("--rate-range", arguments.rates);
    if (range.from.value_or(-1) >= 0 || range.to.value_or(1) <= 0) {
      throw InvalidInput("--rate-range", arguments.rates, "must have 0 inside",
                         "write for example -0.01:200; both in 1/s, either may be left out");
    }
    constexpr double fastest = 1e9;
    if (range.from.value_or(-1) < -fastest || range.to.value_or(1) > fastest) {
      throw InvalidInput("--rate-range", arguments.rates, "out of range", "allowed are -1e9 to 1e9, in 1/s");
    }
    question.window.deflation = -range.from.value_or(0);
    question.window.inflation = range.to.value_or(0);
  }
  return question;
}

}  // namespace

CLI::App* add_portrait(CLI::App& app, PortraitArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "portrait", "phase portrait at one pressure: trajectories, slow manifolds, equilibria and their basins");
  add_case(*command, arguments.input);
  command
      ->add_option("--pressure", arguments.pressure,
                   "gauge pressure, with a unit: \"41.3 kPa\"; default: the case's at solve.t_end")
      ->type_name("QUANTITY");
  command->add_option("--stretch-range", arguments.stretches, "stretches R to show; default: around all equilibria")
      ->type_name("FROM:TO");
  command
      ->add_option("--rate-range", arguments.rates,
                   "rates dR/dt to show, 1/s, the first negative; default: what inflation from rest and slow deflation "
                   "reach")
      ->type_name("FROM:TO");
  add_results(*command, arguments.results, "the case file's name with .portrait, in the current folder");
  command->add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  return command;
}

int write_portrait(const PortraitArguments& arguments) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  const PortraitStudy study = study_portrait(c, question_of(arguments));
  const std::string directory = arguments.results.directory;
  const ResultFolder folder(directory.empty() ? c.file.stem().string() + ".portrait" : directory,
                            {"portrait directory", {"case.toml", "portrait.csv", "portrait.json"}, {"portrait"}},
                            arguments.results.force);
  folder.write_first("case.toml", c.source);
  folder.write("portrait.csv", portrait_csv(study));
  const std::string json = portrait_json(c, study);
  folder.write("portrait.json", json);
  std::string problem;
  if (c.output.pictures && !arguments.results.no_pictures) problem = draw_phase_portrait(c, study, folder.path());
  if (arguments.input.json) {
    std::cout << json;
  } else if (!arguments.quiet) {
    std::cout << portrait_text(c, study) << "  written to " << folder.path().string() << "\n";
  }
  if (!problem.empty() && !arguments.quiet) std::cerr << "warning: " << problem << "\n";
  return exit_done;
}

}  // namespace turgor::cli
