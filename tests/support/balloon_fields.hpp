#pragma once
// Fields of a run directory that are made up: a balloon of the shape of a jar that is pulled upwards.

#include <cmath>
#include <numbers>

#include "program.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor::test {

/// A jar of height 0.6 m over an orifice of 0.03 m, its lid flat: the membrane is side and lid.
struct Jar {
  static constexpr int cells = 4;
  static constexpr int nodes = 2 * cells + 1;
  static constexpr double height = 0.6;
  static constexpr double lid = 0.1;

  /// Its distance from the axis at a share of its height: 0.03 m at the rim, at most about 0.3 m.
  static double radius(double share) { return 0.03 + (lid - 0.03) * share + 0.24 * std::sin(std::numbers::pi * share); }

  /// At t = 0.
  static VtuGrid grid() {
    VtuGrid grid;
    for (int j = 0; j < nodes; ++j) {
      const double share = j / (nodes - 1.0);
      for (int i = 0; i < nodes; ++i) {
        grid.points.insert(grid.points.end(), {radius(share) * i / (nodes - 1.0), height * share, 0.0});
      }
    }
    const auto at = [](int i, int j) { return j * nodes + i; };
    for (int b = 0; b + 2 < nodes; b += 2) {
      for (int a = 0; a + 2 < nodes; a += 2) {
        grid.biquadratic.push_back({at(a, b), at(a + 2, b), at(a + 2, b + 2), at(a, b + 2), at(a + 1, b),
                                    at(a + 2, b + 1), at(a + 1, b + 2), at(a, b + 1), at(a + 1, b + 1)});
      }
    }
    return grid;
  }

  /// Pulled to `stretch` times its height, with the liquid in the flow (-r, 2 z) times a rate [1/s].
  static VtuGrid field(double stretch, double rate) {
    VtuGrid grid = Jar::grid();
    PointData velocity{"velocity", 3, {}};
    PointData displacement{"displacement", 3, {}};
    for (std::size_t i = 0; i < grid.points.size(); i += 3) {
      displacement.values.insert(displacement.values.end(), {0.0, (stretch - 1) * grid.points[i + 1], 0.0});
      grid.points[i + 1] *= stretch;
      velocity.values.insert(velocity.values.end(), {-rate * grid.points[i], 2 * rate * grid.points[i + 1], 0.0});
    }
    grid.data = {std::move(velocity), std::move(displacement)};
    return grid;
  }
};

/// Writes fields.pvd and its fields into a run directory: the jar at times 0, 0.1 s, ..., stretched by 1 + t, the
/// liquid at the rate t/s 1/s.
inline void write_fields(const std::filesystem::path& folder, int count) {
  std::filesystem::create_directories(folder / "fields");
  std::vector<VtuInstant> series;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i;
    series.push_back({t, "fields/flow-" + std::to_string(i) + ".vtu"});
    write(folder / series.back().file, vtu_text(Jar::field(1 + t, t)));
  }
  write(folder / "fields.pvd", pvd_text(series));
}

}  // namespace turgor::test
