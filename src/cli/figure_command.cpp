// turgor figure: the paper's figures and some more, from the case files that ship.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "progress.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/figures/figures.hpp"

namespace turgor::cli {

namespace {

namespace fs = std::filesystem;

int list_figures(bool json) {
  if (json) {
    std::cout << figures_json(all_figures());
    return exit_done;
  }
  for (const Figure& figure : all_figures()) {
    std::cout << "  " << figure.name << std::string(figure.name.size() < 13 ? 13 - figure.name.size() : 1, ' ')
              << figure.title << "\n";
  }
  std::cout << "  all          all of them\n";
  return exit_done;
}

std::vector<const Figure*> wanted_figures(const std::string& name) {
  if (name != "all") return {&find_figure(name)};
  std::vector<const Figure*> all;
  all.reserve(all_figures().size());
  for (const Figure& figure : all_figures()) all.push_back(&figure);
  return all;
}

fs::path cases_folder(const std::string& given) {
  if (given.empty()) {
    std::error_code error;
    return shipped_cases(fs::read_symlink("/proc/self/exe", error));
  }
  std::error_code error;
  if (fs::is_directory(given, error)) return given;
  throw InvalidInput("--cases", "\"" + given + "\"", "is not a folder",
                     "name the folder that holds the case files, such as share/turgor/cases");
}

fs::path fem_folder(const FigureArguments& arguments) {
  if (arguments.fem.empty()) return {};
  const std::vector<std::string> showing{"3", "4", "5", "6", "all"};
  if (std::ranges::find(showing, arguments.name) == showing.end()) {
    throw InvalidInput("--fem", "\"" + arguments.fem + "\"", "figure " + arguments.name + " shows no finite elements",
                       "figures 3, 4, 5 and 6 do");
  }
  std::error_code error;
  if (fs::is_directory(arguments.fem, error)) return arguments.fem;
  throw InvalidInput("--fem", "\"" + arguments.fem + "\"", "is not a folder",
                     "name the folder that holds run directories of `turgor fem`, such as motion-orifice-30mm.fem");
}

/// As make_figure(), but of several figures one that fails or lacks its run does not end the others.
MadeFigure make_one_of(const Figure& figure, const fs::path& cases, const ResultFolder& folder, bool pictures,
                       const fs::path& fem) {
  if (const auto lacking = lacking_run(figure, {}, fem)) {  // by file names alone, which the index can keep
    return {&figure, {}, {}, {}, {}, lacking->problem + "; " + lacking->advice};
  }
  try {
    return make_figure(figure, cases, folder, pictures, fem);
  } catch (const std::exception& error) {
    return {&figure, {}, {}, error.what()};
  }
}

/// Warnings and errors; the exit code.
int report(const std::vector<MadeFigure>& made, bool quiet) {
  int code = exit_done;
  std::string problem;
  for (const MadeFigure& figure : made) {
    if (!figure.picture_problem.empty()) problem = figure.picture_problem;
    if (figure.failure.empty()) continue;
    std::cerr << "error: figure " << figure.figure->name << " was not made: " << figure.failure << "\n";
    code = exit_failed;
  }
  if (!problem.empty() && !quiet) std::cerr << "warning: " << problem << "\n";
  return code;
}

}  // namespace

CLI::App* add_figure(CLI::App& app, FigureArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "figure", "the paper's figures and some more, each with its numbers as CSV; without a name: which there are");
  command->add_option("name", arguments.name, "2, 3, 4, 5, 6, 7, 8, 9, decay, errors, bistability, design, or all")
      ->type_name("NAME");
  add_results(*command, arguments.results, "figure-NAME, or figures for all, in the current folder");
  command->add_option("--cases", arguments.cases, "folder of the case files; default: those that ship with turgor")
      ->type_name("DIR");
  command
      ->add_option(
          "--fem", arguments.fem,
          "folder of run directories, named CASE.fem, of `turgor fem flow` for figure 3, `turgor fem fsi` for 4 and 6, "
          "that they show too, and for 5, which needs one")
      ->type_name("DIR");
  command->add_flag("--json", arguments.json, "print one JSON document and nothing else");
  command->add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  return command;
}

int make_figures(const FigureArguments& arguments) {
  if (arguments.name.empty()) return list_figures(arguments.json);
  const std::vector<const Figure*> figures = wanted_figures(arguments.name);
  const bool all = arguments.name == "all";
  const fs::path cases = cases_folder(arguments.cases);
  const fs::path fem = fem_folder(arguments);
  if (!all) {
    if (const auto lacking = lacking_run(*figures.front(), cases, fem)) throw InvalidInput({*lacking});
  }
  const std::string directory = arguments.results.directory;
  const std::string usual = all ? "figures" : "figure-" + arguments.name;
  const ResultFolder folder(directory.empty() ? usual : directory, contents_of(figures), arguments.results.force);
  folder.write_first("index.md", figures_index({}));

  ProgressLine line("figures", static_cast<double>(figures.size()), !arguments.quiet && !arguments.json);
  std::vector<MadeFigure> made;
  for (const Figure* figure : figures) {
    const bool pictures = !arguments.results.no_pictures;
    made.push_back(all ? make_one_of(*figure, cases, folder, pictures, fem)
                       : make_figure(*figure, cases, folder, pictures, fem));
    folder.write("index.md", figures_index(made));  // now, so that it is there should a later figure never end
    line.reach(static_cast<double>(made.size()));
  }
  line.finish();
  const std::string json = figures_json(made, folder.path());
  folder.write("figures.json", json);
  if (arguments.json) {
    std::cout << json;
  } else if (!arguments.quiet) {
    for (const MadeFigure& figure : made) {
      for (const std::string& file : figure.files) std::cout << (folder.path() / file).string() << "\n";
    }
  }
  return report(made, arguments.quiet);
}

}  // namespace turgor::cli
