#pragma once
// Gauss-Legendre rules of any size on [0, 1], made once.

#include <vector>

namespace turgor {

struct GaussLegendre {
  std::vector<double> node;  ///< in (0, 1)
  std::vector<double> weight;
};

/// @param size  1 to 128
[[nodiscard]] const GaussLegendre& gauss_legendre(int size);

}  // namespace turgor
