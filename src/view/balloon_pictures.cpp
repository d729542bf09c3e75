#include "balloon_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plot.hpp"
#include "speed_image.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr int stream_tubes = 30;  // at most
constexpr double kPa = 1000;

/// What a picture shows of the meridional plane [m], mirrored at the axis.
struct Window {
  double half_width;
  double bottom;
  double height;
};

Window window_of(const BalloonStage& stage) {
  const double margin = 0.03 * (stage.highest - stage.lowest);
  return {stage.widest + margin, stage.lowest - margin, stage.highest - stage.lowest + 2 * margin};
}

Pixels pixels_of(const Window& window, const std::string& name, int columns) {
  const double size = window.half_width / columns;
  return {"speed" + name, size, window.bottom, columns, static_cast<int>(std::ceil(window.height / size))};
}

std::string line_block(const std::string& name, const std::vector<std::vector<PlanePoint>>& lines) {
  std::string out = "$" + name + " << EOD\n";
  for (const auto& line : lines) {
    for (const auto& [r, z] : line) out += rounded(r, 5) + " " + rounded(z, 5) + "\n";
    out += "\n";
  }
  return out + "EOD\n";
}

/// A panel: its data blocks, whose names end in `name`, and its plot.
class Panel {
 public:
  Panel(const BalloonScene& scene, const BalloonStage& stage, std::string name, int columns)
      : scene_(scene),
        stage_(stage),
        window_(window_of(stage)),
        name_(std::move(name)),
        pixels_(pixels_of(window_, name_, columns)) {}

  [[nodiscard]] std::string data() const {
    constexpr double darkest = 1e-3;
    std::vector<double> speed = speeds(scene_.field.velocity);
    for (double& value : speed) value = std::max(value, darkest * stage_.fastest);  // no colour has a logarithm of 0
    std::vector<std::vector<PlanePoint>> lines;
    lines.reserve(scene_.streams.lines.size());
    for (const StreamLine& line : scene_.streams.lines) lines.push_back(line.points);
    const VtuGrid& grid = scene_.field.grid;
    return image_block(pixels_, speed_image(grid, node_triangles(grid), speed, pixels_), 1) +
           line_block("lines" + name_, lines) + line_block("wall" + name_, {scene_.field.membrane}) +
           line_block("start" + name_, {scene_.field.membrane_at_start});
  }

  [[nodiscard]] std::string commands() const {
    const double tic = round_step(window_.half_width);
    const auto range = [](double from, double to) {
      return "range [" + rounded(from, 5) + ":" + rounded(to, 5) + "]\n";
    };
    std::string out = "set x" + range(-window_.half_width, window_.half_width);
    out += "set y" + range(window_.bottom, window_.bottom + window_.height);
    out += "set xtics " + rounded(tic, 5) + "\nset ytics " + rounded(tic, 5) + "\nset title " + quoted(title()) +
           " offset 0,-0.6\nplot " + image_plot(pixels_);
    const auto mirrored = [&](const std::string& block, const std::string& style) {
      for (const std::string side : {"", "-"}) {
        out += ", \\\n     $" + block + name_ + " using (" + side + "$1):2 with lines " + style;
      }
    };
    mirrored("lines", "lw 0.6 lc rgb 'black'");
    mirrored("start", "lw 1.2 lc rgb 'white'");  // so that the dashes are seen on all colours
    mirrored("start", "lw 1.2 dt " + unstable_dashes + " lc rgb 'black'");
    mirrored("wall", "lw 2.5 lc rgb 'black'");
    return out + "\n";
  }

 private:
  [[nodiscard]] std::string title() const {
    return "t = " + rounded(scene_.field.time, 4) + " s, p = " + rounded(scene_.gauge_pressure / kPa, 3) + " kPa";
  }

  const BalloonScene& scene_;
  const BalloonStage& stage_;
  Window window_;
  std::string name_;
  Pixels pixels_;
};

std::string share(int pixels, int of) { return rounded(static_cast<double>(pixels) / of, 6); }

/// Where things stand in a picture of panels, in pixels of the SVG.
struct Layout {
  int left = 84, right = 116, bottom = 70, top = 34, gap = 14;
  int columns, rows, width, height;  ///< of panels; of one of them

  Layout(std::size_t panels, int most_columns, int panel_width, const Window& window)
      : columns(std::min(most_columns, static_cast<int>(panels))),
        rows((static_cast<int>(panels) + columns - 1) / columns),
        width(panel_width),
        height(static_cast<int>(std::lround(panel_width * window.height / (2 * window.half_width)))) {}

  [[nodiscard]] PictureSize size() const {
    return {left + columns * (width + gap) + right, bottom + rows * (height + top)};
  }
  [[nodiscard]] std::string place(int i) const {
    const auto [all_across, all_up] = size();
    const int x = left + i % columns * (width + gap);
    const int y = bottom + (rows - 1 - i / columns) * (height + top);
    return "set lmargin at screen " + share(x, all_across) + "; set rmargin at screen " + share(x + width, all_across) +
           "\nset bmargin at screen " + share(y, all_up) + "; set tmargin at screen " + share(y + height, all_up) +
           "\n";
  }
  /// Axes have numbers on the left and below.
  [[nodiscard]] std::string axes(int i, std::size_t panels) const {
    const bool labelled_r = static_cast<std::size_t>(i) + static_cast<std::size_t>(columns) >= panels;
    return std::string(i % columns == 0 ? "set ylabel 'z [m]'\nset format y '%g'\n"
                                        : "unset ylabel\nset format y ''\n") +
           (labelled_r ? "set xlabel 'r [m]' offset 0,0.5\nset format x '%g'\n" : "unset xlabel\nset format x ''\n");
  }
  [[nodiscard]] std::string colorbox() const {
    const auto [all_across, all_up] = size();
    return "set colorbox user origin screen " + share(all_across - right + 4, all_across) + "," +
           share(bottom, all_up) + " size screen " + share(18, all_across) + "," +
           share(rows * (height + top) - top, all_up) + "\nset cblabel 'speed [m/s]' offset 1\n";
  }
};

constexpr int most_columns = 3;
constexpr int panel_width = 300;
constexpr int panel_columns = 200;
constexpr int film_width = 440;
constexpr int film_columns = 150;

}  // namespace

StreamLines stream_lines(const FemField& field, double least) {
  StreamLines all{0, {}};
  if (std::ranges::max(speeds(field.velocity)) <= least) return all;
  std::vector<double> flux = stream_function(field.grid, field.velocity);
  for (double& value : flux) value *= 2 * std::numbers::pi;
  const auto [lowest, highest] = std::ranges::minmax(flux);
  if (!(highest > lowest)) return all;
  constexpr double widest_gap = 2.5;  // of round steps: 5 to 2
  all.flux = round_step(widest_gap * (highest - lowest) / stream_tubes);
  const auto triangles = node_triangles(field.grid);
  for (int k = static_cast<int>(std::ceil(lowest / all.flux)); k * all.flux < highest; ++k) {
    if (k == 0) continue;  // the axis
    for (auto& line : contour(field.grid, triangles, flux, k * all.flux)) {
      all.lines.push_back({k * all.flux, std::move(line)});
    }
  }
  return all;
}

std::string draw_balloon(const std::vector<BalloonScene>& scenes, const BalloonStage& stage,
                         const std::filesystem::path& folder, const std::string& name) {
  const Layout layout(scenes.size(), most_columns, panel_width, window_of(stage));
  std::string data;
  std::string plot = "unset key\nset tics out\nunset grid\nset multiplot\n" + speed_colours(stage.fastest);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Panel panel(scenes[i], stage, std::to_string(i + 1), panel_columns);
    const int place = static_cast<int>(i);
    data += panel.data();
    plot += (i == 0 ? layout.colorbox() : "unset colorbox\n") + layout.place(place) +
            layout.axes(place, scenes.size()) + panel.commands();
  }
  return gnuplot(folder, name, data, plot + "unset multiplot\n", layout.size());
}

FilmFrame balloon_frame(const BalloonScene& scene, const BalloonStage& stage) {
  const Layout layout(1, 1, film_width, window_of(stage));
  const Panel panel(scene, stage, "", film_columns);
  return {panel.data(), "unset key\nset tics out\nunset grid\n" + speed_colours(stage.fastest) + layout.colorbox() +
                            layout.place(0) + layout.axes(0, 1) + panel.commands()};
}

PictureSize balloon_film_size(const BalloonStage& stage) { return Layout(1, 1, film_width, window_of(stage)).size(); }

}  // namespace turgor
