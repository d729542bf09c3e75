#include "turgor/view/portrait_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "gnuplot.hpp"
#include "plot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

/// Tints of the palette's other colours, for wells in turn; grey where the balloon comes to rest in none.
const char* tint(const Fate& fate) {
  constexpr std::array tints{"#DDF0E8", "#F8EBD0", "#F5E4EE", "#E0F1FA"};
  return fate.well == 0 ? "#E6E6E6" : tints.at(static_cast<std::size_t>(fate.well - 1) % tints.size());
}

std::string basin_name(const Fate& fate) {
  switch (fate.outcome) {
    case Outcome::at_rest: return "basin of R = " + rounded(fate.stretch, 5);
    case Outcome::runaway: return "runs away";
    case Outcome::burst: return "bursts";
    case Outcome::closure_end: return "closure ends";
    default: return "undecided";
  }
}

class PortraitPicture {
 public:
  PortraitPicture(const Case& c, const PortraitStudy& study)
      : case_(c),
        study_(study),
        portrait_(study.portrait),
        rate_(study.per_second() * unit_factor(c.output.time_unit, "s")) {}

  [[nodiscard]] std::string draw(const std::filesystem::path& folder, const std::string& name) {
    const std::string unit = "[1/" + case_.output.time_unit + "]'";
    const PhaseWindow& w = portrait_.window;
    std::string commands = "set multiplot\nset lmargin at screen 0.13; set rmargin at screen 0.97\nset clip two\n";
    commands += "set xrange [" + rounded(w.least_stretch, 10) + ":" + rounded(w.greatest_stretch, 10) + "]\n";
    commands += "set title " + quoted(case_.title + ", " + pressure()) + " offset 0,-0.5\nunset key\n";
    commands += "set label 1 'inflating: dR/dt " + unit + " at screen 0.02,0.755 rotate center\n";
    commands += "set label 2 'deflating: dR/dt " + unit + " at screen 0.02,0.4 rotate center\n";
    commands += "set tmargin at screen 0.93; set bmargin at screen 0.575\nset format x ''\n";
    commands += "set yrange [0:" + rounded(w.inflation * rate_, 8) + "]\nset nonlinear y via sqrt(y) inverse y*y\n";
    commands += root_tics(w.inflation * rate_, 1) + inflation();
    commands += "unset title; unset label 1; unset label 2\n";
    commands += "set tmargin at screen 0.575; set bmargin at screen 0.22\nset format x '%g'\n";
    commands += "set key at screen 0.54,0.008 center bottom horizontal width 1 samplen 2.5 font ',12.5'\n";
    commands += "set xlabel 'stretch R = r/r_0 [1]' offset 0,0.3\n";
    commands += "set yrange [" + rounded(-w.deflation * rate_, 8) + ":0]\nset nonlinear y via -sqrt(-y) inverse -y*y\n";
    commands += root_tics(w.deflation * rate_, -1) + forbidden() + deflation() + "unset multiplot\n";
    constexpr PictureSize size{900, 720};
    return gnuplot(folder, name, data_, commands, size);
  }

 private:
  [[nodiscard]] std::string pressure() const {
    const std::string unit = case_.output.pressure_unit == "Pa" ? "kPa" : case_.output.pressure_unit;
    return rounded(study_.plane.pressure() / unit_factor(unit, "Pa"), 6) + " " + unit;
  }

  /// All curves of a kind, what lies in one panel.
  [[nodiscard]] Curve curves(CurveKind kind, const std::string& where) const {
    const bool above = where == "upper";
    Curve all;
    for (const KindOfCurve& curve : portrait_.curves) {
      if (curve.kind != kind) continue;
      bool gap = true;
      for (const PhasePoint& p : curve.points) {
        const bool elsewhere = above ? p.rate < 0 : p.rate > 0;
        if (!elsewhere) all.push_back({p.stretch, p.rate * rate_, gap});
        gap = elsewhere;
      }
    }
    return all;
  }
  [[nodiscard]] Curve equilibria(bool stable) const {
    Curve points;
    for (const Equilibrium& e : study_.plane.equilibria()) {
      if (e.stable == stable) points.push_back({e.stretch, 0, false});
    }
    return points;
  }

  /// The basins as the first plots of a panel, which cuts them: gnuplot fills beyond an axis.
  [[nodiscard]] std::string basins(const std::string& where) {
    const bool above = where == "upper";
    std::string plots;
    int index = 0;
    for (const BasinStrip& strip : portrait_.basins) {
      const std::string name = "$" + where + "_basin" + std::to_string(++index);
      data_ += name + " << EOD\n";
      for (const auto& [R, low, high] : strip.columns) {
        const auto cut = [&](double rate) { return above ? std::max(0.0, rate) : std::min(0.0, rate); };
        data_ += rounded(R, 8) + " " + rounded(cut(low) * rate_, 8) + " " + rounded(cut(high) * rate_, 8) + "\n";
      }
      data_ += "EOD\n";
      plots += (plots.empty() ? "plot " : ", \\\n     ") + name +
               " using 1:2:3 with filledcurves fs solid noborder fc rgb '" + tint(strip.fate) + "' notitle";
    }
    return plots;
  }

  [[nodiscard]] std::string panel(const std::string& where, Plot& plot, const std::string& entries) {
    add_common(plot, where);
    data_ += plot.data();
    const std::string ground = basins(where);
    std::string command = plot.command();
    command.pop_back();
    return ground + ", \\\n     " + command.substr(std::string("plot ").size()) + entries + "\n";
  }

  [[nodiscard]] std::string inflation() {
    Plot plot;
    plot.add("inflation", curves(CurveKind::inflation, "upper"), thin(blue) + " notitle");
    return panel("upper", plot, "");
  }

  [[nodiscard]] std::string deflation() {
    Plot plot;
    plot.add("slow", curves(CurveKind::slow_manifold, "lower"), slow + " notitle");
    plot.add("deflation", curves(CurveKind::deflation, "lower"), thin(vermilion) + " notitle");
    plot.add("corrected", curves(CurveKind::corrected_slow_manifold, "lower"), corrected + " notitle");
    return panel("lower", plot, key());
  }

  [[nodiscard]] std::string key() const {
    std::string entries;
    const auto add = [&](const std::string& style, const std::string& title) {
      entries += ", \\\n     keyentry with " + style + " title '" + title + "'";
    };
    const auto has = [&](CurveKind kind) { return std::ranges::count(portrait_.curves, kind, &KindOfCurve::kind) > 0; };
    add(thin(blue), "inflation");
    add(thin(vermilion), "deflation");
    if (has(CurveKind::slow_manifold)) add(slow, "slow manifold (3.21)");
    if (has(CurveKind::corrected_slow_manifold)) add(corrected, "its correction");
    if (has(CurveKind::separatrix)) add("lines lw 4 lc rgb 'black'", "separatrix");
    if (!portrait_.forbidden.empty()) add("boxes lc rgb 'grey40' fs solid noborder", "no slow deflation");
    std::map<std::string, const char*> basins;
    for (const BasinStrip& strip : portrait_.basins) basins.emplace(basin_name(strip.fate), tint(strip.fate));
    for (const auto& [name, colour] : basins) {
      add("boxes lc rgb '" + std::string(colour) + "' fs solid border lc rgb 'grey50'", name);
    }
    if (!equilibria(true).empty()) add(filled, "stable equilibrium");
    if (!equilibria(false).empty()) add(open, "unstable equilibrium");
    return entries;
  }

  [[nodiscard]] static std::string thin(const char* colour) {
    return "lines lw 1.5 lc rgb '" + std::string(colour) + "'";
  }
  const std::string slow = "lines lw 6 lc rgb '" + std::string(orange) + "'";
  const std::string corrected = "lines lw 1.5 dt (8,6) lc rgb 'black'";
  const std::string filled = "points pt 7 ps 1.3 lc rgb 'black'";
  const std::string open = "points pt 6 ps 1.3 lw 1.5 lc rgb 'black'";

  void add_common(Plot& plot, const std::string& where) const {
    plot.add(where + "_separatrix", curves(CurveKind::separatrix, where), "lines lw 4 lc rgb 'black' notitle");
    plot.add(where + "_stable", equilibria(true), filled + " notitle");
    plot.add(where + "_hole", equilibria(false), "points pt 7 ps 1.3 lc rgb 'white' notitle");
    plot.add(where + "_unstable", equilibria(false), open + " notitle");
  }

  [[nodiscard]] std::string forbidden() const {
    std::string out;
    for (const StretchInterval& interval : portrait_.forbidden) {
      out += "set object rectangle from first " + rounded(interval.from, 8) + ", graph 0.975 to first " +
             rounded(interval.to, 8) + ", graph 1 front fs solid noborder fc rgb 'grey40'\n";
    }
    return out;
  }

  const Case& case_;
  const PortraitStudy& study_;
  const Portrait& portrait_;
  double rate_;
  std::string data_;
};

}  // namespace

std::string draw_phase_portrait(const Case& c, const PortraitStudy& study, const std::filesystem::path& folder,
                                const std::string& name) {
  return PortraitPicture(c, study).draw(folder, name);
}

}  // namespace turgor
