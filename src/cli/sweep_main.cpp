// turgor sweep. `turgor` replaces itself by this program, which alone is linked with NetCDF and MPI.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments.hpp"
#include "guarded.hpp"
#include "interruption.hpp"
#include "progress.hpp"
#include "turgor/base/text.hpp"
#include "turgor/sweep/ranks.hpp"
#include "turgor/sweep/run_sweep.hpp"
#include "turgor/view/sweep_pictures.hpp"

namespace turgor::cli {

namespace {

struct SweepArguments {
  CaseArguments input;
  std::string output;
  bool resume = false;
  bool force = false;
  bool no_pictures = false;
  bool quiet = false;
  int threads = 0;
};

double rate_of(const SweepResult& result) {
  return result.seconds > 0 ? static_cast<double>(result.progress.computed) / result.seconds : 0;
}

std::string summary_text(const SweepResult& result, const std::string& output) {
  const SweepSummary& s = result.summary;
  std::string out = std::to_string(s.members) + " members";
  if (result.progress.computed < s.members) out += ", " + std::to_string(result.progress.computed) + " of them now";
  out += " in " + rounded(result.seconds, 3) + " s (" + rounded(rate_of(result), 3) + " per second), " +
         std::to_string(s.failed) + " failed\n";
  for (const auto& [reason, count] : s.failures) out += "  " + std::to_string(count) + " failed: " + reason + "\n";
  std::vector<std::array<std::string, 5>> table{{"", "members", "least", "mean", "greatest"}};
  for (const QuantitySummary& q : s.quantities) {
    table.push_back({q.name + (q.unit == "1" ? "" : " [" + q.unit + "]"), std::to_string(q.count)});
    if (q.count > 0) {
      std::ranges::copy(std::array{rounded(q.least, 6), rounded(q.mean, 6), rounded(q.greatest, 6)},
                        table.back().begin() + 2);
    }
  }
  constexpr std::array<std::size_t, 5> width{22, 11, 14, 14, 14};
  for (const auto& row : table) {
    out += "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += row[i] + std::string(std::max<std::size_t>(width[i], row[i].size() + 2) - row[i].size(), ' ');
    }
    out.resize(out.find_last_not_of(' ') + 1);
    out += "\n";
  }
  return out + "  written to " + output + "\n";
}

nlohmann::ordered_json summary_json(const SweepResult& result, const std::string& output) {
  const SweepSummary& s = result.summary;
  nlohmann::ordered_json failures = nlohmann::ordered_json::array();
  for (const auto& [reason, count] : s.failures) failures.push_back({{"message", reason}, {"members", count}});
  nlohmann::ordered_json quantities;
  for (const QuantitySummary& q : s.quantities) {
    quantities[q.name] = {{"unit", q.unit}, {"members", q.count}};
    if (q.count > 0) quantities[q.name].update({{"least", q.least}, {"mean", q.mean}, {"greatest", q.greatest}});
  }
  return {{"status", result.complete ? "complete" : "interrupted"},
          {"output", output},
          {"members", result.progress.all},
          {"finished", result.progress.done},
          {"computed", result.progress.computed},
          {"seconds", result.seconds},
          {"failed", s.failed},
          {"failures", failures},
          {"quantities", quantities}};
}

int sweep_case_file(const SweepArguments& arguments, Ranks* ranks) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  require_free_motion(c);
  const bool talks = !arguments.quiet && !arguments.input.json;
  SweepOptions options{.output = arguments.output.empty() ? c.file.stem().string() + ".nc" : arguments.output,
                       .resume = arguments.resume,
                       .force = arguments.force,
                       .threads = arguments.threads};
  std::optional<ProgressLine> line;
  options.progress = [&](const SweepProgress& progress) {
    if (!line) {
      const auto before = static_cast<double>(progress.done - progress.computed);
      line.emplace("members", static_cast<double>(progress.all), talks, before);
    }
    line->reach(static_cast<double>(progress.done));
    return !interrupted();
  };
  const SweepResult result = run_sweep(c, options, ranks);
  if (line) line->finish();
  if (ranks != nullptr && ranks->rank() != 0) return exit_done;
  const std::string output = options.output.string();
  std::string picture_problem;
  if (result.complete && c.output.pictures && !arguments.no_pictures) {
    picture_problem = draw_sweep(c, result.summary, options.output);
  }
  if (arguments.input.json) std::cout << summary_json(result, output).dump(2) << "\n";
  if (!result.complete) {
    std::cerr << "interrupted: " << result.progress.done << " of " << result.progress.all << " members are kept in "
              << output << ".part; go on with --resume\n";
    return exit_interrupted;
  }
  if (talks) std::cout << c.title << "\n" << summary_text(result, output);
  if (!picture_problem.empty() && !arguments.quiet) std::cerr << "warning: " << picture_problem << "\n";
  return exit_done;
}

/// Under mpirun all ranks run this; only rank 0 may speak, and one that fails takes the others with it.
int sweep(const SweepArguments& arguments) {
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error to report, like a full disk
  catch_interruptions();
  if (!Ranks::launched()) return guarded(arguments.input.json, [&] { return sweep_case_file(arguments, nullptr); });
  Ranks ranks;
  if (ranks.rank() != 0) std::cerr.setstate(std::ios::failbit);
  const int code =
      guarded(arguments.input.json && ranks.rank() == 0, [&] { return sweep_case_file(arguments, &ranks); });
  if (code == exit_failed) Ranks::abort(code);
  return code;
}

}  // namespace

}  // namespace turgor::cli

int main(int argc, char** argv) {
  using namespace turgor::cli;
  CLI::App app{"", "turgor"};
  app.require_subcommand(1);
  CLI::App* command = app.add_subcommand("sweep", "run the parameter study that a case describes: its [sweep] table");
  command->footer(
      "`mpirun -n N turgor sweep ...` shares the members among N processes.\n"
      "Exit codes: 0 done, failed members included; 2 bad input; 4 a file could not be written; "
      "130 interrupted. What was finished is kept, and --resume goes on.");
  SweepArguments arguments;
  add_case(*command, arguments.input);
  command
      ->add_option("-o,--output", arguments.output,
                   "NetCDF file; default: the case file's name with .nc, in the current folder")
      ->type_name("OUT.nc");
  auto* resume = command->add_flag("--resume", arguments.resume, "go on with an unfinished sweep");
  command->add_flag("--force", arguments.force, "replace an earlier result, finished or not")->excludes(resume);
  command->add_option("--threads", arguments.threads, "threads of each process; default: one for each core")
      ->check(CLI::Range(1, 4096));
  command->add_flag("--no-pictures", arguments.no_pictures, "draw no pictures");
  command->add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_bad_input;
  }
  return sweep(arguments);
}
