#pragma once
// Pictures of a balloon by finite elements: its wall and the flow in it.

#include <filesystem>
#include <string>
#include <vector>

#include "gnuplot.hpp"
#include "stream_lines.hpp"
#include "turgor/run/fem_fields.hpp"

namespace turgor {

/// A streamline, along which the flux through the circle about the axis is the same.
struct StreamLine {
  double flux;  ///< [m^3/s], positive upwards
  std::vector<PlanePoint> points;
};

/// Streamlines between which runs the same flux, 1, 2 or 5 times a power of ten.
struct StreamLines {
  double flux;  ///< between neighbours [m^3/s]; 0 when the liquid rests, and there are none
  std::vector<StreamLine> lines;
};

/// @param least  speed below which the liquid rests [m/s]
[[nodiscard]] StreamLines stream_lines(const FemField& field, double least);

/// What all pictures of one run have in common.
struct BalloonStage {
  double widest;  ///< distance from the axis that the liquid reaches [m]
  double lowest;  ///< heights between which it stays [m]
  double highest;
  double fastest;  ///< speed at the bright end of the colours [m/s], positive
};

/// A moment of a run.
struct BalloonScene {
  const FemField& field;
  const StreamLines& streams;
  double gauge_pressure;  ///< [Pa]
};

/// Draws NAME.{svg,png} into a folder, with its script: for each scene a panel with the wall, mirrored at the axis, the
/// speed as colours over three decades, streamlines, and dashed the wall at t = 0.
/// @return what went wrong; empty when the pictures are there
[[nodiscard]] std::string draw_balloon(const std::vector<BalloonScene>& scenes, const BalloonStage& stage,
                                       const std::filesystem::path& folder, const std::string& name);

/// One such panel as a picture of a film of balloon_film_size().
[[nodiscard]] FilmFrame balloon_frame(const BalloonScene& scene, const BalloonStage& stage);
[[nodiscard]] PictureSize balloon_film_size(const BalloonStage& stage);

}  // namespace turgor
