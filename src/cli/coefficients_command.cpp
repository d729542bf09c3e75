// turgor coefficients and turgor profile: the force of the liquid without a case.

#include <iostream>

#include "commands.hpp"
#include "numbers.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/case/profile.hpp"
#include "turgor/run/force_study.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/view/coefficient_pictures.hpp"

namespace turgor::cli {

namespace {

constexpr const char* kappa_help =
    "r_ch/r, one number or FROM:TO:N for N points in equal ratios; decimal or a fraction such as 1/100";
constexpr int most_harmonics = 10'000'000;
constexpr int most_profile_harmonics = 100'000;  // their quadrature takes time like the square

void check_harmonics(int harmonics, bool uniform) {
  if (!uniform && harmonics > most_profile_harmonics) {
    throw InvalidInput("--harmonics", std::to_string(harmonics), "too many for a profile that is not uniform",
                       "allowed are up to " + std::to_string(most_profile_harmonics));
  }
}

}  // namespace

CLI::App* add_coefficients(CLI::App& app, CoefficientArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("coefficients", "g1 ... g5 of the liquid's force (2.8), exact and by the paper's fits");
  command->add_option("--kappa", arguments.kappa, kappa_help)->required()->type_name("K | FROM:TO:N");
  command->add_option("--harmonics", arguments.harmonics, "also the paper's sums, truncated after so many harmonics")
      ->check(CLI::Range(1, most_harmonics))
      ->type_name("N");
  command
      ->add_option("--profile", arguments.profile,
                   "outflow profile of the exact values and the sums; the fits are for uniform outflow")
      ->type_name("FILE.csv");
  add_results(*command, arguments.results, "none, the table goes to the screen");
  command->add_flag("--json", arguments.json, "print one JSON array and nothing else");
  return command;
}

int print_coefficients(const CoefficientArguments& arguments) {
  const std::vector<double> kappas = kappa_values("--kappa", arguments.kappa);
  const OutflowProfile profile =
      arguments.profile.empty() ? OutflowProfile::uniform() : read_profile(arguments.profile);
  check_harmonics(arguments.harmonics, profile.is_uniform());
  const std::vector<CoefficientRow> rows = coefficient_table(kappas, profile, arguments.harmonics);
  std::string problem;
  const bool keeps = !arguments.results.directory.empty();
  if (keeps) {
    const ResultFolder folder(arguments.results.directory,
                              {"coefficients directory", {"coefficients.csv"}, {"coefficients"}},
                              arguments.results.force);
    folder.write_first("coefficients.csv", coefficients_csv(rows));
    if (rows.size() > 1 && !arguments.results.no_pictures) problem = draw_coefficients(rows, folder.path());
  }
  if (arguments.json) {
    std::cout << coefficients_json(rows);
  } else if (keeps) {
    std::cout << rows.size() << (rows.size() == 1 ? " row" : " rows") << " written to " << arguments.results.directory
              << "\n";
  } else {
    std::cout << coefficients_text(rows);
  }
  if (!problem.empty()) std::cerr << "warning: " << problem << "\n";
  return exit_done;
}

CLI::App* add_profile(CLI::App& app, ProfileArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("profile", "what an outflow profile makes of the liquid's inertial and centripetal forces");
  command
      ->add_option("profile", arguments.file,
                   "CSV file of two columns with units in their headers: \"Upsilon [1],f [1]\", or such as "
                   "\"radius [mm],velocity [m/s]\"")
      ->required()
      ->type_name("FILE.csv");
  command->add_option("--kappa", arguments.kappa, std::string(kappa_help) + "; default 1/200:1/10:9")
      ->type_name("K | FROM:TO:N");
  command->add_option("--harmonics", arguments.harmonics, "harmonics of the paper's sums; default 20000")
      ->check(CLI::Range(1, most_profile_harmonics))
      ->type_name("N");
  add_results(*command, arguments.results, "none, the table goes to the screen");
  command->add_flag("--json", arguments.json, "print one JSON document and nothing else");
  return command;
}

int print_profile(const ProfileArguments& arguments) {
  const ProfileStudy study =
      study_profile(read_profile(arguments.file), kappa_values("--kappa", arguments.kappa), arguments.harmonics);
  std::string problem;
  if (!arguments.results.directory.empty()) {
    const ResultFolder folder(arguments.results.directory, {"profile directory", {"profile.csv"}, {"profile"}},
                              arguments.results.force);
    folder.write_first("profile.csv", profile_csv(study));
    if (!arguments.results.no_pictures) problem = draw_profile(study, folder.path());
  }
  if (arguments.json) {
    std::cout << profile_json(study);
  } else {
    std::cout << profile_text(study);
    if (!arguments.results.directory.empty()) std::cout << "  written to " << arguments.results.directory << "\n";
  }
  if (!problem.empty()) std::cerr << "warning: " << problem << "\n";
  return exit_done;
}

}  // namespace turgor::cli
