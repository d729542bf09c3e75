#pragma once
// A phase portrait in the manner of figures 8 and 9: everything that is drawn, dimensionless.

#include <string_view>
#include <vector>

#include "turgor/portrait/phase_plane.hpp"

namespace turgor {

enum class CurveKind {
  inflation,                ///< level sets of the first integral; with an exact closure and a channel, by quadrature
  deflation,                ///< by quadrature
  slow_manifold,            ///< (3.21)
  corrected_slow_manifold,  ///< the same with the acceleration along it
  separatrix,               ///< boundaries between basins
};
/// "inflation", "slow-manifold", ...
[[nodiscard]] std::string_view name_of(CurveKind kind);

struct KindOfCurve {
  CurveKind kind;
  PhaseCurve points;
};

/// Stretches from ... to.
struct StretchInterval {
  double from;
  double to;
};

/// Balloons left at rest between two stretches all end alike.
struct RestInterval {
  StretchInterval stretches;
  Fate fate;
};

/// A part of one basin: at every stretch the rates from `low` to `high`.
struct BasinColumn {
  double stretch, low, high;
};
struct BasinStrip {
  Fate fate;
  std::vector<BasinColumn> columns;
};

struct Portrait {
  PhaseWindow window;
  std::vector<KindOfCurve> curves;
  std::vector<StretchInterval> forbidden;  ///< for slow deflation, (3.21)
  std::vector<RestInterval> at_rest;       ///< in order of R, without gaps
  std::vector<BasinStrip> basins;
};

/// Parts of a window to be chosen otherwise than by natural_window(); 0: not chosen.
struct WindowWishes {
  double least_stretch = 0;
  double greatest_stretch = 0;
  double deflation = 0;
  double inflation = 0;
};

/// Stretches around all equilibria and the nearest turning point of the separatrix below them; rates that inflation
/// from rest and slow deflation reach within.
[[nodiscard]] PhaseWindow natural_window(const PhasePlane& plane, const WindowWishes& wishes = {});

/// Trajectories start at rest, evenly between neighbouring equilibria, and at the window's lower edge.
[[nodiscard]] Portrait make_portrait(const PhasePlane& plane, const PhaseWindow& window);

}  // namespace turgor
