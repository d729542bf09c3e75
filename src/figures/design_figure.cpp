// A map for designers: how long balloons of all openings take to fill and to empty.

#include <algorithm>
#include <cmath>

#include "makers.hpp"
#include "motion.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/case_template.hpp"
#include "turgor/case/quantities.hpp"

namespace turgor {

namespace {

constexpr int grid = 25;
constexpr double pressure = 36e3;  ///< that of the programs of figures 4 and 6 [Pa]

struct Opening {
  double radius;  ///< [m]
  double length;  ///< [m]
};

std::vector<Opening> openings() {
  std::vector<Opening> all;
  for (const double length : in_equal_ratios(0.05, 2, grid)) {
    for (const double radius : in_equal_ratios(0.005, 0.03, grid)) all.push_back({radius, length});
  }
  return all;
}

std::size_t index_of(std::string_view quantity) {
  const auto& names = quantity_names();
  return static_cast<std::size_t>(std::ranges::find(names, quantity, &QuantityName::name) - names.begin());
}

/// A quantity of the first stroke of every opening's balloon, all else being as in a case.
std::vector<double> over_openings(const Case& c, const std::string& quantity) {
  CaseTemplate blank(c, {"inlet.orifice_radius", "inlet.channel_length"});
  std::vector<Member> members;
  for (const Opening& opening : openings()) {
    const std::vector<Node> values{{Node::Quantity{opening.radius, "m"}, "", 0},
                                   {Node::Quantity{opening.length, "m"}, "", 0}};
    members.push_back(make_member(blank.with(values), Model::full));
  }
  const std::vector<std::size_t> asked{index_of(quantity)};
  std::vector<MemberSummary> summaries(members.size());
  integrate_ensemble(members, needed_for(asked), summaries);
  std::vector<double> found;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto value = evaluate_quantities(members[i].oscillator, summaries[i], summaries[i].steps, asked).front();
    if (!is_complete(summaries[i].outcome) || !value) {
      throw ComputationFailed(c.title + ": no " + quantity + ": " + summaries[i].message);
    }
    found.push_back(*value);
  }
  return found;
}

/// Levels 1, 2, 3 and 5 times powers of ten within the values.
std::string levels(const std::vector<double>& values) {
  const auto [least, greatest] = std::ranges::minmax(values);
  std::string list;
  const auto least_power = static_cast<int>(std::floor(std::log10(least)));
  for (int exponent = least_power; std::pow(10, exponent) < greatest; ++exponent) {
    for (const double digit : {1.0, 2.0, 3.0, 5.0}) {
      const double level = digit * std::pow(10, exponent);
      if (level > least && level < greatest) list += (list.empty() ? "" : ",") + rounded(level, 3);
    }
  }
  return list;
}

/// A grid of values as a data block, rows of equal length apart.
std::string block(const std::string& name, const std::vector<double>& values) {
  std::string out = "$" + name + " << EOD\n";
  const std::vector<Opening> all = openings();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && i % grid == 0) out += "\n";
    out += rounded(all[i].radius * 100, 8) + " " + rounded(all[i].length * 100, 8) + " " + rounded(values[i], 8) + "\n";
  }
  return out + "EOD\n";
}

/// Colours and labelled contours of one block, in a panel.
std::string map_of(const std::string& name, const std::vector<double>& values, const std::string& title,
                   const std::string& place) {
  const auto [least, greatest] = std::ranges::minmax(values);
  const std::string points = "$" + name + " using 1:2:3 ";
  return place + "set title '" + title + "' offset 0,-0.5\nset cntrparam cubicspline levels discrete " +
         levels(values) + "\nset cbrange [" + rounded(least, 6) + ":" + rounded(greatest, 6) + "]\nsplot " + points +
         "with pm3d nocontour notitle, \\\n      " + points +
         "with lines nosurface lw 1.6 lc rgb 'white' notitle, \\\n      " + points +
         "with labels nosurface boxed notitle\n";
}

}  // namespace

void make_design_figure(Studio& studio) {
  const std::string& name = studio.cases().front();
  const std::vector<std::string> first_stroke{"model.name=full", "solve.max_events=1", "solve.t_end=1e5 s",
                                              "expect={}"};
  const auto read = [&](double held, double stretch) {
    std::vector<std::string> overrides = first_stroke;
    overrides.push_back(held_at(held));
    overrides.push_back("initial.stretch=" + shortest(stretch));
    return studio.read(name, overrides);
  };
  const Case filling = read(pressure, 1);
  const double filled = equilibria(filling.parameters, pressure).front().stretch;
  const Case emptying = read(0, filled);
  const std::vector<double> rise = over_openings(filling, "rise_time");
  const std::vector<double> fall = over_openings(emptying, "fall_time");

  Table table("r_ch [m],L_ch [m],rise time [s],fall time [s]");
  const std::vector<Opening> all = openings();
  for (std::size_t i = 0; i < all.size(); ++i) table.add({all[i].radius, all[i].length, rise[i], fall[i]});
  studio.table("figure-design", table);

  std::string commands =
      viridis_palette() + "set multiplot\nset logscale xycb\nset xrange [0.5:3]\nset yrange [5:200]\n";
  commands += "set xtics (0.5, 0.7, 1, 1.5, 2, 3) offset 0,0.3\nset ytics (5, 10, 20, 50, 100, 200)\nunset grid\n";
  commands += "set view map\nset pm3d interpolate 4,4\nset contour base\n";
  commands += "set cntrlabel onecolor start 15 interval 1000 font ',11'\n";
  commands += "set style textbox opaque fillcolor rgb 'white' noborder margins 0.6,0.4\n";
  commands += "set xlabel 'radius of the channel r_{ch} [cm]'\nset ylabel 'its length L_{ch} [cm]' offset 1\n";
  commands += "set label 1 " + quoted("Pressure stepped from 0 to 36 kPa and back") + " at screen 0.5,0.965 center\n";
  commands += map_of("rise", rise, "10 % to 90 % filled [s]", panel(0.09, 0.42, 0.14, 0.87));
  commands += "unset label 1\n" + map_of("fall", fall, "10 % to 90 % emptied [s]", panel(0.585, 0.915, 0.14, 0.87));
  studio.picture("figure-design", block("rise", rise) + block("fall", fall), commands + "unset multiplot\n",
                 {1200, 560});
}

}  // namespace turgor
