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

struct FlowArguments {
  CaseArguments input;
  ResultArguments results;
  std::string at;
  std::string profile;
  int resolution = 200;
  bool quiet = false;
};

struct StaticsArguments {
  CaseArguments input;
  ResultArguments results;
  std::vector<std::string> over;
  std::string compliance;
};

struct CoefficientArguments {
  ResultArguments results;
  std::string kappa;
  std::string profile;
  int harmonics = 0;  ///< 0: no truncated sums
  bool json = false;
};

struct ProfileArguments {
  ResultArguments results;
  std::string file;
  std::string kappa = "1/200:1/10:9";
  int harmonics = 20'000;  ///< the paper's
  bool json = false;
};

struct PortraitArguments {
  CaseArguments input;
  ResultArguments results;
  std::string pressure;
  std::string stretches;
  std::string rates;
  bool quiet = false;
};

struct VerifyArguments {
  CaseArguments input;
  ResultArguments results;
  std::string fem;
  bool quiet = false;
};

struct FigureArguments {
  std::string name;
  std::string cases;
  std::string fem;
  ResultArguments results;
  bool json = false;
  bool quiet = false;
};

// Each declares a command with its arguments, which must outlive `app`.
CLI::App* add_statics(CLI::App& app, StaticsArguments& arguments);
CLI::App* add_flow(CLI::App& app, FlowArguments& arguments);
CLI::App* add_portrait(CLI::App& app, PortraitArguments& arguments);
CLI::App* add_coefficients(CLI::App& app, CoefficientArguments& arguments);
CLI::App* add_profile(CLI::App& app, ProfileArguments& arguments);
CLI::App* add_verify(CLI::App& app, VerifyArguments& arguments);
CLI::App* add_figure(CLI::App& app, FigureArguments& arguments);

struct AsymptoticsArguments {
  CaseArguments input;
  std::optional<double> from;
};

int run_case_file(const RunArguments& arguments);
int write_force_history(const ForceArguments& arguments);
int print_info(const CaseArguments& arguments);
int print_asymptotics(const AsymptoticsArguments& arguments);
int validate_case_file(const CaseArguments& arguments);
int print_documentation(const DocArguments& arguments);
int print_materials(bool json);
int print_statics(const StaticsArguments& arguments);
int write_flow(const FlowArguments& arguments);
int write_portrait(const PortraitArguments& arguments);
int print_coefficients(const CoefficientArguments& arguments);
int print_profile(const ProfileArguments& arguments);
int verify_case(const VerifyArguments& arguments);
int make_figures(const FigureArguments& arguments);

}  // namespace turgor::cli
