#include "pictures.hpp"

#include <array>
#include <iostream>
#include <sstream>
#include <string>

#include "view/gnuplot.hpp"

namespace turgor::bench {

namespace {

struct Method {
  const char* key;
  const char* title;
  const char* style;
};
// Colours of M. Okabe & K. Ito, told apart by every kind of colour vision.
constexpr std::array<Method, 4> methods{{{"seconds", "this program", "lc rgb '#000000' lw 2.5 pt 7"},
                                         {"odeint_seconds", "Odeint, best", "lc rgb '#0072b2' lw 1.5 pt 5"},
                                         {"cvode_adams_seconds", "CVODE Adams", "lc rgb '#e69f00' lw 1.5 pt 9"},
                                         {"cvode_bdf_seconds", "CVODE BDF", "lc rgb '#d55e00' lw 1.5 pt 11"}}};

/// The four trajectories that span the field: stiff to none, free and forced.
struct Panel {
  const char* name;
  const char* title;
};

void draw(const std::filesystem::path& folder, const char* name, const std::string& data, const std::string& commands) {
  const std::string wrong = gnuplot(folder, name, data, commands);
  if (!wrong.empty()) std::cerr << name << ": " << wrong << "\n";
}

std::string block(const std::string& name, const std::string& rows) {
  return "$" + name + " << EOD\n" + rows + "EOD\n";
}

}  // namespace

void draw_work_precision(const nlohmann::ordered_json& entries, const std::filesystem::path& folder) {
  constexpr std::array<Panel, 4> panels{
      {{"forced (2.22) r_ch=0.01 L_ch=0.0 R0=1.0", "filled and emptied, 1 cm orifice"},
       {"forced (2.22) r_ch=0.03 L_ch=0.0 R0=1.0", "filled and emptied, 3 cm orifice"},
       {"forced (2.22) r_ch=0.015 L_ch=0.5 R0=1.0", "filled and emptied, 1.5 cm channel"},
       {"free (2.22) r_ch=0.03 L_ch=0.5 R0=1.35 P=41314", "set free, 3 cm channel"}}};
  std::string data;
  std::string commands =
      "set multiplot layout 2,2 margins 0.10,0.97,0.11,0.95 spacing 0.12,0.18\n"
      "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset xrange [*:*] reverse\n"
      "set xtics font ',11'\nset ytics font ',11'\nset mxtics 1\nset ylabel 'time [s]' font ',11' offset 2.2\n"
      "set xlabel 'greatest error of R' offset 0,0.8\nset yrange [5e-6:0.5]\nset key off\n";
  for (std::size_t panel = 0; panel < panels.size(); ++panel) {
    std::string plot;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      std::ostringstream rows;
      for (const auto& entry : entries) {
        if (entry.at("case") != panels[panel].name || entry.at(methods[m].key).is_null()) continue;
        rows << entry.at("error").get<double>() << ' ' << entry.at(methods[m].key).get<double>() << '\n';
      }
      if (rows.str().empty()) continue;
      const std::string name = "curve" + std::to_string(panel) + std::to_string(m);
      data += block(name, rows.str());
      plot += (plot.empty() ? "plot $" : ", $") + name + " with linespoints " + methods[m].style + " title " +
              quoted(methods[m].title);
    }
    commands += "set title " + quoted(panels[panel].title) + " offset 0,-0.6\n";
    if (panel + 1 == panels.size()) commands += "set key top left reverse Left samplen 2 spacing 0.8 font ',12'\n";
    commands += plot + "\nset key off\n";
  }
  draw(folder, "work-precision", data, commands + "unset multiplot\n");
}

void draw_valve(const ValveComparison& valve, const std::filesystem::path& folder) {
  const auto rows = [](const std::map<double, std::vector<double>>& records) {
    std::ostringstream out;
    for (const auto& [q, record] : records) {
      for (const double value : record) {
        if (std::isfinite(value)) out << q << ' ' << value << '\n';
      }
    }
    return out.str();
  };
  const std::string panel =
      " using 1:($2 > 0 ? $2 : 1/0) with points pt 7 ps 0.08 lc rgb '#000000' title 'maxima of y_1', '' using 1:($2 < "
      "0 ? "
      "$2 : 1/0) with points pt 7 ps 0.08 lc rgb '#d55e00' title 'y_2 at impacts'\n";
  const std::string commands =
      "set multiplot layout 1,2 margins 0.07,0.97,0.12,0.92 spacing 0.08,0\n"
      "set xrange [0:10]\nset xtics 2\nset yrange [-6:10]\nset xlabel 'q'\nset key top left samplen 0.5\n"
      "set title 'this program' offset 0,-0.6\nplot $ours" +
      panel + "set title 'Boost.Odeint' offset 0,-0.6\nset key off\nplot $odeint" + panel + "unset multiplot\n";
  draw(folder, "valve", block("ours", rows(valve.ours)) + block("odeint", rows(valve.odeint)), commands);
}

}  // namespace turgor::bench
