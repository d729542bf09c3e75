#pragma once
// Everything about the balloon of a case at rest.

#include <optional>
#include <string>
#include <vector>

#include "turgor/case/key_range.hpp"
#include "turgor/statics/bistability.hpp"
#include "turgor/statics/energy.hpp"
#include "turgor/statics/families.hpp"

namespace turgor {

/// Bistable windows against a parameter: where in the plane of parameter and pressure there are two stable states.
struct BistabilityMap {
  struct Row {
    double parameter;
    BistableWindow window;
  };
  std::vector<Row> rows;  ///< parameter increasing; only where there is a window
  std::vector<Cusp> cusps;
};

/// @param points  number of parameters, evenly spaced, both ends included
[[nodiscard]] BistabilityMap bistability_map(const BalloonFamily& family, const ParameterRange& range, int points);

/// The map of all Mooney-Rivlin balloons of a case's geometry and closure: S1/S2 against P0/S2.
struct MooneyRivlinMap {
  BistabilityMap map;
  double ratio;  ///< S1/S2 of the case
  double unit;   ///< S2 p_typ of the case [Pa]
};
/// For S1/S2 from 2 to beyond that of the case; nothing for other materials and for s1, s2 <= 0.
[[nodiscard]] std::optional<MooneyRivlinMap> mooney_rivlin_map(const Case& c);

/// States of rest over one key of a case.
struct KeyStudy {
  KeyRange range;
  std::vector<RestCurve> equilibria;    ///< at the case's final pressure, or the one that the key gives it
  std::vector<RestCurve> limit_points;  ///< pressures of limit points, whatever the case's own
  BistabilityMap map;
};

/// Limit points in the plane of two keys.
struct PlaneStudy {
  KeyRange first;
  KeyRange second;
  std::vector<RestCurve> limit_points;
};

struct StaticQuestions {
  std::optional<double> compliance;  ///< of the supply [m^3/Pa]
  std::vector<KeyRange> over;        ///< none, one key or two
};

struct StaticStudy {
  double pressure;  ///< [Pa]; the case's last: after the last knot, or at t_end of a harmonic pressure
  std::vector<LimitPoint> limit_points;
  std::vector<Equilibrium> equilibria;
  std::vector<Well> wells;
  std::vector<BistableWindow> windows;
  std::vector<Jump> jumps;     ///< under a prescribed pressure
  double critical_compliance;  ///< [m^3/Pa]
  std::optional<Loading> supply;
  std::vector<Jump> filling_jumps;  ///< with that supply
  std::optional<KeyStudy> over;
  std::optional<PlaneStudy> plane;
};

/// @throws InvalidInput when the case dictates the motion, and when a value within a range does not go with the rest of
/// the case
[[nodiscard]] StaticStudy study_statics(const Case& c, const StaticQuestions& questions);

/// One state of rest on the curve p0(R).
struct StaticRow {
  double stretch;
  double pressure;  ///< [Pa]
  bool stable;
  bool limit_point;
};
/// From below everything that the study found to above it, dense enough for a picture, limit points among them.
[[nodiscard]] std::vector<StaticRow> static_curve(const Case& c, const StaticStudy& study);

[[nodiscard]] std::string statics_text(const Case& c, const StaticStudy& study);
[[nodiscard]] std::string statics_json(const Case& c, const StaticStudy& study);
/// The curve p0(R): R, volume, pressure, strain energy, potential energy at the study's pressure, stability.
[[nodiscard]] std::string statics_csv(const Case& c, const StaticStudy& study);
/// Curves over keys: which curve, the keys, R, pressure, stability, whether the curve turns.
[[nodiscard]] std::string branches_csv(const StaticStudy& study);

}  // namespace turgor
