// How far every closed approximation of section 3 is from the exact solution.

#include <algorithm>
#include <cmath>

#include "makers.hpp"
#include "motion.hpp"
#include "turgor/asymptotics/equilibria.hpp"
#include "turgor/asymptotics/matched_deflation.hpp"
#include "turgor/asymptotics/oscillation.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

/// Sizes of errors against one variable, by approximation.
class ErrorCurves {
 public:
  struct Style {
    std::string name;
    std::string line;
    std::string title{};  ///< in the picture, when it is not the name
  };

  /// @param name      of the table, without its beginning
  /// @param variable  header of the first column
  ErrorCurves(std::string name, const std::string& variable, std::vector<Style> styles)
      : name_(std::move(name)), styles_(std::move(styles)), curves_(styles_.size()), table_(header(variable)) {}

  /// @param errors  of each approximation, signed; not a number where it has no value
  void add(double x, const std::vector<double>& errors) {
    std::vector<Table::Cell> row{x};
    for (std::size_t i = 0; i < errors.size(); ++i) {
      row.emplace_back(errors[i]);
      const double size = std::abs(errors[i]);
      if (std::isfinite(size)) curves_.at(i).push_back({x, std::max(size, least), broken_.at(i)});
      broken_[i] = !std::isfinite(size);
    }
    table_.add(row);
  }

  void write(Studio& studio) const { studio.table("figure-errors-" + name_, table_); }
  [[nodiscard]] Plot plot() const {
    Plot plot(name_);
    for (std::size_t i = 0; i < styles_.size(); ++i) {
      plot.add(std::to_string(i), curves_[i],
               styles_[i].line + " title '" + (styles_[i].title.empty() ? styles_[i].name : styles_[i].title) + "'");
    }
    return plot;
  }

 private:
  [[nodiscard]] std::string header(const std::string& variable) const {
    std::string text = variable;
    for (const Style& style : styles_) text += ",error of " + style.name + " [1]";
    return text;
  }

  static constexpr double least = 1e-16;  // a logarithmic axis has no zero

  std::string name_;
  std::vector<Style> styles_;
  std::vector<Curve> curves_;
  std::vector<bool> broken_ = std::vector<bool>(styles_.size(), false);
  Table table_;
};

std::string thick(const char* colour, const std::string& dashes = "1") {
  return "lines lw 2 dt " + dashes + " lc rgb '" + colour + "'";
}

ErrorCurves equilibrium_errors(const Parameters<double>& p) {
  ErrorCurves curves("equilibria", "P0/S2 [1]", {{"(3.3)", thick(blue)}, {"(3.5)", thick(vermilion, unstable_dashes)}});
  const double unit = mooney_rivlin_unit(p);
  const std::vector<LimitPoint> limits = limit_points(p);
  constexpr int points = 240;
  constexpr double greatest = 9;
  for (const double P : evenly(greatest / points, greatest, points)) {
    const double pressure = P * unit;
    const auto states = equilibria(p, pressure);
    const double small =
        where_defined([&] { return small_equilibrium(p, pressure).stretch.value - states.front().stretch; });
    const double large = where_defined([&] { return large_equilibrium(p, pressure).value - states.back().stretch; });
    curves.add(P, {small, pressure > limits[1].pressure ? large : std::nan("")});
  }
  return curves;
}

ErrorCurves deflation_errors(const LargeMotion& large) {
  ErrorCurves curves("deflation", "T [1]",
                     {{"(3.9)", thick(green, unstable_dashes)},
                      {"(3.12)", thick(orange, dots_and_dashes)},
                      {"(3.16)", thick(vermilion)},
                      {"uniform", thick(blue)},
                      {"refined uniform", thick("black", fine_dashes)}});
  const double start = 5;
  const MatchedDeflation law(large.motion, start);
  constexpr double first = 0.01;
  constexpr int points = 60;
  for (const double T : in_equal_ratios(first, 0.999 * law.uniform().transition_time().value, points)) {
    const double R = large.exact_stretch(start, T);
    curves.add(T, {law.outer(T).value - R, law.inner(T).value - R, law.composite(T).value - R,
                   law.uniform().at(T).value - R, law.uniform().refined_at(T) - R});
  }
  return curves;
}

ErrorCurves inflation_errors(const LargeMotion& large) {
  ErrorCurves curves("inflation", "R_eq - R_i [1]",
                     {{"(3.18)", thick(vermilion, unstable_dashes)},
                      {"(3.19)", thick(blue)},
                      {"third order", thick("black", fine_dashes)}});
  const Oscillation law(large.motion, Regime::inflating);
  constexpr int points = 30;
  for (const double below : in_equal_ratios(1e-3, 0.6, points)) {
    std::vector<double> worst(3, 0);
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const double T = share * law.half_period(below).value * 0.98;  // the exact motion may turn a little earlier
      const double R = large.exact_stretch(large.motion.equilibrium() - below, T);
      const std::vector<double> errors{law.first_order(-below, T).value - R, law.second_order(-below, T).value - R,
                                       law.third_order(-below, T).value - R};
      for (std::size_t i = 0; i < errors.size(); ++i) {
        if (std::abs(errors[i]) > std::abs(worst[i])) worst[i] = errors[i];
      }
    }
    curves.add(below, worst);
  }
  return curves;
}

ErrorCurves time_errors(const LargeMotion& large) {
  ErrorCurves curves("times", "size of R_i - R_eq [1]",
                     {{"(3.17)", thick(vermilion)},
                      {"uniform", thick(blue)},
                      {"pi/alpha", thick(green, unstable_dashes), "π/α"},
                      {"corrected pi/alpha", thick("black", fine_dashes), "corrected π/α"}});
  const Oscillation inflation(large.motion, Regime::inflating);
  const double equilibrium = large.motion.equilibrium();
  constexpr double long_enough = 1e9;
  constexpr int points = 40;
  for (const double x : in_equal_ratios(3e-3, 0.6, points)) {
    const double down = large.exact(equilibrium + x, long_enough, 1).events.front().time;
    const double up = large.exact(equilibrium - x, long_enough, 1).events.front().time;
    curves.add(
        x,
        {where_defined(
             [&] { return MatchedDeflation(large.motion, equilibrium + x).transition_time().value / down - 1; }),
         where_defined([&] { return SlowDeflation(large.motion, equilibrium + x).transition_time().value / down - 1; }),
         inflation.half_period(-x).value / up - 1, inflation.corrected_half_period(-x).value / up - 1});
  }
  return curves;
}

}  // namespace

void make_errors_figure(Studio& studio) {
  const LargeMotion large = large_motion(studio, studio.cases().front());
  const ErrorCurves rests = equilibrium_errors(large.of.parameters);
  const ErrorCurves falls = deflation_errors(large);
  const ErrorCurves rises = inflation_errors(large);
  const ErrorCurves times = time_errors(large);
  for (const ErrorCurves* curves : {&rests, &falls, &rises, &times}) curves->write(studio);

  std::string data;
  std::string commands = "set multiplot\nset logscale y\nset format y '10^{%L}'\nset key font ',12' samplen 2.5\n";
  const auto draw = [&](const ErrorCurves& curves, const std::string& place, const std::string& axes) {
    const Plot plot = curves.plot();
    data += plot.data();
    commands += place + axes + plot.command();
  };
  draw(
      rests, panel(0.075, 0.485, 0.585, 0.945),
      "set title 'equilibria' offset 0,-0.6\nset xlabel 'P_0/S_2 [1]' offset 0,0.4\nset ylabel 'error of R [1]' offset "
      "0.8\nset key bottom left\nset xrange [0:9]\n");
  draw(falls, panel(0.58, 0.985, 0.585, 0.945),
       "set title 'deflation from R_i = 5'\nset logscale x\nset format x '10^{%L}'\nset xlabel 'T [1]'\nset key top "
       "left\nset xrange [0.01:100]\nset yrange [1e-13:1000]\n");
  draw(rises, panel(0.075, 0.485, 0.09, 0.45),
       "set title 'inflation from R_i'\nset xlabel 'R_{eq} - R_i [1]'\nset key bottom right\nset xrange "
       "[0.001:0.7]\nset yrange [*:*]\n");
  draw(times, panel(0.58, 0.985, 0.09, 0.45),
       "set title 'duration of a half-cycle from R_i'\nset xlabel '|R_i - R_{eq}| [1]'\nset ylabel 'relative error "
       "[1]'\nset xrange [0.003:0.7]\n");
  studio.picture("figure-errors", data, commands + "unset multiplot\n", {1200, 860});
}

}  // namespace turgor
