#pragma once
// What pictures have in common.

#include <string>

#include "curves.hpp"

namespace turgor {

// Blue, vermilion, green and orange of M. Okabe & K. Ito's palette, told apart by every kind of colour vision and in
// grey.
inline constexpr const char* blue = "#0072B2";
inline constexpr const char* vermilion = "#D55E00";
inline constexpr const char* green = "#009E73";
inline constexpr const char* orange = "#E69F00";

/// Data blocks and the plot command that shows them; empty curves are left out.
class Plot {
 public:
  void add(const std::string& name, const Curve& curve, const std::string& style);
  [[nodiscard]] const std::string& data() const { return data_; }
  [[nodiscard]] std::string command() const { return command_ + "\n"; }

 private:
  std::string data_;
  std::string command_;
};

/// @param dashes  gnuplot's dash type, a pattern in quotes or a number; solid when empty
[[nodiscard]] std::string line_style(const char* colour, const std::string& title, const std::string& dashes = {});

/// Such that the axis of a curve gets three to six tics.
[[nodiscard]] double tic_step(const Curve& curve);

}  // namespace turgor
