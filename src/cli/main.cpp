// The command line: one subcommand each for a run, a study, a question, a document.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>

#include "commands.hpp"
#include "turgor/base/version.hpp"

namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done; 2 bad input; 3 a quantity in [expect] was missed; 4 the computation failed (what was computed "
    "is "
    "kept); 130 interrupted (what was computed is kept).";

/// Replaces this program by another that stands beside it, which is linked with libraries whose loading would slow down
/// every other command: NetCDF and MPI, or deal.II. Returns only when that fails.
/// @param origin  how one comes by that program, in words
int hand_over(const char* name, char** argv, const char* origin) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / name;
  execv(program.c_str(), argv);
  std::cerr << "error: cannot start " << program.string() << " (" << std::strerror(errno)  // NOLINT: one thread
            << "); " << origin << "\n";
  return turgor::cli::exit_failed;
}

constexpr const char* origin_of_sweep = "it is built and installed together with turgor unless TURGOR_SWEEP is OFF";
constexpr const char* origin_of_fem =
    "it is built when the CMake option TURGOR_FEM is ON; `./dev build fem` does that and installs deal.II (1.9 GB)";

/// "run, sweep, info"
std::string command_names(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace turgor::cli;
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first == "sweep") return hand_over("turgor-sweep", argv, origin_of_sweep);
  if (first == "fem") return hand_over("turgor-fem", argv, origin_of_fem);
  CLI::App app{"turgor: liquid-filled hyperelastic balloons by the reduced-order model of Ilssar & Gat", "turgor"};
  app.set_version_flag("--version", std::string(turgor::version));
  app.require_subcommand(1);
  app.footer(exit_codes);

  RunArguments run;
  CLI::App* run_command = app.add_subcommand("run", "simulate a case and write a run directory");
  add_case(*run_command, run.input);
  run_command
      ->add_option("-o,--output", run.directory,
                   "run directory; default: the case file's name with .run, in the current folder")
      ->type_name("DIR");
  run_command->add_flag("--force", run.force, "replace an earlier run in that directory");
  run_command->add_flag("--no-pictures", run.no_pictures, "draw no pictures");
  auto* quiet = run_command->add_flag("-q,--quiet", run.quiet, "print nothing but errors");
  run_command->add_flag("-v,--verbose", run.verbose, "also print model comparison and integrator work")
      ->excludes(quiet);

  ForceArguments force;
  CLI::App* force_command = app.add_subcommand(
      "force", "force of the liquid on a balloon whose radius the case dictates: its [motion] table");
  add_case(*force_command, force.input);
  force_command
      ->add_option("-o,--output", force.directory,
                   "directory for the results; default: the case file's name with .force, in the current folder")
      ->type_name("DIR");
  force_command->add_flag("--force", force.force, "replace earlier results in that directory");
  force_command->add_flag("--no-pictures", force.no_pictures, "draw no pictures");
  force_command->add_flag("-q,--quiet", force.quiet, "print nothing but errors");

  app.add_subcommand("sweep", "run the parameter study that a case describes, and write one NetCDF file");

  app.add_subcommand("fem", "the flow inside a balloon by finite elements, where built (TURGOR_FEM)");

  CaseArguments info;
  CLI::App* info_command = app.add_subcommand(
      "info", "dimensionless groups, limit points, equilibria, time constants, strained assumptions");
  add_case(*info_command, info);

  StaticsArguments statics;
  CLI::App* statics_command = add_statics(app, statics);
  PortraitArguments portrait;
  CLI::App* portrait_command = add_portrait(app, portrait);
  FlowArguments flow;
  CLI::App* flow_command = add_flow(app, flow);
  CoefficientArguments coefficients;
  CLI::App* coefficients_command = add_coefficients(app, coefficients);
  ProfileArguments profile;
  CLI::App* profile_command = add_profile(app, profile);
  VerifyArguments verification;
  CLI::App* verify_command = add_verify(app, verification);
  FigureArguments figure;
  CLI::App* figure_command = add_figure(app, figure);
  AsymptoticsArguments asymptotics;
  CLI::App* asymptotics_command = app.add_subcommand(
      "asymptotics",
      "the closed approximations of equilibria and free motion at the final pressure, with their errors");
  add_case(*asymptotics_command, asymptotics.input);
  asymptotics_command->add_option("--from", asymptotics.from, "stretch from which the balloon deflates")
      ->type_name("STRETCH");

  CaseArguments validate;
  CLI::App* validate_command =
      app.add_subcommand("validate", "check a case file and say everything that is wrong with it");
  add_case(*validate_command, validate);

  DocArguments doc;
  CLI::App* doc_command = app.add_subcommand("doc", "every key of a case file: unit, default, range, meaning");
  doc_command->add_option("table", doc.table, "only this table, such as inlet");
  doc_command->add_flag("--json", doc.json, "print one JSON document and nothing else");

  bool materials_json = false;
  CLI::App* materials_command =
      app.add_subcommand("materials", "the material models, their energies, constants and references");
  materials_command->add_flag("--json", materials_json, "print one JSON document and nothing else");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty()) {
      std::cerr << "error: unknown command \"" << argv[1] << "\"; commands are " << command_names(app) << "\n";
      return exit_bad_input;
    }
    return app.exit(error) == 0 ? exit_done : exit_bad_input;
  }

  if (run_command->parsed()) return guarded(run.input.json, [&] { return run_case_file(run); });
  if (force_command->parsed()) return guarded(force.input.json, [&] { return write_force_history(force); });
  if (info_command->parsed()) return guarded(info.json, [&] { return print_info(info); });
  if (statics_command->parsed()) return guarded(statics.input.json, [&] { return print_statics(statics); });
  if (portrait_command->parsed()) return guarded(portrait.input.json, [&] { return write_portrait(portrait); });
  if (flow_command->parsed()) return guarded(flow.input.json, [&] { return write_flow(flow); });
  if (coefficients_command->parsed()) {
    return guarded(coefficients.json, [&] { return print_coefficients(coefficients); });
  }
  if (profile_command->parsed()) return guarded(profile.json, [&] { return print_profile(profile); });
  if (verify_command->parsed()) return guarded(verification.input.json, [&] { return verify_case(verification); });
  if (figure_command->parsed()) return guarded(figure.json, [&] { return make_figures(figure); });
  if (asymptotics_command->parsed()) {
    return guarded(asymptotics.input.json, [&] { return print_asymptotics(asymptotics); });
  }
  if (validate_command->parsed()) return guarded(validate.json, [&] { return validate_case_file(validate); });
  if (doc_command->parsed()) return guarded(doc.json, [&] { return print_documentation(doc); });
  return guarded(materials_json, [&] { return print_materials(materials_json); });
}
