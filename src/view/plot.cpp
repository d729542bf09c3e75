#include "plot.hpp"

#include <algorithm>
#include <cmath>

#include "gnuplot.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

void Plot::add(const std::string& name, const Curve& curve, const std::string& style) {
  if (curve.empty()) return;
  data_ += "$" + prefix_ + name + " << EOD\n";
  for (const CurvePoint& point : curve) {
    if (point.gap) data_ += "\n";
    data_ += rounded(point.x, 10) + " " + rounded(point.y, 10) + "\n";
  }
  data_ += "EOD\n";
  command_ += (command_.empty() ? "plot $" : ", \\\n     $") + prefix_ + name + " with " + style;
}

std::string line_style(const char* colour, const std::string& title, const std::string& dashes) {
  return "lines lw 2 lc rgb '" + std::string(colour) + "' " + (dashes.empty() ? "" : "dt " + dashes + " ") +
         (title.empty() ? "notitle" : "title '" + title + "'");
}

std::string points_style(const char* colour, const std::string& title, int type, const char* size) {
  return "points pt " + std::to_string(type) + " ps " + size + " lc rgb '" + colour + "' " +
         (title.empty() ? "notitle" : "title '" + title + "'");
}

std::string root_tics(double greatest, int sign) {
  std::string list = "set ytics (0";
  constexpr double crowded = 0.025;
  for (double value = round_step(greatest); value > crowded * greatest; value = round_step(0.75 * value)) {
    list += ", " + rounded(sign * value, 3);
  }
  return list + ")\n";
}

std::string panel_between(double bottom, double top) {
  return "set bmargin at screen " + rounded(bottom) + "; set tmargin at screen " + rounded(top) + "\n";
}

double tic_step(const Curve& curve) {
  const auto [low, high] = std::ranges::minmax(curve, {}, &CurvePoint::y);
  return round_step(std::max(high.y - low.y, 1e-3 * std::abs(high.y) + 1e-9) / 3);
}

}  // namespace turgor
