#pragma once
// What every figure is made with: case files to read, tables and pictures to write.

#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "../view/gnuplot.hpp"
#include "../view/plot.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/figures/figures.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {

/// A CSV table.
class Table {
 public:
  using Cell = std::variant<double, std::string>;

  /// @param header  names of the columns with their units
  explicit Table(const std::string& header) : text_(header + "\n") {}

  /// A number that is none, such as an approximation outside of its range, leaves its cell empty.
  void add(const std::vector<Cell>& row);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Makes one figure.
class Studio {
 public:
  Studio(const Figure& figure, std::filesystem::path cases, const ResultFolder& folder, bool pictures,
         std::filesystem::path fem)
      : figure_(figure),
        cases_(std::move(cases)),
        folder_(folder),
        pictures_(pictures),
        fem_(std::move(fem)),
        made_{&figure, {}, {}, {}} {}

  /// The figure's own case files.
  [[nodiscard]] const std::vector<std::string>& cases() const { return figure_.cases; }
  /// @throws InvalidInput as read_case()
  [[nodiscard]] Case read(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    return read_case(cases_ / name, overrides);
  }

  /// Folder of run directories of finite elements; empty when they are not shown.
  [[nodiscard]] const std::filesystem::path& fem() const { return fem_; }
  /// Adds a sentence to the caption.
  void say(const std::string& sentence) { made_.note += " " + sentence; }

  /// Writes NAME.csv.
  /// @throws ComputationFailed when it cannot be written
  void table(const std::string& name, const Table& table) { table_text(name, table.text()); }
  void table_text(const std::string& name, const std::string& text);

  /// Draws NAME.{svg,png} unless pictures are not wanted.
  /// @param draw  called with the folder, returns what went wrong
  template <class Draw>
  void picture(const std::string& name, const Draw& draw) {
    if (pictures_) note(name, draw(folder_.path()), {".svg", ".png", ".gp"});
  }
  /// @param commands  for gnuplot, after its data blocks
  void picture(const std::string& name, const std::string& data, const std::string& commands, PictureSize size) {
    picture(name, [&](const std::filesystem::path& folder) { return gnuplot(folder, name, data, commands, size); });
  }

  /// Draws NAME.gif and its frames unless pictures are not wanted, as gnuplot_film().
  void film(const std::string& name, std::size_t count, const std::function<FilmFrame(std::size_t)>& frame,
            PictureSize size, int pause);

  [[nodiscard]] const MadeFigure& made() const { return made_; }

 private:
  void note(const std::string& name, const std::string& problem, const std::vector<std::string>& endings);

  const Figure& figure_;
  std::filesystem::path cases_;
  const ResultFolder& folder_;
  bool pictures_;
  std::filesystem::path fem_;
  MadeFigure made_;
};

/// Mean of the paper's limit pressures [Pa], the nominal pressure of its sections 3.3 and 3.4.
/// @throws InvalidInput when the balloon has not one maximum and one minimum
[[nodiscard]] double mean_limit_pressure(const Parameters<double>& p);

/// The override that holds a case at a pressure [Pa] for ever.
[[nodiscard]] std::string held_at(double pressure);

/// S = 4 d0 s2/r0 [Pa], the unit in which the paper states pressures of Mooney-Rivlin balloons: S2 = 1.
/// @throws InvalidInput for other materials
[[nodiscard]] double mooney_rivlin_unit(const Parameters<double>& p);

/// An approximation where it has a value; not a number where it refuses.
template <class Function>
[[nodiscard]] double where_defined(const Function& approximation) {
  try {
    return approximation();
  } catch (const InvalidInput&) {
    return std::nan("");
  }
}

/// From dark to bright, the first of `count` being the darkest.
[[nodiscard]] const char* tone(std::size_t index, std::size_t count);

/// "set lmargin at screen ...": where a panel of a picture lies, in shares of it.
[[nodiscard]] std::string panel(double left, double right, double bottom, double top);

/// A row of the key across the whole picture, to end a multiplot with: its panels are too narrow for one.
/// @param y        its lower edge, as a share of the picture's height
/// @param entries  "lines lw 2 title 'exact'"
[[nodiscard]] std::string key_row(double y, const std::vector<std::string>& entries);

}  // namespace turgor
