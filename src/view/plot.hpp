#pragma once
// What pictures have in common.

#include <string>
#include <utility>

#include "curves.hpp"

namespace turgor {

// Blue, vermilion, green, orange and purple of M. Okabe & K. Ito's palette, told apart by every kind of colour vision
// and in grey.
inline constexpr const char* blue = "#0072B2";
inline constexpr const char* vermilion = "#D55E00";
inline constexpr const char* green = "#009E73";
inline constexpr const char* orange = "#E69F00";
inline constexpr const char* purple = "#CC79A7";

/// Data blocks and the plot command that shows them; empty curves are left out.
class Plot {
 public:
  /// @param prefix  of the names of its data blocks, where a script has several plots
  explicit Plot(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  void add(const std::string& name, const Curve& curve, const std::string& style);
  [[nodiscard]] const std::string& data() const { return data_; }
  [[nodiscard]] std::string command() const { return command_ + "\n"; }

 private:
  std::string prefix_;
  std::string data_;
  std::string command_;
};

/// @param dashes  gnuplot's dash type, a pattern in quotes or a number; solid when empty
[[nodiscard]] std::string line_style(const char* colour, const std::string& title, const std::string& dashes = {});

/// Dash types in use: what is unstable, what is thin, what is neither.
inline const std::string unstable_dashes = "(9,6)";
inline const std::string fine_dashes = "(4,7)";
inline const std::string dots_and_dashes = "(24,8,4,8)";

/// @param type  gnuplot's point type: 7 is a disc, 5 a square
[[nodiscard]] std::string points_style(const char* colour, const std::string& title, int type = 7,
                                       const char* size = "0.7");

/// A command that puts tics at 1, 2 and 5 times powers of ten on a y axis of square roots, as far as there is room.
/// @param sign  of the values
[[nodiscard]] std::string root_tics(double greatest, int sign);

/// The command that places the next plot of a multiplot between two heights, in shares of the picture.
[[nodiscard]] std::string panel_between(double bottom, double top);

/// Such that the axis of a curve gets three to six tics.
[[nodiscard]] double tic_step(const Curve& curve);

}  // namespace turgor
