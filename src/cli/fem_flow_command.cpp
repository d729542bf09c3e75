#include "fem_flow_command.hpp"

#include <csignal>
#include <iostream>
#include <limits>

#include "guarded.hpp"
#include "interruption.hpp"
#include "progress.hpp"
#include "turgor/fem/run_flow.hpp"

namespace turgor::cli {

namespace {

EarlierRun earlier_run(const FemFlowArguments& arguments) {
  if (arguments.resume) return EarlierRun::resume;
  return arguments.force ? EarlierRun::replace : EarlierRun::refuse;
}

int exit_code(const FlowRunResult& result) {
  if (result.status == "interrupted") return exit_interrupted;
  return result.status == "failed" ? exit_failed : exit_done;
}

}  // namespace

namespace {

CLI::App* add_run(CLI::App& fem, const char* name, const char* description, FemFlowArguments& arguments) {
  CLI::App* command = fem.add_subcommand(name, description);
  command->footer(
      "Exit codes: 0 done; 2 bad input; 4 a step failed or a file could not be written; 130 interrupted or out of "
      "time. "
      "What was finished is kept, and --resume goes on.");
  add_case(*command, arguments.input);
  command
      ->add_option("-o,--output", arguments.directory,
                   "run directory; default: the case file's name with .fem, in the current folder")
      ->type_name("DIR");
  auto* resume =
      command->add_flag("--resume", arguments.resume, "go on with an unfinished run from its last checkpoint");
  command->add_flag("--force", arguments.force, "replace an earlier run in that directory")->excludes(resume);
  command
      ->add_option("--max-wall-time", arguments.max_wall_seconds,
                   "stop with a checkpoint after so many seconds by the clock on the wall")
      ->check(CLI::PositiveNumber)
      ->type_name("S");
  command->add_flag("--no-pictures", arguments.no_pictures, "draw no pictures of the fields");
  command->add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  return command;
}

}  // namespace

CLI::App* add_fem_flow(CLI::App& fem, FemFlowArguments& arguments) {
  return add_run(fem, "flow", "the flow in a balloon whose radius the case dictates: its [motion] table", arguments);
}

CLI::App* add_fem_fsi(CLI::App& fem, FemFlowArguments& arguments) {
  return add_run(fem, "fsi", "liquid and elastic wall together under the pressure at the inlet", arguments);
}

int compute_fem_flow(const FemFlowArguments& arguments, const FlowProblemMaker& make_problem,
                     const std::vector<std::pair<std::string, std::string>>& versions) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error to report, like a full disk
  catch_interruptions();
  const std::unique_ptr<FlowProblem> problem = make_problem(c);  // before anything is written: it may refuse the case
  FlowRunFolder folder(arguments.directory.empty() ? c.file.stem().string() + ".fem" : arguments.directory, c,
                       earlier_run(arguments));

  const bool talks = !arguments.quiet && !arguments.input.json;
  if (talks) {  // while there is time to stop
    for (const Warning& warning : problem->warnings()) std::cerr << "warning: " << warning.text << "\n";
  }
  ProgressLine line("simulated seconds", c.solve.t_end, talks, folder.start() ? folder.start()->time : 0);
  FlowRunOptions options{.progress =
                             [&](double time) {
                               line.reach(time);
                               return !interrupted();
                             },
                         .versions = versions,
                         .pictures = c.output.pictures && !arguments.no_pictures};
  if (arguments.max_wall_seconds > 0) options.max_wall_seconds = arguments.max_wall_seconds;
  const FlowRunResult result = run_flow(c, *problem, folder, options);
  line.finish();
  if (arguments.input.json) {
    std::cout << flow_run_json(c, result, options);
  } else if (talks) {
    std::cout << flow_run_summary(c, result) << "  written to " << folder.path().string() << "\n";
  }
  if (result.status == "failed") std::cerr << "error: " << result.message << "\n";
  if (result.status == "interrupted") std::cerr << result.message << "\n";
  return exit_code(result);
}

}  // namespace turgor::cli
