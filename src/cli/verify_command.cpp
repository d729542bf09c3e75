// turgor verify: the model against finite elements.

#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/response_verification.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/run/verification.hpp"
#include "turgor/view/verification_picture.hpp"

namespace turgor::cli {

namespace {

namespace fs = std::filesystem;

/// A word as one types it into a shell.
std::string shell_word(const std::string& word) {
  if (word.find_first_of(" \t\"'$&;<>(){}[]*?!|\\~#`") == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The command that computes what is missing, where this turgor can.
std::string how_to_compute(const VerifyArguments& arguments, const Case& c, const fs::path& folder) {
  std::string command = std::string("turgor fem ") + (c.motion ? "flow " : "fsi ") + shell_word(arguments.input.file) +
                        " -o " + shell_word(folder.string());
  for (const std::string& override : arguments.input.overrides) command += " --set " + shell_word(override);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path() / "turgor-fem";
  const std::string lacking = fs::exists(program, error) ? "" : ", which needs a turgor built with `./dev build fem`";
  return "compute it: `" + command + "`" + lacking + "; or name another with --fem DIR";
}

fs::path fem_folder(const VerifyArguments& arguments, const Case& c) {
  const fs::path folder = arguments.fem.empty() ? c.file.stem().string() + ".fem" : arguments.fem;
  std::error_code error;
  if (fs::is_directory(folder, error)) return folder;
  throw InvalidInput("--fem", "\"" + folder.string() + "\"", "there is no such folder of finite elements",
                     how_to_compute(arguments, c, folder));
}

ResultFolder result_folder(const VerifyArguments& arguments, const Case& c, const fs::path& fem) {
  const std::string& given = arguments.results.directory;
  const fs::path path = given.empty() ? c.file.stem().string() + ".verify" : given;
  std::error_code error;
  if (fs::equivalent(path, fem, error)) {
    throw InvalidInput("-o", "\"" + path.string() + "\"", "is the folder of the finite elements", "choose another");
  }
  return {path,
          {"verification directory", {"case.toml", "resolved.toml", "verify.csv", "verify.json"}, {"verify"}},
          arguments.results.force};
}

/// Writes, draws and prints either kind of verification.
template <class AnyVerification>
void report(const VerifyArguments& arguments, const Case& c, const fs::path& fem, const AnyVerification& verification) {
  const ResultFolder folder = result_folder(arguments, c, fem);
  folder.write_first("case.toml", c.source);
  folder.write("resolved.toml", c.resolved);
  folder.write("verify.csv", verification_csv(c, verification));
  const std::string json = verification_json(c, verification);
  folder.write("verify.json", json);
  std::string problem;
  if (c.output.pictures && !arguments.results.no_pictures) problem = draw_verification(c, verification, folder.path());
  if (arguments.input.json) {
    std::cout << json;
  } else if (!arguments.quiet) {
    std::cout << verification_summary(c, verification) << "  written to " << folder.path().string() << "\n";
  }
  if (!problem.empty() && !arguments.quiet) std::cerr << "warning: " << problem << "\n";
}

}  // namespace

CLI::App* add_verify(CLI::App& app, VerifyArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "verify",
      "the model against finite elements: the forces of all closures under the motion that a case dictates, or, "
      "without a [motion] table, the radius of the elastic balloon");
  add_case(*command, arguments.input);
  command
      ->add_option("--fem", arguments.fem,
                   "run directory of `turgor fem flow`, or fsi without a [motion] table; default: the case file's name "
                   "with .fem, in the current folder")
      ->type_name("DIR");
  add_results(*command, arguments.results, "the case file's name with .verify, in the current folder");
  command->add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  return command;
}

int verify_case(const VerifyArguments& arguments) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  const fs::path fem = fem_folder(arguments, c);
  if (c.motion) {
    report(arguments, c, fem, verify(c, read_fem_history(c, fem)));
  } else {
    report(arguments, c, fem, verify_response(c, read_fem_response(c, fem)));
  }
  return exit_done;
}

}  // namespace turgor::cli
