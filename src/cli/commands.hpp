#pragma once
// What each command does once its arguments are known. Each returns the program's exit code.

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

struct ForceArguments {
  CaseArguments input;
  std::string directory;
  bool force = false;
  bool no_pictures = false;
  bool quiet = false;
};

struct DocArguments {
  std::string table;
  bool json = false;
};

int run_case_file(const RunArguments& arguments);
int write_force_history(const ForceArguments& arguments);
int print_info(const CaseArguments& arguments);
int validate_case_file(const CaseArguments& arguments);
int print_documentation(const DocArguments& arguments);
int print_materials(bool json);

}  // namespace turgor::cli
