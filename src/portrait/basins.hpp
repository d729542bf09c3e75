#pragma once
// Areas between separatrices.

#include "turgor/portrait/portrait.hpp"

namespace turgor {

/// What states of rest in the window come to, cut where separatrices cross dR/dT = 0.
[[nodiscard]] std::vector<RestInterval> fates_at_rest(const PhasePlane& plane, const PhaseWindow& window,
                                                      const std::vector<PhaseCurve>& separatrices);

/// The window in columns, each cut where separatrices cross it, and parts of neighbouring columns joined.
[[nodiscard]] std::vector<BasinStrip> basin_strips(const PhasePlane& plane, const PhaseWindow& window,
                                                   const std::vector<PhaseCurve>& separatrices);

}  // namespace turgor
