#pragma once
// turgor fem statics: the elastic wall at rest.

#include <string>

#include "arguments.hpp"

namespace turgor::cli {

struct FemStaticsArguments {
  CaseArguments input;
  ResultArguments results;
  std::string up_to;
  std::string pressure;
  std::string volume;
  bool limit_point = false;
};

/// Declares `statics` with its arguments, which must outlive `fem`.
CLI::App* add_fem_statics(CLI::App& fem, FemStaticsArguments& arguments);

/// Runs it and returns the exit code.
int print_fem_statics(const FemStaticsArguments& arguments);

}  // namespace turgor::cli
