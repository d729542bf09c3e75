#pragma once
// Where to put points on a line so that the steps between them follow a size that varies along it.

#include <cstddef>
#include <functional>
#include <vector>

namespace turgor {

using SizeAlong = std::function<double(double)>;

/// Number of steps, at least 1, from `from` to `to` whose lengths are size(x), to the nearest whole number.
[[nodiscard]] std::size_t steps(double from, double to, const SizeAlong& size);

/// That many steps from `from` to `to`, both included, in proportion to size(x).
[[nodiscard]] std::vector<double> spaced(double from, double to, std::size_t steps, const SizeAlong& size);

}  // namespace turgor
