#pragma once
// The [sweep] table of a case: which keys take which values in a parameter study.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "turgor/case/node.hpp"

namespace turgor {

enum class Sampler {
  grid,             ///< every combination of the values of all axes
  latin_hypercube,  ///< each axis cut into as many strata of equal probability as there are members
  sobol,            ///< the low-discrepancy sequence of Sobol'
};
/// "grid", "latin-hypercube" or "sobol".
[[nodiscard]] std::string_view name_of(Sampler sampler);

/// Values from one end to the other, evenly spaced or in equal ratios: n of them in a grid, or a uniform (log-uniform)
/// distribution. SI units.
struct AxisRange {
  double from;
  double to;
  bool logarithmic;
  std::uint64_t count;  ///< 0 when sampled
};
/// A list of values, each in the form that the key takes; grids only.
struct AxisValues {
  std::vector<Node> values;
};
struct NormalAxis {
  double mean;
  double sigma;  ///< > 0
};
/// ln x is normal with mean ln(median) and standard deviation sigma.
struct LognormalAxis {
  double median;  ///< > 0, in the key's unit
  double sigma;   ///< > 0 [1]
};

/// One swept key.
struct Axis {
  std::string key;   ///< "inlet.orifice_radius"
  std::string unit;  ///< SI unit, "1" for a pure number, empty for words
  std::variant<AxisRange, AxisValues, NormalAxis, LognormalAxis> form;

  /// How many values a grid has along it; 0 when sampled.
  [[nodiscard]] std::uint64_t count() const;
};

/// The largest parameter study [members].
inline constexpr std::uint64_t most_members = 1'000'000'000;

struct SweepSettings {
  Sampler sampler = Sampler::grid;
  std::uint64_t members = 0;              ///< product of the axes' counts for a grid
  std::uint64_t seed = 0;                 ///< of the samplers
  std::vector<std::string> quantities{};  ///< asked quantities of interest, in the order of quantity_names()
  std::uint64_t event_times = 0;          ///< so many first events are kept of each member
  std::vector<Axis> axes{};
};

}  // namespace turgor
