#pragma once
// Two stable states at one pressure: when there are, which one is deeper, and how the balloon jumps between them.

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "turgor/statics/statics.hpp"

namespace turgor {

/// Stretches from one extremum of the static pressure to the next between which it rises.
struct StableBranch {
  double least_stretch;
  double greatest_stretch;
  double least_pressure;     ///< [Pa]; -infinity where the material locks in compression
  double greatest_pressure;  ///< [Pa]; +infinity when it is beyond every number
};

/// All of them in order of R, over the stretches at which equilibria() looks.
[[nodiscard]] std::vector<StableBranch> stable_branches(const Parameters<double>& p);

/// Pressures that two neighbouring stable branches share.
struct BistableWindow {
  double least;                   ///< [Pa]
  double greatest;                ///< [Pa]
  std::optional<double> maxwell;  ///< [Pa]: both wells are equally deep; nothing when one is deeper throughout
};

/// In order of R; empty when no pressure has two stable equilibria. One for a curve with one maximum and one minimum.
[[nodiscard]] std::vector<BistableWindow> bistable_windows(const Parameters<double>& p);

/// What a balloon is held at while it is loaded slowly.
struct Loading {
  /// Compliance of the supply [m^3/Pa]: the volume that it gives when its pressure falls by 1 Pa, such as V/p of a gas
  /// at absolute pressure p (isothermal). Infinite: the pressure itself is prescribed. Zero: the volume is.
  double compliance = std::numeric_limits<double>::infinity();
};
inline constexpr Loading prescribed_pressure{};

/// Whether an equilibrium at R is stable: dp0/dV > -1/compliance, that is dp0/dV > 0 for a prescribed pressure and
/// always for a prescribed volume. V is working_volume().
[[nodiscard]] bool is_stable(const Parameters<double>& p, double R, const Loading& loading);

/// Where a slowly loaded balloon cannot follow any further and jumps.
struct Jump {
  double stretch;            ///< at the fold
  double pressure;           ///< [Pa] at the fold
  bool inflating;            ///< to larger stretches
  std::optional<double> to;  ///< stretch of the next stable state under the same load; nothing: nothing holds it
  double to_pressure = 0;    ///< [Pa] there; the same when the pressure is prescribed
  double released = 0;       ///< energy between the two [J], > 0
};

/// All jumps in order of R: from limit points for a prescribed pressure, else from where dp0/dV = -1/compliance.
/// R > 1.
/// @param loading  compliance >= 0; 0 has no jumps
[[nodiscard]] std::vector<Jump> jumps(const Parameters<double>& p, const Loading& loading);

/// Compliance [m^3/Pa] up to which filling the balloon never makes it jump: -1/min dp0/dV over R > 1. +infinity when
/// the pressure rises throughout.
[[nodiscard]] double critical_compliance(const Parameters<double>& p);

/// Balloons that depend on one parameter.
using BalloonFamily = std::function<Parameters<double>(double)>;

/// A balloon of a family at which limit points appear or vanish: dp0/dR = d2p0/dR2 = 0, a cusp of the bistable window.
struct Cusp {
  double parameter;
  double stretch;   ///< known to half of the digits
  double pressure;  ///< [Pa]
};

/// Parameters in [from, to] at which the pressure ceases to rise throughout R > 1, or begins to, in their order. Two
/// that are closer than (to - from)/64 can be missed.
/// @throws what the family throws
[[nodiscard]] std::vector<Cusp> find_cusps(const BalloonFamily& family, double from, double to);

}  // namespace turgor
