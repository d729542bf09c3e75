#include "turgor/view/coefficient_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gnuplot.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

// M. Okabe & K. Ito's palette, told apart by every kind of colour vision.
constexpr const char* black = "#000000";
constexpr const char* blue = "#0072B2";
constexpr const char* vermilion = "#D55E00";
constexpr const char* sky = "#56B4E9";
constexpr const char* orange = "#E69F00";
constexpr const char* green = "#009E73";
constexpr const char* purple = "#CC79A7";

struct Series {
  std::string title;
  std::string colour;
  int width;  ///< wider below another line
  double (*error)(const CoefficientRow&);
};

const std::vector<Series>& error_series() {
  static const std::vector<Series> series{
      {"g_1 (2.9a)", black, 2, [](const CoefficientRow& r) { return r.paper.g1 / r.exact.g1 - 1; }},
      {"g_2 (2.9b)", sky, 5, [](const CoefficientRow& r) { return r.paper.g2 / r.exact.g2 - 1; }},
      {"g_4 (2.9c)", purple, 2, [](const CoefficientRow& r) { return r.paper.g4 / r.exact.g4 - 1; }},
      {"g_3 (2.10a)", blue, 2, [](const CoefficientRow& r) { return r.paper.g3 / r.exact.g3 - 1; }},
      {"g_5 (2.10b)", vermilion, 2, [](const CoefficientRow& r) { return r.paper.g5 / r.exact.g5 - 1; }},
      {"g_3 closer", green, 2, [](const CoefficientRow& r) { return r.close.g3 / r.exact.g3 - 1; }},
      {"g_5 closer", orange, 2, [](const CoefficientRow& r) { return r.close.g5 / r.exact.g5 - 1; }},
  };
  return series;
}

std::string kappa_axis(double least, double greatest) {
  return "set logscale x\nset xrange [" + rounded(least, 9) + ":" + rounded(greatest, 9) +
         "]\nset xlabel '{/Symbol k} = r_{ch}/r [1]'\nset format x '%g'\nset xtics (1e-5, 2e-5, 5e-5, 1e-4, 2e-4, "
         "5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1)\n";
}

std::string points_if_few(std::size_t count, int width) {
  return (count > 30 ? "lines lw " : "linespoints pt 7 ps 0.4 lw ") + std::to_string(width);
}

}  // namespace

std::string draw_coefficients(const std::vector<CoefficientRow>& rows, const std::filesystem::path& folder) {
  std::string data = "$errors << EOD\n";
  for (const CoefficientRow& row : rows) {
    data += rounded(row.kappa, 9);
    for (const Series& series : error_series()) data += " " + rounded(100 * std::abs(series.error(row)), 6);
    data += "\n";
  }
  data += "EOD\n";
  std::string commands = "set title 'Force coefficients: errors of their approximations'\n";
  commands += kappa_axis(rows.front().kappa, rows.back().kappa);
  commands += "set logscale y\nset yrange [1e-6:100]\nset format y '10^{%T}'\nset ylabel 'relative error [%]'\n";
  commands += "set key outside right top reverse Left font ',13' spacing 1.2\n";
  std::string plots;
  for (std::size_t i = 0; i < error_series().size(); ++i) {
    const Series& series = error_series()[i];
    plots += (plots.empty() ? "plot $errors using 1:" : ", \\\n     '' using 1:") + std::to_string(i + 2) + " with " +
             points_if_few(rows.size(), series.width) + " lc rgb '" + series.colour + "' title '" + series.title + "'";
  }
  for (const auto& [percent, whose] :
       {std::pair{"0.3", "g_1, g_2, g_4"}, std::pair{"1", "g_3"}, std::pair{"5", "g_5"}}) {
    plots += std::string(", \\\n     ") + percent + " with lines dt 2 lw 1 lc rgb 'grey40' title 'claimed: " + percent +
             " %, " + whose + "'";
  }
  constexpr PictureSize size{900, 560};
  return gnuplot(folder, "coefficients", data, commands + plots + "\n", size);
}

std::string draw_profile(const ProfileStudy& study, const std::filesystem::path& folder) {
  std::string data = "$profile << EOD\n";
  constexpr int points = 400;
  for (int k = 0; k <= points; ++k) {
    const double upsilon = static_cast<double>(k) / points;
    data += rounded(upsilon, 6) + " " + rounded(study.profile(upsilon), 7) + "\n";
  }
  data += "EOD\n$knots << EOD\n";
  for (const double knot : study.profile.knots()) {
    data += rounded(knot, 9) + " " + rounded(study.profile(knot), 7) + "\n";
  }
  data += "EOD\n$factors << EOD\n";
  for (const ProfileRow& row : study.rows) {
    data += rounded(row.kappa, 9) + " " + rounded(row.exact.inertial, 9) + " " + rounded(row.exact.centripetal, 9) +
            " " + rounded(row.paper.inertial, 9) + " " + rounded(row.paper.centripetal, 9) + "\n";
  }
  data += "EOD\n";
  std::string commands = "set multiplot layout 1,2\nunset key\nset offsets 0,0,graph 0.08,0\n";
  commands += "set xlabel 'distance from the axis {/Symbol U} = r/r_{ch} [1]'\nset ylabel 'f({/Symbol U}) [1]'\n";
  commands += "set xrange [0:1]\nset title 'normalised profile, momentum factor " +
              rounded(study.profile.momentum_factor(), 5) + "' font ',14'\n";
  commands += "plot $profile with lines lw 2 lc rgb '" + std::string(blue) +
              "', $knots with points pt 7 ps 0.5 lc rgb '" + blue + "', 1 with lines dt 2 lw 1 lc rgb 'grey40'\n";
  const double least = study.rows.front().kappa;
  const double greatest = study.rows.back().kappa;
  commands += kappa_axis(least < greatest ? least : least / 2, least < greatest ? greatest : 2 * least);
  commands += "set ylabel 'factor over uniform outflow [1]'\nset title 'forces of the liquid' font ',14'\n";
  commands += "set key center right font ',12'\nset offsets 0,0,graph 0.08,graph 0.08\n";
  const std::string style = points_if_few(study.rows.size(), 2) + " lc rgb '";
  commands += "plot $factors using 1:2 with " + style + blue + "' title 'inertial', \\\n     '' using 1:3 with " +
              style + vermilion +
              "' title 'centripetal', \\\n     '' using 1:4 with points pt 6 ps 0.9 lw 1.2 lc rgb '" + blue +
              "' title 'inertial, paper', \\\n     '' using 1:5 with points pt 6 ps 0.9 lw 1.2 lc rgb '" + vermilion +
              "' title 'centripetal, paper'\nunset multiplot\n";
  constexpr PictureSize size{1000, 480};
  return gnuplot(folder, "profile", data, commands, size);
}

}  // namespace turgor
