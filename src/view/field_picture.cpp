#include "turgor/view/field_picture.hpp"

#include <algorithm>
#include <cmath>

#include "gnuplot.hpp"
#include "speed_image.hpp"
#include "stream_lines.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

constexpr int stream_tubes = 20;
constexpr int resolution = 300;  ///< pixels of a window from the axis to its edge

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
    speed_ = speeds(velocity_);
    for (std::size_t i = 0; i < speed_.size(); ++i) {
      fastest_ = std::max(fastest_, speed_[i]);
      widest_ = std::max(widest_, grid.points[3 * i]);
      top_ = std::max(top_, grid.points[3 * i + 1]);
    }
    if (!(fastest_ > 0)) fastest_ = 1e-12;  // at rest: one colour
  }

  [[nodiscard]] std::string data() const { return image(whole()) + image(orifice()) + lines(); }

  [[nodiscard]] std::string commands() const {
    const std::string unit = "[" + about_.length_unit + "]";
    std::string out = "unset key\nset tics out\nunset grid\nset size ratio -1\n";
    out += "set multiplot title " + quoted(about_.title) + " offset 0,0.3\n";
    out += "set label 1 " + quoted(about_.subtitle) + " at screen 0.5,0.895 center font ',12'\n";
    out += speed_colours(fastest_) + "set cblabel 'speed [m/s]' offset 1\nset xlabel 'r " + unit + "'\n";
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

  static Pixels pixels(const Window& window) {
    return {window.name, window.half_width / resolution, window.bottom, resolution, 2 * resolution};
  }
  [[nodiscard]] std::string image(const Window& window) const {
    const Pixels all = pixels(window);
    return image_block(all, speed_image(grid_, triangles_, speed_, all), length_);
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
    const double half = length_ * window.half_width;
    const double bottom = length_ * window.bottom;
    std::string out = "set xrange [" + rounded(-half, 6) + ":" + rounded(half, 6) + "]\nset yrange [" +
                      rounded(bottom, 6) + ":" + rounded(bottom + 2 * half, 6) + "]\n";
    const std::string tic = rounded(round_step(half), 6);
    out += "set xtics " + tic + "\nset ytics " + tic + "\n";
    std::string plots = "plot " + image_plot(pixels(window));
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
