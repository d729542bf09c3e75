#pragma once
// What each command does once its arguments are known. Each returns the program's exit code.

#include <functional>
#include <string>
#include <vector>

namespace turgor::cli {

inline constexpr int exit_done = 0;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_expectation_missed = 3;
inline constexpr int exit_failed = 4;
inline constexpr int exit_interrupted = 130;

struct CaseArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool json = false;
};

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

/// Runs a command and turns what it throws into messages on standard error and an exit code. With `json` the issues are
/// also printed as a JSON document on standard output.
int guarded(bool json, const std::function<int()>& command);

int run_case_file(const RunArguments& arguments);
int print_info(const CaseArguments& arguments);
int validate_case_file(const CaseArguments& arguments);
int print_documentation(const DocArguments& arguments);
int print_materials(bool json);

}  // namespace turgor::cli
