#pragma once
// Conforming meshes block by block: lines of points that neighbouring blocks share.

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace turgor {

/// A place in the meridional half plane: distance from the axis + i height [m].
using Place = std::complex<double>;
/// Indices of points along a line.
using Line = std::vector<std::size_t>;

class BlockBuilder {
 public:
  std::size_t add(const Place& place);
  [[nodiscard]] Place place(std::size_t point) const { return {points_[point][0], points_[point][1]}; }
  [[nodiscard]] Place place_on(const Line& line, std::size_t i) const { return place(line[i]); }

  /// One row of cells between two lines of as many points, which run to the right of the way from south to north.
  void strip(const Line& south, const Line& north);

  /// Fills the block between four lines by transfinite interpolation. South and north run from west to east, west and
  /// east from south to north; lines that meet share their point.
  void fill(const Line& south, const Line& east, const Line& north, const Line& west);

  [[nodiscard]] const std::vector<std::array<double, 2>>& points() const { return points_; }
  [[nodiscard]] const std::vector<std::array<std::size_t, 4>>& cells() const { return cells_; }

 private:
  std::vector<std::array<double, 2>> points_;
  std::vector<std::array<std::size_t, 4>> cells_;
};

}  // namespace turgor
