#include "commands.hpp"

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "interruption.hpp"
#include "progress.hpp"
#include "turgor/run/asymptotics.hpp"
#include "turgor/run/directory.hpp"
#include "turgor/run/info.hpp"
#include "turgor/run/report.hpp"
#include "turgor/view/pictures.hpp"

namespace turgor::cli {

namespace {

Case read(const CaseArguments& arguments) { return read_case(arguments.file, arguments.overrides); }

std::filesystem::path folder_of(const Case& c, const std::string& given, const char* ending) {
  return given.empty() ? c.file.stem().string() + ending : given;
}

int exit_code(const RunResult& result) {
  if (result.status() == "interrupted") return exit_interrupted;
  if (result.status() == "failed") return exit_failed;
  return result.expectations_met() ? exit_done : exit_expectation_missed;
}

}  // namespace

int run_case_file(const RunArguments& arguments) {
  const Case c = read(arguments.input);
  require_free_motion(c);
  const std::filesystem::path folder = folder_of(c, arguments.directory, ".run");
  RunDirectory directory(folder, c, arguments.force);

  catch_interruptions();
  ProgressLine line("simulated seconds", c.solve.t_end, !arguments.quiet && !arguments.input.json);
  const RunResult result = run_case(c, [&](double time) {
    line.reach(time);
    return !interrupted();
  });
  line.finish();
  directory.write(c, result);

  std::string picture_problem;
  if (c.output.pictures && !arguments.no_pictures && result.status() != "interrupted") {
    picture_problem = draw_pictures(c, result, folder);
  }
  if (arguments.input.json) {
    std::cout << run_json(c, result);
  } else if (!arguments.quiet) {
    std::cout << summary(c, result, arguments.verbose) << "  written to " << folder.string() << "\n";
  }
  if (!picture_problem.empty() && !arguments.quiet) std::cerr << "warning: " << picture_problem << "\n";
  if (result.status() == "failed") std::cerr << "error: " << result.trajectory->message << "\n";
  if (!result.expectations_met()) {
    for (const ExpectationResult& e : result.expectations) {
      if (!e.met) std::cerr << "error: expected quantity missed: " << e.expected.quantity << "\n";
    }
  }
  return exit_code(result);
}

int write_force_history(const ForceArguments& arguments) {
  const Case c = read(arguments.input);
  const ForceHistory history = force_history(c);
  const std::filesystem::path folder = folder_of(c, arguments.directory, ".force");
  RunDirectory directory(folder, c, arguments.force);
  directory.write(c, history);

  std::string picture_problem;
  if (c.output.pictures && !arguments.no_pictures) picture_problem = draw_force(c, history, folder);
  if (arguments.input.json) {
    std::cout << force_json(c, history);
  } else if (!arguments.quiet) {
    std::cout << force_summary(c, history) << "  written to " << folder.string() << "\n";
  }
  if (!picture_problem.empty() && !arguments.quiet) std::cerr << "warning: " << picture_problem << "\n";
  return exit_done;
}

int print_info(const CaseArguments& arguments) {
  const Case c = read(arguments);
  require_free_motion(c);
  const CaseInfo info = case_info(c);
  std::cout << (arguments.json ? info_json(c, info) : info_text(c, info));
  return exit_done;
}

int print_asymptotics(const AsymptoticsArguments& arguments) {
  const Case c = read(arguments.input);
  const AsymptoticsReport report = asymptotics_report(c, arguments.from);
  std::cout << (arguments.input.json ? asymptotics_json(c, report) : asymptotics_text(c, report));
  return exit_done;
}

int validate_case_file(const CaseArguments& arguments) {
  const Case c = read(arguments);
  if (arguments.json) {
    const nlohmann::ordered_json document{{"status", "valid"}, {"title", c.title}, {"resolved", c.resolved}};
    std::cout << document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  } else {
    std::cout << arguments.file << ": valid\n";
  }
  return exit_done;
}

}  // namespace turgor::cli
