#pragma once
// Arguments that several commands share.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace turgor::cli {

struct CaseArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool json = false;
};

inline void add_case(CLI::App& command, CaseArguments& arguments) {
  command.add_option("case", arguments.file, "case file (TOML)")->required();
  command
      .add_option("--set", arguments.overrides, "override a key: --set 'inlet.orifice_radius=2 cm'; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command.add_flag("--json", arguments.json, "print one JSON document and nothing else");
}

/// Where a command writes its results.
struct ResultArguments {
  std::string directory;
  bool force = false;
  bool no_pictures = false;
};

/// @param fallback  the folder when none is given, in words
inline void add_results(CLI::App& command, ResultArguments& arguments, const std::string& fallback) {
  command.add_option("-o,--output", arguments.directory, "folder for the results; default: " + fallback)
      ->type_name("DIR");
  command.add_flag("--force", arguments.force, "replace earlier results in that folder");
  command.add_flag("--no-pictures", arguments.no_pictures, "draw no pictures");
}

}  // namespace turgor::cli
