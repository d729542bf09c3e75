#include "turgor/view/field_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gnuplot.hpp"
#include "stream_lines.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

constexpr int stream_tubes = 20;
constexpr int pixels = 300;    ///< of a window from the axis to its edge
constexpr double decades = 3;  ///< of speed in the colours

/// A square window on the meridional plane [m], mirrored at the axis.
struct Window {
  std::string name;
  double half_width;
  double bottom;
};

class Picture {
 public:
  Picture(const VtuGrid& grid, const FieldPicture& about)
      : grid_(grid), about_(about), length_(1 / unit_factor(about.length_unit, "m")), triangles_(node_triangles(grid)) {
    const auto velocity = std::ranges::find(grid.data, "velocity", &PointData::name);
    velocity_ = velocity->values;
    for (std::size_t i = 0; 3 * i < velocity_.size(); ++i) {
      speed_.push_back(std::hypot(velocity_[3 * i], velocity_[3 * i + 1]));
      fastest_ = std::max(fastest_, speed_.back());
      widest_ = std::max(widest_, grid.points[3 * i]);
      top_ = std::max(top_, grid.points[3 * i + 1]);
    }
    if (!(fastest_ > 0)) fastest_ = 1e-12;  // at rest: one colour
  }

  [[nodiscard]] std::string data() const { return raster(whole()) + raster(orifice()) + lines(); }

  [[nodiscard]] std::string commands() const {
    const std::string unit = "[" + about_.length_unit + "]";
    std::string out = "unset key\nset tics out\nunset grid\nset size ratio -1\n";
    out += "set multiplot title " + quoted(about_.title) + " offset 0,0.3\n";
    out += "set label 1 " + quoted(about_.subtitle) + " at screen 0.5,0.895 center font ',12'\n";
    out += viridis_palette() + "set logscale cb\nset format cb '%g'\nset cbrange [" +
           rounded(fastest_ / std::pow(10, decades), 4) + ":" + rounded(fastest_, 4) + "]\n";
    out += "set cblabel 'speed [m/s]' offset 1\nset xlabel 'r " + unit + "'\n";
    out += "set tmargin at screen 0.83\nset bmargin at screen 0.16\n";
    out += "set lmargin at screen 0.075\nset rmargin at screen 0.40\nset ylabel 'z " + unit +
           "' offset 1.2\nunset colorbox\n" + panel(whole());
    out += "set lmargin at screen 0.48\nset rmargin at screen 0.805\nunset ylabel\nunset label\n";
    out += "set colorbox user origin screen 0.825,0.16 size screen 0.018,0.67\n" + panel(orifice());
    return out + "unset multiplot\n";
  }

 private:
  [[nodiscard]] Window whole() const {
    const double half = 1.04 * std::max(widest_, top_ / 2);
    return {"whole", half, top_ / 2 - half};
  }
  [[nodiscard]] Window orifice() const {
    return {"orifice", 2.5 * about_.orifice_radius, -1.2 * about_.orifice_radius};
  }

  /// Speeds at the middles of pixels right of the axis, in rows from the bottom.
  [[nodiscard]] std::string raster(const Window& window) const {
    const double pixel = window.half_width / pixels;
    std::vector<double> colours(2 * static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels),
                                std::numeric_limits<double>::quiet_NaN());
    for (const auto& t : triangles_) paint(t, window, pixel, colours);
    std::string out = "$" + window.name + " << EOD\n";
    for (std::size_t i = 0; i < colours.size(); ++i) {
      out += std::isnan(colours[i]) ? "NaN" : rounded(colours[i], 4);
      out += (i + 1) % pixels == 0 ? "\n" : " ";
    }
    return out + "EOD\n";
  }

  void paint(const std::array<std::size_t, 3>& t, const Window& window, double pixel,
             std::vector<double>& colours) const {
    std::array<double, 3> x{};
    std::array<double, 3> y{};
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = grid_.points[3 * t[k]] / pixel - 0.5;
      y[k] = (grid_.points[3 * t[k] + 1] - window.bottom) / pixel - 0.5;
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const auto clipped = [](double value, int most) { return static_cast<int>(std::clamp(value, 0.0, most - 1.0)); };
    const auto [left, right] = std::ranges::minmax(x);
    const auto [low, high] = std::ranges::minmax(y);
    if (right < 0 || high < 0 || left > pixels || low > 2 * pixels) return;
    for (int j = clipped(std::ceil(low), 2 * pixels); j <= clipped(std::floor(high), 2 * pixels); ++j) {
      for (int i = clipped(std::ceil(left), pixels); i <= clipped(std::floor(right), pixels); ++i) {
        const double b = ((i - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (j - y[0])) / area;
        const double c = ((x[1] - x[0]) * (j - y[0]) - (i - x[0]) * (y[1] - y[0])) / area;
        constexpr double edge = -1e-9;  // a pixel on a side belongs to either triangle
        if (b < edge || c < edge || b + c > 1 - edge) continue;
        colours[static_cast<std::size_t>(j) * pixels + static_cast<std::size_t>(i)] =
            (1 - b - c) * speed_[t[0]] + b * speed_[t[1]] + c * speed_[t[2]];
      }
    }
  }

  [[nodiscard]] std::string lines() const {
    const std::vector<double> psi = stream_function(grid_, velocity_);
    const auto [least, greatest] = std::ranges::minmax(psi);
    std::string out = "$lines << EOD\n";
    for (int k = 1; k < stream_tubes && greatest > least; ++k) {
      for (const auto& line : contour(grid_, triangles_, psi, std::lerp(least, greatest, k * 1.0 / stream_tubes))) {
        for (const auto& [r, z] : line) out += rounded(length_ * r, 6) + " " + rounded(length_ * z, 6) + "\n";
        out += "\n";
      }
    }
    return out + "EOD\n";
  }

  [[nodiscard]] std::string panel(const Window& window) const {
    const std::string step = rounded(length_ * window.half_width / pixels, 9);
    const std::string y = "($2+0.5)*" + step + (window.bottom < 0 ? "" : "+") + rounded(length_ * window.bottom, 9);
    const double half = length_ * window.half_width;
    const double bottom = length_ * window.bottom;
    std::string out = "set xrange [" + rounded(-half, 6) + ":" + rounded(half, 6) + "]\nset yrange [" +
                      rounded(bottom, 6) + ":" + rounded(bottom + 2 * half, 6) + "]\n";
    const std::string tic = rounded(round_step(half), 6);
    out += "set xtics " + tic + "\nset ytics " + tic + "\n";
    std::string plots;
    for (const std::string side : {"", "-"}) {
      plots += (plots.empty() ? "plot $" : ", \\\n     $") + window.name + " matrix using (" + side + "($1+0.5)*" +
               step + "):(" + y + "):3 with image";
    }
    for (const std::string side : {"", "-"}) {
      plots += ", \\\n     $lines using (" + side + "$1):2 with lines lw 0.6 lc rgb 'black'";
    }
    return out + plots + "\n";
  }

  const VtuGrid& grid_;
  const FieldPicture& about_;
  double length_;  ///< of a metre, in the picture's unit
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<double> velocity_;
  std::vector<double> speed_;  ///< [m/s]
  double fastest_ = 0;
  double widest_ = 0;
  double top_ = 0;
};

}  // namespace

std::string draw_field(const VtuGrid& grid, const FieldPicture& about, const std::filesystem::path& folder,
                       const std::string& name) {
  const Picture picture(grid, about);
  constexpr PictureSize size{1040, 530};
  return gnuplot(folder, name, picture.data(), picture.commands(), size);
}

}  // namespace turgor
