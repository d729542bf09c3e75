#pragma once
// What each command does once its arguments are known. Each returns the program's exit code.

#include <optional>
#include <string>

#include "arguments.hpp"
#include "guarded.hpp"

namespace turgor::cli {

struct RunArguments {
  CaseArguments input;
  std::string directory;
  bool force = false;
  bool no_pictures = false;
  bool quiet = false;
  bool verbose = false;
};

struct DocArguments {
  std::string table;
  bool json = false;
};

struct AsymptoticsArguments {
  CaseArguments input;
  std::optional<double> from;
};

int run_case_file(const RunArguments& arguments);
int print_info(const CaseArguments& arguments);
int print_asymptotics(const AsymptoticsArguments& arguments);
int validate_case_file(const CaseArguments& arguments);
int print_documentation(const DocArguments& arguments);
int print_materials(bool json);

}  // namespace turgor::cli
