#pragma once
// The figures of the paper and of this documentation, made from the case files that ship.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "turgor/base/errors.hpp"
#include "turgor/run/result_folder.hpp"

namespace turgor {

/// A figure that can be made.
struct Figure {
  std::string name;                   ///< "3", "decay"
  std::string title;                  ///< one line
  std::string caption;                ///< what is seen and by which equations, Markdown
  std::vector<std::string> cases;     ///< case files that it needs
  std::vector<std::string> tables;    ///< its CSV files, without ending
  std::vector<std::string> pictures;  ///< its pictures, without ending
  std::vector<std::string> films{};   ///< its films, without ending
  bool needs_fem = false;             ///< whether it shows nothing but a run of finite elements of its case
};

/// All of them, the paper's first.
[[nodiscard]] const std::vector<Figure>& all_figures();

/// @throws InvalidInput for an unknown name, with the names that there are
[[nodiscard]] const Figure& find_figure(const std::string& name);

/// The folder of the case files that ship: where they are installed with a program, or its source tree's.
/// @param program  the running program
/// @throws InvalidInput for --cases when there is neither
[[nodiscard]] std::filesystem::path shipped_cases(const std::filesystem::path& program);

/// What came of making a figure.
struct MadeFigure {
  const Figure* figure;
  std::vector<std::string> files;  ///< that were written, in the folder
  std::string picture_problem;     ///< why there are no pictures, in words for a warning; empty when there are
  std::string failure;             ///< why it could not be made; empty when it was
  std::string note{};              ///< what this one has beyond the caption, Markdown
  std::string lacking{};           ///< the run of finite elements without which there is nothing to make; else empty
};

/// What a figure cannot be made without, and the command that computes it; nothing when it is there.
/// @param cases  folder of the case files, for the command
/// @param fem    folder of run directories of `turgor fem`; empty: none
[[nodiscard]] std::optional<Issue> lacking_run(const Figure& figure, const std::filesystem::path& cases,
                                               const std::filesystem::path& fem);

/// What a folder of some figures holds.
[[nodiscard]] ResultFolder::Contents contents_of(std::span<const Figure* const> figures);

/// Computes a figure and writes its tables, as NAME.csv, and pictures.
/// @param cases     folder of the case files
/// @param folder    made with contents_of()
/// @param pictures  whether to draw
/// @param fem       folder of run directories of `turgor fem`, CASE.fem, to show; empty: none
/// @throws InvalidInput when a case file or a run cannot be read; ComputationFailed when a file cannot be
/// written
[[nodiscard]] MadeFigure make_figure(const Figure& figure, const std::filesystem::path& cases,
                                     const ResultFolder& folder, bool pictures, const std::filesystem::path& fem = {});

/// index.md: every figure that was made with its caption, case files, tables and the command that makes it; and what
/// failed.
[[nodiscard]] std::string figures_index(std::span<const MadeFigure> made);

/// A list of figures, of those made with their files, as one JSON document.
[[nodiscard]] std::string figures_json(std::span<const Figure> figures);
[[nodiscard]] std::string figures_json(std::span<const MadeFigure> made, const std::filesystem::path& folder);

}  // namespace turgor
