#include "studio.hpp"

#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

void Table::add(const std::vector<Cell>& row) {
  for (const Cell& cell : row) {
    if (const auto* number = std::get_if<double>(&cell)) {
      if (std::isfinite(*number)) text_ += shortest(*number + 0.0);  // -0 becomes 0
    } else {
      text_ += std::get<std::string>(cell);
    }
    text_ += ',';
  }
  text_.back() = '\n';
}

void Studio::table_text(const std::string& name, const std::string& text) {
  folder_.write(name + ".csv", text);
  made_.files.push_back(name + ".csv");
}

void Studio::film(const std::string& name, std::size_t count, const std::function<FilmFrame(std::size_t)>& frame,
                  PictureSize size, int pause) {
  if (pictures_) note(name, gnuplot_film(folder_.path(), name, count, frame, size, pause), {"", ".gif", ".gp"});
}

void Studio::note(const std::string& name, const std::string& problem, const std::vector<std::string>& endings) {
  if (!problem.empty()) {
    made_.picture_problem = problem;
    return;
  }
  for (const std::string& ending : endings) made_.files.push_back(name + ending);
}

double mean_limit_pressure(const Parameters<double>& p) {
  const std::vector<LimitPoint> points = limit_points(p);
  if (points.size() != 2) {
    throw InvalidInput("material", "", "the static pressure has not one maximum and one minimum",
                       "this figure shows a balloon with two stable states; a Mooney-Rivlin one with s1/s2 > 4.663 "
                       "has them");
  }
  return (points[0].pressure + points[1].pressure) / 2;
}

std::string held_at(double pressure) { return "pressure={constant=\"" + shortest(pressure) + " Pa\"}"; }

double mooney_rivlin_unit(const Parameters<double>& p) {
  const auto* solid = std::get_if<MooneyRivlin<double>>(&p.material);
  if (solid == nullptr) {
    throw InvalidInput("material.model", "", "this figure is one of Mooney-Rivlin balloons", "write \"mooney-rivlin\"");
  }
  return 4 * p.thickness * solid->s2 / p.radius;
}

const char* tone(std::size_t index, std::size_t count) {
  constexpr std::size_t brightest = 6;  // beyond, lines pale on white
  return viridis.at(count < 2 ? 0 : index * brightest / (count - 1));
}

std::string panel(double left, double right, double bottom, double top) {
  return "set lmargin at screen " + rounded(left, 6) + "; set rmargin at screen " + rounded(right, 6) +
         "; set bmargin at screen " + rounded(bottom, 6) + "; set tmargin at screen " + rounded(top, 6) + "\n";
}

std::string key_row(double y, const std::vector<std::string>& entries) {
  std::string out = panel(0, 1, 0, 1) +
                    "unset border; unset tics; unset title; unset label; unset object; unset grid\n" +
                    "unset xlabel; unset ylabel; unset xzeroaxis\nset key at screen 0.5," + rounded(y, 6) +
                    " center bottom horizontal samplen 2.5\nplot [0:1] [0:1] 2 with lines notitle";
  for (const std::string& entry : entries) out += ", \\\n     keyentry with " + entry;
  return out + "\n";
}

}  // namespace turgor
