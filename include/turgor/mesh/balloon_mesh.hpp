#pragma once
// A mesh of quadrilaterals of the liquid in a balloon and its channel, in a meridional half plane.

#include <array>
#include <cstddef>
#include <vector>

namespace turgor {

/// Parts of the liquid's boundary. The inlet is the orifice where there is no channel, else the channel's far end.
enum class Side { axis, wall, inlet, channel };

/// Places are (distance r from the axis, height z above the orifice) [m]. The balloon's wall is a part of the sphere
/// about (0, sphere_centre) that passes through the rim (a, 0); the channel is 0 <= r <= a, -L <= z <= 0.
struct BalloonMesh {
  struct Edge {
    std::array<std::size_t, 2> points;  ///< the liquid lies to the left
    Side side;
  };
  static constexpr int no_edge = -1;

  std::vector<std::array<double, 2>> points;
  std::vector<std::array<std::size_t, 4>> cells;  ///< corners, counterclockwise
  std::vector<Edge> boundary;                     ///< every boundary edge once
  std::vector<int> wall_edge;  ///< of each cell: from its corner of that number to the next, or no_edge
  double sphere_centre = 0;
  double sphere_radius = 0;

  /// The place of (xi, eta) in [0, 1]^2 in a cell whose corners 0...3 are at (0,0), (1,0), (1,1), (0,1): bilinear, and
  /// blended with the wall's exact arc, uniform in angle, in a cell with an edge on it (Gordon and Hall).
  [[nodiscard]] std::array<double, 2> at(std::size_t cell, double xi, double eta) const;
};

/// What a mesh is asked for; all in [m].
struct MeshRequest {
  double orifice_radius;  ///< a
  double channel_length;  ///< 0 for none
  double radius;          ///< of the sphere, from least_radius_ratio a to greatest_radius_ratio a
  double rim;             ///< size of cells at the rim
  double orifice;         ///< size over the orifice; less where the wall's size asks for more columns
  double wall;            ///< size of cells along the far wall; in the bulk at most twice as much
};

/// The layout leaves no room for its blocks in smaller balloons.
constexpr double least_radius_ratio = 1.6;
/// Rounding would show in larger ones.
constexpr double greatest_radius_ratio = 1e4;
/// More cells are taken for a mistake.
constexpr double most_cells = 1e6;

/// Structured blocks without hanging nodes: a fan about the rim, a block from the orifice to the axis, rings from axis
/// to wall up to the pole, straight columns in the channel. Halving all sizes halves every cell both ways.
/// @throws InvalidInput naming fem.h_rim, fem.h_orifice, fem.h_wall, inlet.orifice_radius, inlet.channel_length or
///         balloon.radius
[[nodiscard]] BalloonMesh balloon_mesh(const MeshRequest& request);

}  // namespace turgor
