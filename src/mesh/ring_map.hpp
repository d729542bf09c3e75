#pragma once
// The rings of a balloon's mesh from axis to wall: circles orthogonal to both, but for the first ones, which come from
// the orifice's blocks, and the last ones, which enclose the pole's.

#include <vector>

#include "block_builder.hpp"
#include "layout.hpp"

namespace turgor {

/// Greatest step between columns on the balloon's middle plane, over radius/ring().
constexpr double widest_column = 1.14;

/// x = z_c - i... The conformal map R tanh(w/2) about the sphere's centre, with the height as real part, takes the
/// strip 0 < Im w < pi/2 to the balloon: the axis has Im w = 0, the wall pi/2, both poles Re w = -inf and inf.
struct BipolarMap {
  double centre;
  double radius;

  [[nodiscard]] Place place(const std::complex<double>& w) const;
  [[nodiscard]] std::complex<double> strip(const Place& place) const;
};

class RingMap {
 public:
  /// @param first  the lowest ring's places, from axis to wall
  RingMap(const MeshLayout& layout, const std::vector<Place>& first);

  /// Values of the ring's coordinate at the first and the last ring.
  [[nodiscard]] double bottom() const { return bottom_; }
  [[nodiscard]] double top() const { return top_; }
  /// Place of column j on the ring at `level`.
  [[nodiscard]] Place place(double level, std::size_t column) const;

 private:
  BipolarMap map_;
  std::vector<std::complex<double>> first_;
  double bottom_ = 0;
  double free_ = 0;  ///< from where on rings do not remember the first one
  double top_ = 0;
};

/// Radius over that of its ends of the outline of a block whose corner is the centre, at `turn` from either end of
/// `opening`: between a circle and the block's two straight sides.
[[nodiscard]] double core_outline(double turn, double opening);

}  // namespace turgor
