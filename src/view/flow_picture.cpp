#include "turgor/view/flow_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gnuplot.hpp"
#include "mirrored_image.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

constexpr int stream_tubes = 16;

/// A square window on the meridional plane, in units of r, mirrored at the axis.
struct Window {
  std::string name;
  double half_width;
  double bottom;
};

class FlowPicture {
 public:
  FlowPicture(const Case& c, const FlowSnapshot& snapshot, const MeridionalFlow& field)
      : case_(c),
        snapshot_(snapshot),
        field_(field),
        eps_(snapshot.flow().eps()),
        kappa_(snapshot.flow().kappa()),
        length_(snapshot.state().radius / unit_factor(c.output.length_unit, "m")) {
    for (const MeridionalFlow::Node& node : field.nodes()) {
      const double excess = snapshot.pressure(node.polar, node.field) - snapshot.state().inlet_pressure;
      excess_.push_back(excess);
      greatest_ = std::max(greatest_, excess);
      constexpr double rim = 0.1;
      if (std::hypot(node.point.distance - kappa_, node.point.height) > rim * kappa_) least_ = std::min(least_, excess);
    }
    pressure_unit_ = c.output.pressure_unit;
    constexpr double thousand = 1000;
    if (pressure_unit_ == "Pa" && greatest_ - least_ > thousand) pressure_unit_ = "kPa";
    pascal_ = 1 / unit_factor(pressure_unit_, "Pa");
  }

  [[nodiscard]] std::string data() const { return image(whole()) + image(orifice()) + lines() + wall(); }

  [[nodiscard]] std::string commands() const {
    const FlowInstant& instant = snapshot_.instant();
    const std::string length = "[" + case_.output.length_unit + "]";
    std::string out = "unset key\nset tics out\nunset grid\nset size ratio -1\n";
    out += "set multiplot title " + quoted(case_.title) + " offset 0,0.3\n";
    out += "set label 1 " +
           quoted("R = " + rounded(instant.stretch, 5) + ", dR/dt = " + rounded(instant.rate, 4) +
                  " 1/s, d²R/dt² = " + rounded(*instant.acceleration, 4) + " 1/s²") +
           " at screen 0.5,0.895 center font ',12'\n";
    out += "set label 2 'between neighbouring streamlines: 1/" + std::to_string(stream_tubes) +
           " of the outflow' at screen 0.44,0.03 center font ',12'\n";
    out += viridis_palette() + "set cbrange [" + rounded(least_ * pascal_, 6) + ":" +
           rounded(std::max(greatest_, least_ + std::abs(least_) * 1e-6 + 1e-30) * pascal_, 6) + "]\n";
    out += "set format cb '%g'\nset cblabel 'p - p_{ext} [" + pressure_unit_ + "]' offset 1\n";
    out += "set xlabel 'r " + length + "'\nset tmargin at screen 0.83\nset bmargin at screen 0.16\n";
    out += "set lmargin at screen 0.075\nset rmargin at screen 0.40\nset ylabel 'z " + length +
           "' offset 1.2\nunset colorbox\n" + panel(whole());
    out += "set lmargin at screen 0.48\nset rmargin at screen 0.805\nunset ylabel\nunset label\n";
    out += "set colorbox user origin screen 0.825,0.16 size screen 0.018,0.67\n" + panel(orifice());
    return out + "unset multiplot\n";
  }

 private:
  [[nodiscard]] Window whole() const { return {"whole", 1.08, -0.08 - eps_ / 2}; }
  [[nodiscard]] Window orifice() const {
    const double half_width = std::min(2.5 * kappa_, 1.08);
    return {"orifice", half_width, -half_width / 8};
  }

  static Pixels pixels(const Window& window) {
    return {window.name, window.half_width / resolution, window.bottom, resolution, 2 * resolution};
  }

  /// Pressures; a pixel more than inside the wall.
  [[nodiscard]] std::string image(const Window& window) const {
    const Pixels all = pixels(window);
    std::vector<double> pressures;
    for (int row = 0; row < all.rows; ++row) {
      for (int column = 0; column < all.columns; ++column) {
        const MeridionalPoint point{(column + 0.5) * all.size, all.bottom + (row + 0.5) * all.size};
        const bool inside =
            point.height > -all.size && std::hypot(point.distance, point.height - (1 - eps_)) < 1 + all.size;
        const bool in_channel = point.height < 0 && point.distance > kappa_;
        pressures.push_back(inside && !in_channel ? excess_at({point.distance, std::max(0.0, point.height)}) * pascal_
                                                  : std::numeric_limits<double>::quiet_NaN());
      }
    }
    return image_block(all, pressures, length_);
  }

  [[nodiscard]] double excess_at(const MeridionalPoint& point) const {
    const auto [row, column] = field_.mesh().place(point);
    const std::size_t size = field_.mesh().size();
    const auto i = std::min(static_cast<std::size_t>(row), size - 2);
    const auto j = std::min(static_cast<std::size_t>(column), size - 2);
    const double* corner = &excess_[i * size + j];
    return std::lerp(std::lerp(corner[0], corner[1], column - static_cast<double>(j)),
                     std::lerp(corner[size], corner[size + 1], column - static_cast<double>(j)),
                     row - static_cast<double>(i));
  }

  [[nodiscard]] std::string text(const MeridionalPoint& point) const {
    return rounded(length_ * point.distance, 6) + " " + rounded(length_ * point.height, 6) + "\n";
  }

  /// A short vector along a streamline where it comes within a distance from the axis.
  [[nodiscard]] std::string arrow(const std::vector<MeridionalPoint>& line, double distance) const {
    const auto at = std::ranges::find_if(line, [&](const MeridionalPoint& p) { return p.distance <= distance; });
    if (at == line.begin() || at == line.end()) return {};
    const MeridionalPoint& from = *(at - 1);
    std::string out = text(from);
    out.back() = ' ';
    return out + text({at->distance - from.distance, at->height - from.height});
  }

  [[nodiscard]] std::string lines() const {
    std::string out;
    std::string far_arrows;
    std::string near_arrows;
    for (int k = 1; k < stream_tubes; ++k) {
      const auto line = field_.stream_line(static_cast<double>(k) / stream_tubes);
      for (const MeridionalPoint& point : line) out += text(point);
      out += "\n";
      far_arrows += arrow(line, line.front().distance / 2);
      near_arrows += arrow(line, 1.4 * kappa_);
    }
    return "$lines << EOD\n" + out + "EOD\n$arrows_" + whole().name + " << EOD\n" + far_arrows + "EOD\n$arrows_" +
           orifice().name + " << EOD\n" + near_arrows + "EOD\n";
  }

  [[nodiscard]] std::string wall() const {
    std::string out = "$wall << EOD\n";
    for (std::size_t j = 0; j < field_.mesh().size(); ++j) out += text(field_.node(0, j).point);
    out += text({kappa_, 0});
    if (snapshot_.state().channel_length > 0) {
      out += text({kappa_, -std::min(snapshot_.state().channel_length / snapshot_.state().radius, 4.0)});
    }
    return out + "EOD\n$gap << EOD\n" + text({-kappa_, 0}) + text({kappa_, 0}) + "EOD\n";
  }

  [[nodiscard]] std::string panel(const Window& window) const {
    std::string out = "set xrange [" + rounded(-length_ * window.half_width, 6) + ":" +
                      rounded(length_ * window.half_width, 6) + "]\nset yrange [" +
                      rounded(length_ * window.bottom, 6) + ":" +
                      rounded(length_ * (window.bottom + 2 * window.half_width), 6) + "]\n";
    const double tic = round_step(length_ * window.half_width);
    out += "set xtics " + rounded(tic, 6) + "\nset ytics " + rounded(tic, 6) + "\n";
    std::string plots = "plot " + image_plot(pixels(window));
    for (const std::string side : {"", "-"}) {
      const std::string using_side = " using (" + side + "$1):2 with lines ";
      plots += ", \\\n     $lines" + using_side + "lw 0.6 lc rgb 'black'";
      plots += ", \\\n     $arrows_" + window.name + " using (" + side + "$1):2:(" + side +
               "$3):4 with vectors head filled size graph 0.02,18 fixed lw 0.6 lc rgb 'black'";
      plots += ", \\\n     $wall" + using_side + "lw 3 lc rgb 'black'";
    }
    return out + plots + ", \\\n     $gap with lines lw 1 dt 3 lc rgb 'grey40'\n";
  }

  static constexpr int resolution = 300;  ///< pixels of a window from the axis to its edge

  const Case& case_;
  const FlowSnapshot& snapshot_;
  const MeridionalFlow& field_;
  double eps_;
  double kappa_;
  double length_;  ///< of r, in the picture's unit
  std::string pressure_unit_;
  double pascal_;
  std::vector<double> excess_;  ///< pressure less the inlet's [Pa], at the nodes
  double least_ = std::numeric_limits<double>::infinity();
  double greatest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::string draw_flow(const Case& c, const FlowSnapshot& snapshot, const MeridionalFlow& field,
                      const std::filesystem::path& folder, const std::string& name) {
  const FlowPicture picture(c, snapshot, field);
  return gnuplot(folder, name, picture.data(), picture.commands(), {1040, 530});
}

}  // namespace turgor
