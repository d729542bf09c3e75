// The command line: turgor run | info | validate | doc | materials.

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "commands.hpp"
#include "turgor/base/version.hpp"

namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done; 2 bad input; 3 a quantity in [expect] was missed; 4 the computation failed (what was computed "
    "is "
    "kept); 130 interrupted (what was computed is kept).";

void add_case(CLI::App& command, turgor::cli::CaseArguments& arguments) {
  command.add_option("case", arguments.file, "case file (TOML)")->required();
  command
      .add_option("--set", arguments.overrides, "override a key: --set 'inlet.orifice_radius=2 cm'; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command.add_flag("--json", arguments.json, "print one JSON document and nothing else");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace turgor::cli;
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

  CaseArguments info;
  CLI::App* info_command = app.add_subcommand(
      "info", "dimensionless groups, limit points, equilibria, time constants, strained assumptions");
  add_case(*info_command, info);

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
      std::cerr << "error: unknown command \"" << argv[1] << "\"; commands are run, info, validate, doc, materials\n";
      return exit_bad_input;
    }
    return app.exit(error) == 0 ? exit_done : exit_bad_input;
  }

  if (run_command->parsed()) return guarded(run.input.json, [&] { return run_case_file(run); });
  if (info_command->parsed()) return guarded(info.json, [&] { return print_info(info); });
  if (validate_command->parsed()) return guarded(validate.json, [&] { return validate_case_file(validate); });
  if (doc_command->parsed()) return guarded(doc.json, [&] { return print_documentation(doc); });
  return guarded(materials_json, [&] { return print_materials(materials_json); });
}
