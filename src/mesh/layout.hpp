#pragma once
// How many cells each block of a balloon's mesh has, and where the blocks meet.

#include <cstddef>

#include "turgor/mesh/balloon_mesh.hpp"

namespace turgor {

/// Blocks with corners at the rim, above the orifice's plane.
constexpr std::size_t rim_blocks = 3;
/// Greatest ratio of a cell's sides in the channel.
constexpr double channel_aspect = 20;
/// Greatest length of cells in the channel, over the size over the orifice.
constexpr double channel_step = 5;

struct MeshLayout {
  MeshRequest request;
  double centre;              ///< height of the sphere's centre [m]
  double wedge;               ///< liquid's angle at the rim, above the orifice's plane
  double fan_radius;          ///< of the fan about the rim [m]
  double core_radius;         ///< of the blocks in it that have corners at the rim [m]
  double orifice;             ///< size over the orifice [m], at most the one asked for
  std::size_t core;           ///< cells along the sides of those blocks
  std::size_t inner_sectors;  ///< sectors of the fan that face the axis
  std::size_t outer_sectors;  ///< those that face the rings
  std::size_t columns;        ///< of the block from the orifice to the axis

  [[nodiscard]] std::size_t sectors() const { return inner_sectors + outer_sectors; }
  /// Cells of a ring from axis to wall; even.
  [[nodiscard]] std::size_t ring() const { return columns + outer_sectors; }
};

/// @throws InvalidInput when the request cannot be met
[[nodiscard]] MeshLayout mesh_layout(const MeshRequest& request);

}  // namespace turgor
