#include "turgor/view/sweep_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gnuplot.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/quantities.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

constexpr std::size_t most_pictures = 4;
constexpr std::array<std::string_view, 3> usual_quantities{"peak_stretch", "final_stretch", "final_well"};
constexpr std::size_t most_panels = 6;

/// One colour for each whole number from least to greatest: at most as many as there are colours.
std::string stepped_palette(double least, double greatest) {
  const auto levels = static_cast<int>(greatest - least + 1);
  std::string out;
  for (int k = 0; k < levels; ++k) {
    const double share = levels > 1 ? static_cast<double>(k) / (levels - 1) : 0.5;
    const std::string colour = viridis[static_cast<std::size_t>(std::lround(share * (viridis.size() - 1)))];
    for (const int at : {k, k + 1}) out += (out.empty() ? "" : ", ") + std::to_string(at) + " '" + colour + "'";
  }
  return "set palette maxcolors 0\nset palette defined (" + out + ")\nset cbrange [" + rounded(least - 0.5, 6) + ":" +
         rounded(greatest + 0.5, 6) + "]\nset cbtics 1\n";
}

/// The unit in which a picture shows an SI unit: the case's own where it has one.
std::string shown_unit(const Case& c, const std::string& si) {
  if (si == "m") return c.output.length_unit;
  if (si == "s") return c.output.time_unit;
  if (si == "J") return c.output.energy_unit;
  if (si == "Pa") return c.output.pressure_unit == "Pa" ? "kPa" : c.output.pressure_unit;
  return si;
}

std::string label(const std::string& name, const std::string& unit) {
  return quoted(name + (unit == "1" || unit.empty() ? "" : " [" + unit + "]"));
}

/// One axis of a sweep as an axis of a picture.
class Scale {
 public:
  Scale(const Case& c, const Axis& axis) : axis_(axis), unit_(axis.unit.empty() ? "" : shown_unit(c, axis.unit)) {
    if (!axis.unit.empty()) factor_ = 1 / unit_factor(unit_, axis.unit);
    const auto* range = std::get_if<AxisRange>(&axis.form);
    logarithmic_ = (range != nullptr && range->logarithmic) || std::holds_alternative<LognormalAxis>(axis.form);
    const auto* list = std::get_if<AxisValues>(&axis.form);
    listed_ = list != nullptr;
    if (listed_) values_ = list->values;
  }

  /// Where a value stands: values of a list side by side, those in equal ratios by their logarithm.
  [[nodiscard]] double position(const Node& value, std::uint64_t index) const {
    if (listed_) return static_cast<double>(index);
    const auto* exact = value.as<Node::Quantity>();
    const double x = factor_ * (exact != nullptr ? exact->value : std::get<double>(value.value));
    return logarithmic_ ? std::log10(x) : x;
  }

  /// Commands that label the axis "x" or "y" of a picture.
  /// @param least, greatest  range of positions
  [[nodiscard]] std::string commands(const std::string& axis, double least, double greatest) const {
    std::string tics;
    if (listed_) {
      for (std::size_t i = 0; i < values_.size(); ++i) add_tic(tics, value_text(i), static_cast<double>(i));
    } else if (logarithmic_) {
      tics = logarithmic_tics(least, greatest);
    }
    return "set " + axis + "label " + label(axis_.key, unit_) + "\n" +
           (tics.empty() ? "set " + axis + "tics autofreq\n" : "set " + axis + "tics (" + tics + ")\n");
  }

 private:
  static void add_tic(std::string& tics, const std::string& text, double at) {
    tics += (tics.empty() ? "" : ", ") + quoted(text) + " " + rounded(at, 12);
  }

  [[nodiscard]] std::string value_text(std::size_t i) const {
    if (const auto* exact = values_[i].as<Node::Quantity>()) return rounded(factor_ * exact->value, 4);
    if (const auto* word = values_[i].as<std::string>()) return *word;
    return values_[i].text();
  }

  /// At 1, 2 and 5 times powers of ten; over less than a decade at even steps.
  static std::string logarithmic_tics(double least, double greatest) {
    std::string tics;
    const double decades = greatest - least;
    if (decades < 1) {
      const double from = std::pow(10, least);
      const double to = std::pow(10, greatest);
      const double step = round_step((to - from) / 3);
      const auto first = static_cast<int>(std::ceil(from / step * (1 - 1e-9)));
      for (int k = first; k * step <= to * (1 + 1e-9); ++k) add_tic(tics, rounded(k * step, 4), std::log10(k * step));
      return tics;
    }
    const std::vector<int> digits = decades > 2.5 ? std::vector<int>{1} : std::vector<int>{1, 2, 5};
    for (int power = static_cast<int>(std::floor(least)); power <= std::ceil(greatest); ++power) {
      for (const int digit : digits) {
        const double at = power + std::log10(digit);
        if (at >= least - 1e-9 && at <= greatest + 1e-9) add_tic(tics, rounded(digit * std::pow(10, power), 4), at);
      }
    }
    return tics;
  }

  const Axis& axis_;
  std::string unit_;
  double factor_ = 1;
  bool logarithmic_ = false;
  bool listed_ = false;
  std::vector<Node> values_;
};

/// A sample of members as columns of a data block: positions along the axes, then the quantities.
class SweepPicture {
 public:
  SweepPicture(const Case& c, const SweepSummary& summary, std::filesystem::path output)
      : case_(c), summary_(summary), output_(std::move(output)), plan_(c.sweep.value()) {
    for (const Axis& axis : plan_.settings().axes) scales_.emplace_back(c, axis);
    positions_.resize(scales_.size());
    for (const std::uint64_t member : summary.sample.members) {
      const auto values = plan_.values(member);
      const auto at = plan_.indices(member);
      for (std::size_t a = 0; a < scales_.size(); ++a) {
        positions_[a].push_back(scales_[a].position(values[a], at.empty() ? 0 : at[a]));
      }
    }
  }

  std::string draw(std::size_t quantity) {
    quantity_ = quantity;
    const QuantitySummary& q = summary_.quantities[quantity];
    unit_ = shown_unit(case_, q.unit);
    factor_ = 1 / unit_factor(unit_, q.unit);
    const bool grid = plan_.settings().sampler == Sampler::grid;
    std::string commands = "set title " + quoted(case_.title) + "\n";
    if (grid && scales_.size() == 2) {
      commands += map();
    } else if (scales_.size() == 1) {
      commands += curve();
    } else {
      commands += clouds();
    }
    const std::filesystem::path folder = output_.parent_path().empty() ? "." : output_.parent_path();
    return gnuplot(folder, output_.stem().string() + "-" + q.name, data(), commands);
  }

 private:
  [[nodiscard]] std::string data() const {
    std::string out = "$members << EOD\n";
    const auto& values = summary_.sample.values[quantity_];
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (const auto& column : positions_) out += rounded(column[i], 9) + " ";
      out += std::isnan(values[i]) ? "NaN\n" : rounded(factor_ * values[i], 7) + "\n";
    }
    return out + "EOD\n";
  }

  [[nodiscard]] std::string name() const { return label(summary_.quantities[quantity_].name, unit_); }

  [[nodiscard]] std::string axis(const std::string& which, std::size_t a) const {
    const auto [least, greatest] = std::ranges::minmax(positions_[a]);
    return scales_[a].commands(which, least, greatest);
  }

  /// From the first to the last position, half a cell wider each way.
  [[nodiscard]] std::string cell_range(const std::string& which, std::size_t a) const {
    auto sorted = positions_[a];
    std::ranges::sort(sorted);
    const auto rest = std::ranges::unique(sorted);
    sorted.erase(rest.begin(), rest.end());
    const double half =
        sorted.size() > 1 ? (sorted.back() - sorted.front()) / static_cast<double>(sorted.size() - 1) / 2 : 0.5;
    return "set " + which + "range [" + rounded(sorted.front() - half, 9) + ":" + rounded(sorted.back() + half, 9) +
           "]\n";
  }

  [[nodiscard]] bool counts() const {
    const std::string& name = summary_.quantities[quantity_].name;
    return name == "final_well" || name == "switched" || name == "events";
  }

  /// First axis upwards would hide that files have it first; it runs to the right, the second upwards.
  [[nodiscard]] std::string map() const {
    const QuantitySummary& q = summary_.quantities[quantity_];
    const double least = std::floor(q.least);
    const bool stepped = counts() && q.greatest - least < static_cast<double>(viridis.size());
    std::string commands = axis("x", 0) + axis("y", 1) + cell_range("x", 0) + cell_range("y", 1);
    commands += stepped ? stepped_palette(least, q.greatest) : viridis_palette();
    commands +=
        "unset key\nunset grid\nset tics out\nset cblabel " + name() + " offset 1.5\nset rmargin at screen 0.80\n";
    commands += "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb 'grey85' fs solid noborder\n";
    if (q.count < summary_.members) commands += "set label 1 'grey: no value' at screen 0.985,0.03 right\n";
    return commands + "plot $members using 1:2:3 with image\n";
  }

  [[nodiscard]] std::string curve() const {
    return axis("x", 0) + "set ylabel " + name() +
           " offset 1\nunset key\nset offsets graph 0.03,graph 0.03,graph 0.06,graph 0.06\n"
           "plot $members using 1:2 with " +
           (positions_[0].size() > 60 ? "lines lw 2" : "linespoints lw 2 pt 7 ps 0.5") + " lc rgb '#0072B2'\n";
  }

  [[nodiscard]] std::string clouds() const {
    const std::size_t panels = std::min(scales_.size(), most_panels);
    const std::size_t columns = panels <= 4 ? 2 : 3;
    const std::size_t rows = (panels + columns - 1) / columns;
    std::string commands = "unset title\nset multiplot layout " + std::to_string(rows) + "," + std::to_string(columns) +
                           " title " + quoted(case_.title) +
                           "\nunset key\nset tics font ',10'\nset xlabel font ',12'\nset "
                           "offsets graph 0.04,graph 0.04,graph 0.05,graph 0.05\n";
    for (std::size_t a = 0; a < panels; ++a) {
      commands += axis("x", a);
      commands += a % columns == 0 ? "set ylabel " + name() + " font ',12'\n" : "unset ylabel\n";
      commands += "plot $members using " + std::to_string(a + 1) + ":" + std::to_string(scales_.size() + 1) +
                  " with points pt 7 ps 0.15 lc rgb '#0072B2'\n";
    }
    return commands + "unset multiplot\n";
  }

  const Case& case_;
  const SweepSummary& summary_;
  std::filesystem::path output_;
  SweepPlan plan_;
  std::vector<Scale> scales_;
  std::vector<std::vector<double>> positions_;
  std::size_t quantity_ = 0;
  std::string unit_;
  double factor_ = 1;
};

}  // namespace

std::string draw_sweep(const Case& c, const SweepSummary& summary, const std::filesystem::path& output) {
  const bool all = summary.quantities.size() == quantity_names().size();
  SweepPicture picture(c, summary, output);
  std::size_t drawn = 0;
  std::string problem;
  for (std::size_t q = 0; q < summary.quantities.size() && drawn < most_pictures; ++q) {
    const bool usual = std::ranges::find(usual_quantities, summary.quantities[q].name) != usual_quantities.end();
    if ((all && !usual) || summary.quantities[q].count == 0) continue;
    ++drawn;
    if (problem.empty()) problem = picture.draw(q);
  }
  return problem;
}

}  // namespace turgor
