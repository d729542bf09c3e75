#include "commands.hpp"

#include <csignal>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "progress.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/directory.hpp"
#include "turgor/run/info.hpp"
#include "turgor/run/report.hpp"
#include "turgor/view/pictures.hpp"

namespace turgor::cli {

namespace {

volatile std::sig_atomic_t interrupted = 0;  // NOLINT: a signal handler can reach nothing else

void on_signal(int /*number*/) { interrupted = 1; }

Case read(const CaseArguments& arguments) { return read_case(arguments.file, arguments.overrides); }

nlohmann::ordered_json to_json(const Issue& issue) {
  return {{"key", issue.key},       {"value", issue.value}, {"problem", issue.problem},
          {"advice", issue.advice}, {"file", issue.file},   {"line", issue.line}};
}

void print_failure(bool json, const std::string& status, const std::string& message, const std::vector<Issue>& issues) {
  if (!json) return;
  nlohmann::ordered_json document{
      {"status", status}, {"message", message}, {"issues", nlohmann::ordered_json::array()}};
  for (const Issue& issue : issues) document["issues"].push_back(to_json(issue));
  std::cout << document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

int exit_code(const RunResult& result) {
  if (result.status() == "interrupted") return exit_interrupted;
  if (result.status() == "failed") return exit_failed;
  return result.expectations_met() ? exit_done : exit_expectation_missed;
}

}  // namespace

int guarded(bool json, const std::function<int()>& command) {
  try {
    const int code = command();
    std::cout.flush();
    return code;
  } catch (const InvalidInput& error) {
    for (const Issue& issue : error.issues()) std::cerr << "error: " << issue.text() << "\n";
    print_failure(json, "bad-input", error.what(), error.issues());
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    std::cerr << "error: out of memory; fewer samples or a looser tolerance need less\n";
    print_failure(json, "failed", "out of memory", {});
    return exit_failed;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n";
    print_failure(json, "failed", error.what(), {});
    return exit_failed;
  }
}

int run_case_file(const RunArguments& arguments) {
  const Case c = read(arguments.input);
  const std::filesystem::path folder =
      arguments.directory.empty() ? c.file.stem().string() + ".run" : arguments.directory;
  RunDirectory directory(folder, c, arguments.force);

  (void)std::signal(SIGINT, on_signal);
  (void)std::signal(SIGTERM, on_signal);
  ProgressBar bar(c.solve.t_end, !arguments.quiet && !arguments.input.json);
  const RunResult result = run_case(c, [&](double time) {
    bar.reach(time);
    return interrupted == 0;
  });
  bar.finish();
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

int print_info(const CaseArguments& arguments) {
  const Case c = read(arguments);
  const CaseInfo info = case_info(c);
  std::cout << (arguments.json ? info_json(c, info) : info_text(c, info));
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
