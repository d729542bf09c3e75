#pragma once
// Grids as VTK's XML files.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace turgor {

/// A quantity at the points of a grid.
struct PointData {
  std::string name;
  int components;
  std::vector<double> values;  ///< `components` for each point
};

struct VtuGrid {
  std::vector<double> points;  ///< three for each
  std::vector<std::array<std::int32_t, 4>> quadrilaterals;
  /// Curved quadrilaterals: corners around, the middles of the edges after each, the centre.
  std::vector<std::array<std::int32_t, 9>> biquadratic{};
  std::vector<PointData> data;
};

/// A .vtu file, its numbers in base64: 4/3 of their size in memory, bit for bit.
[[nodiscard]] std::string vtu_text(const VtuGrid& grid);

/// Reads such a file back: cells of these two kinds, point data of double precision.
/// @throws InvalidInput (without a key) naming the file, when it cannot be read, is none or of another layout, is cut
/// off, has cells of points that there are not, or a number that is none
[[nodiscard]] VtuGrid read_vtu(const std::filesystem::path& path);

/// A file at one time [s] of a series; its name is relative to the folder of the series.
struct VtuInstant {
  double time;
  std::string file;
};

/// A .pvd file: .vtu files with their times, which ParaView plays.
[[nodiscard]] std::string pvd_text(const std::vector<VtuInstant>& series);

/// Reads such a file back; possibly there are no instants.
/// @throws InvalidInput (without a key) naming the file, when it cannot be read, is none, or a time is no number
[[nodiscard]] std::vector<VtuInstant> read_pvd(const std::filesystem::path& path);

}  // namespace turgor
