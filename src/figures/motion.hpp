#pragma once
// Free motion of a shipped balloon at the mean of its limit pressures, about its larger equilibrium, and the exact
// solution.

#include "studio.hpp"
#include "turgor/asymptotics/free_motion.hpp"
#include "turgor/integrate/trajectory.hpp"

namespace turgor {

/// On deflation's own clock.
struct LargeMotion {
  Case of;  ///< held at that pressure
  Oscillator<double> oscillator;
  FreeMotion motion;

  /// From rest at a stretch, by quadrature.
  /// @param events  after so many turning points; 0: until T = end
  [[nodiscard]] Trajectory<double> exact(double start, double end, long events = 0) const;
  /// R(T) of it.
  [[nodiscard]] double exact_stretch(double start, double T) const { return exact(start, T).last.stretch; }
};

[[nodiscard]] LargeMotion large_motion(const Studio& studio, const std::string& case_name);

/// A row of evenly spaced numbers, or of such in equal ratios; both ends included.
[[nodiscard]] std::vector<double> evenly(double from, double to, int count);
[[nodiscard]] std::vector<double> in_equal_ratios(double from, double to, int count);

}  // namespace turgor
