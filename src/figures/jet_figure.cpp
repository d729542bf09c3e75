// Figure 5: what the jet of a fast inflation makes of a balloon, by finite elements.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "../view/balloon_pictures.hpp"
#include "makers.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/fem_fields.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {

namespace {

constexpr std::size_t most_panels = 6;
constexpr std::size_t most_frames = 240;
constexpr int pause = 8;           // between frames [1/100 s]
constexpr double jet_speed = 0.1;  // over the greatest of the run, above which there is a jet
constexpr double at_rest = 1e-3;   // speed over the greatest of the run, below which there are no streamlines

/// The shape and speed of a balloon at one time.
struct Shape {
  double time;        ///< [s]
  double top;         ///< height of the pole [m]
  double widest;      ///< greatest distance of the membrane from the axis [m]
  double lowest;      ///< height of the lowest point of the liquid [m]
  double highest;     ///< of the highest
  double elongation;  ///< height by width
  double centre;      ///< height of the centre of volume inside the membrane by that of the pole
  double fastest;     ///< greatest speed [m/s]
};

/// Centre of the volume inside a line from the pole to the rim, int z r^2 dz / int r^2 dz, by the trapezoidal rule.
double centre_height(const std::vector<PlanePoint>& line) {
  double moment = 0;
  double volume = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto& [ra, za] = line[i - 1];
    const auto& [rb, zb] = line[i];
    moment += (za * ra * ra + zb * rb * rb) * (za - zb);
    volume += (ra * ra + rb * rb) * (za - zb);
  }
  return moment / volume;
}

Shape shape_of(const FemField& field) {
  Shape shape{field.time, field.membrane.front()[1], 0, 0, 0, 0, 0, 0};
  for (std::size_t i = 0; i < field.grid.points.size(); i += 3) {
    shape.widest = std::max(shape.widest, field.grid.points[i]);
    shape.lowest = std::min(shape.lowest, field.grid.points[i + 1]);
    shape.highest = std::max(shape.highest, field.grid.points[i + 1]);
    shape.fastest = std::max(shape.fastest, std::hypot(field.velocity[i], field.velocity[i + 1]));
  }
  shape.elongation = shape.top / (2 * shape.widest);
  shape.centre = centre_height(field.membrane) / shape.top;
  return shape;
}

auto by(double Shape::* quantity) {
  return [quantity](const Shape& a, const Shape& b) { return a.*quantity < b.*quantity; };
}

BalloonStage stage_of(const std::vector<Shape>& shapes) {
  BalloonStage stage{0, 0, 0, 0};
  for (const Shape& shape : shapes) {
    stage.widest = std::max(stage.widest, shape.widest);
    stage.lowest = std::min(stage.lowest, shape.lowest);
    stage.highest = std::max(stage.highest, shape.highest);
    stage.fastest = std::max(stage.fastest, shape.fastest);
  }
  if (!(stage.fastest > 0)) stage.fastest = 1;  // never moves: one colour
  return stage;
}

/// The first field with a jet, the longest shape, the pear after it, and what lies furthest in time from those; in
/// order.
std::vector<std::size_t> panel_fields(const std::vector<Shape>& shapes, double fastest) {
  const auto jet = std::ranges::find_if(shapes, [&](const Shape& s) { return s.fastest >= jet_speed * fastest; });
  const auto longest = std::max_element(jet, shapes.end(), by(&Shape::elongation));
  const auto pear = std::max_element(longest, shapes.end(), by(&Shape::centre));
  std::set<std::size_t> chosen;
  for (const auto& place : {jet, longest, pear}) {
    if (place != shapes.end()) chosen.insert(static_cast<std::size_t>(place - shapes.begin()));
  }
  const std::size_t first = chosen.empty() ? 0 : *chosen.begin();
  const auto distance = [&](std::size_t i) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t other : chosen) least = std::min(least, std::abs(shapes[i].time - shapes[other].time));
    return least;
  };
  while (chosen.size() < std::min(most_panels, shapes.size() - first)) {
    std::size_t furthest = first;
    for (std::size_t i = first; i < shapes.size(); ++i) {
      if (distance(i) > distance(furthest)) furthest = i;
    }
    chosen.insert(furthest);
  }
  return {chosen.begin(), chosen.end()};
}

/// Fields spread evenly when there are more than a film has frames.
std::vector<std::size_t> frame_fields(std::size_t count) {
  std::vector<std::size_t> chosen(std::min(count, most_frames));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    chosen[i] = chosen.size() < 2 ? 0 : i * (count - 1) / (chosen.size() - 1);
  }
  return chosen;
}

Table shape_table(const Case& c, const std::vector<Shape>& shapes) {
  Table table("t [s],p_gauge [Pa],z_top [m],r_max [m],height by width [1],centre by height [1],speed_max [m/s]");
  for (const Shape& shape : shapes) {
    table.add(
        {shape.time, c.pressure(shape.time), shape.top, shape.widest, shape.elongation, shape.centre, shape.fastest});
  }
  return table;
}

void add_wall(Table& table, const FemField& field) {
  for (std::size_t i = 0; i < field.membrane.size(); ++i) {
    table.add({field.time, field.membrane[i][0], field.membrane[i][1], field.membrane_at_start[i][0],
               field.membrane_at_start[i][1]});
  }
}

void add_streams(Table& table, const FemField& field, const StreamLines& streams) {
  double number = 0;
  for (const StreamLine& line : streams.lines) {
    ++number;
    for (const auto& [r, z] : line.points) table.add({field.time, number, line.flux, r, z});
  }
}

void make_panels(Studio& studio, const Case& c, const FemFields& fields, const BalloonStage& stage,
                 const std::vector<std::size_t>& chosen) {
  std::vector<FemField> shown;
  std::vector<StreamLines> streams;
  std::vector<BalloonScene> scenes;
  Table walls("t [s],r [m],z [m],r at start [m],z at start [m]");
  Table lines("t [s],line [1],flux [m^3/s],r [m],z [m]");
  shown.reserve(chosen.size());  // scenes refer to them
  streams.reserve(chosen.size());
  scenes.reserve(chosen.size());
  for (const std::size_t i : chosen) {
    shown.push_back(fields.read(i));
    streams.push_back(stream_lines(shown.back(), at_rest * stage.fastest));
    scenes.push_back({shown.back(), streams.back(), c.pressure(shown.back().time)});
    add_wall(walls, shown.back());
    add_streams(lines, shown.back(), streams.back());
  }
  studio.table("figure-5-walls", walls);
  studio.table("figure-5-streamlines", lines);
  studio.picture("figure-5", [&](const auto& folder) { return draw_balloon(scenes, stage, folder, "figure-5"); });
}

void make_film(Studio& studio, const Case& c, const FemFields& fields, const BalloonStage& stage) {
  const std::vector<std::size_t> chosen = frame_fields(fields.size());
  const auto frame = [&](std::size_t i) {
    const FemField field = fields.read(chosen[i]);
    const StreamLines streams = stream_lines(field, at_rest * stage.fastest);
    return balloon_frame({field, streams, c.pressure(field.time)}, stage);
  };
  studio.film("figure-5-film", chosen.size(), frame, balloon_film_size(stage), pause);
}

}  // namespace

void make_jet_figure(Studio& studio) {
  const Case c = studio.read(studio.cases().front());
  const std::string run = c.file.stem().string() + ".fem";
  const FemResponse response = read_fem_response(c, studio.fem() / run);
  const FemFields fields(studio.fem() / run);
  std::vector<Shape> shapes;
  shapes.reserve(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) shapes.push_back(shape_of(fields.read(i)));
  if (!response.warnings.empty()) {
    studio.say("Not complete: `" + run + "`, whose fields come to t = " + rounded(shapes.back().time) + " of " +
               rounded(c.solve.t_end) + " s.");
  }
  studio.table("figure-5", shape_table(c, shapes));
  const BalloonStage stage = stage_of(shapes);
  make_panels(studio, c, fields, stage, panel_fields(shapes, stage.fastest));
  make_film(studio, c, fields, stage);
}

}  // namespace turgor
