// turgor fem. `turgor` replaces itself by this program, which alone is linked with deal.II.

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "fem_flow_command.hpp"
#include "fem_statics_command.hpp"
#include "guarded.hpp"
#include "turgor/fem/coupled_flow.hpp"
#include "turgor/fem/dictated_flow.hpp"
#include "turgor/fem/session.hpp"

namespace turgor::cli {

namespace {

int print_versions(bool json) {
  nlohmann::ordered_json document;
  for (const auto& [library, number] : fem_versions()) {
    if (json) {
      document[library] = number;
    } else {
      std::cout << library << " " << number << "\n";
    }
  }
  if (json) std::cout << document.dump(2) << "\n";
  return exit_done;
}

}  // namespace

}  // namespace turgor::cli

int main(int argc, char** argv) {
  using namespace turgor::cli;
  CLI::App app{"", "turgor"};
  app.require_subcommand(1);
  CLI::App* fem =
      app.add_subcommand("fem", "the balloon by finite elements: the flow in it, its elastic wall, both together");
  fem->require_subcommand(1);
  FemFlowArguments flow;
  CLI::App* flow_command = add_fem_flow(*fem, flow);
  FemFlowArguments fsi;
  CLI::App* fsi_command = add_fem_fsi(*fem, fsi);
  FemStaticsArguments statics;
  CLI::App* statics_command = add_fem_statics(*fem, statics);
  bool versions_json = false;
  CLI::App* versions = fem->add_subcommand("versions", "the libraries that have a say in the results");
  versions->add_flag("--json", versions_json, "print one JSON document and nothing else");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_bad_input;
  }
  const auto run = [&](const FemFlowArguments& arguments, const turgor::FlowProblemMaker& make_problem) {
    return guarded(arguments.input.json, [&] {
      const turgor::FemSession session;
      return compute_fem_flow(arguments, make_problem, turgor::fem_versions());
    });
  };
  if (flow_command->parsed()) return run(flow, turgor::make_dictated_flow);
  if (fsi_command->parsed()) return run(fsi, turgor::make_coupled_flow);
  if (statics_command->parsed()) return guarded(statics.input.json, [&] { return print_fem_statics(statics); });
  return guarded(versions_json, [&] { return print_versions(versions_json); });
}
