#pragma once
// The elastic membrane of a case at rest, next to the model's sphere.

#include <optional>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/membrane/equilibrium.hpp"
#include "turgor/run/run_case.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

/// What the membrane of a case is made of, and how its rim is held.
/// @throws InvalidInput for a material that is a table, see refuse_two_stretches
[[nodiscard]] MembraneWall wall_of(const Case& c);

/// The membrane of a case on a chain of its own: 48 elements, finer towards the rim the smaller the orifice. Pressures
/// are within 1e-5 from R = 1.1 on, with orifices down to r0/100.
[[nodiscard]] Membrane membrane_of(const Case& c);

/// Volume of the sphere of a stretch through the rim [m^3], without the cap beyond the orifice.
[[nodiscard]] double balloon_volume(const Parameters<double>& p, double stretch);

struct MembraneQuestions {
  std::optional<double> up_to{};     ///< stretch at which the curve ends; else beyond all that (3.1) has to show
  std::optional<double> pressure{};  ///< [Pa], in place of the case's final one
  std::optional<double> volume{};    ///< [m^3]: also the state that has this volume
  bool limit_point = false;          ///< having none is an error
};

/// A state of rest, and what tables say of it.
struct MembraneRow {
  MembraneState state;
  double stretch;          ///< R = r_eff/r0
  double sphere_pressure;  ///< (3.1) at that stretch [Pa]
  double top;              ///< height of the pole over the orifice [m]
  double greatest_radius;  ///< distance of the wall from the axis [m]
  double energy;           ///< elastic [J]
  UnstableModes unstable;  ///< at a limit point those of its more stable side
  bool limit_point = false;

  [[nodiscard]] bool stable() const { return unstable.at_pressure == 0; }
};

/// An extremum of the pressure.
struct MembraneLimit {
  MembraneRow row;
  bool maximum;
  std::optional<LimitPoint> sphere;  ///< that of (3.1), if it has one of this kind in this place
};

struct MembraneStudy {
  MembraneWall wall;
  std::size_t elements;
  double pressure;                       ///< at which equilibria are sought [Pa]
  std::vector<MembraneRow> curve;        ///< from slack on, limit points among them
  std::vector<MembraneLimit> limits;     ///< in order of volume
  std::vector<MembraneRow> equilibria;   ///< at `pressure`, in order of volume
  std::vector<Equilibrium> sphere;       ///< those of (3.1)
  std::string why_none;                  ///< in words, when there are no equilibria
  std::string advice;                    ///< what to try then
  std::optional<MembraneRow> at_volume;  ///< when asked for
};

/// @throws InvalidInput naming --up-to, --pressure, --volume or --limit-point when there is no such state, and when the
///         case dictates the motion; ComputationFailed when the curve ends early
[[nodiscard]] MembraneStudy study_membrane(const Case& c, const MembraneQuestions& questions);

/// States whose shapes are worth a look: six from slack to the end of the curve, and the limit points, in order.
[[nodiscard]] std::vector<MembraneRow> shapes_of(const MembraneStudy& study);

/// What the statics of the membrane say of a coupled run before it begins: "membrane-limit" when the pressure goes
/// beyond the limit point and the start is below it, with the state that it snaps to; "membrane-buckling" when suction
/// or a start below the slack volume buckles it. A second's work at most, and none for a program that stays below 0.9
/// of (3.1)'s limit point.
/// @throws InvalidInput naming initial.stretch when there is no state of rest to start from
[[nodiscard]] std::vector<Warning> membrane_warnings(const Case& c);

[[nodiscard]] std::string membrane_text(const Case& c, const MembraneStudy& study);
[[nodiscard]] std::string membrane_json(const Case& c, const MembraneStudy& study);
/// The curve: R, r_eff, volume, pressure, that of (3.1), height, greatest radius, energy, unstable modes, limit points.
[[nodiscard]] std::string membrane_csv(const Case& c, const MembraneStudy& study);
/// Nodes of shapes_of(): number of the shape, R, pressure, r, z.
[[nodiscard]] std::string shapes_csv(const Case& c, const MembraneStudy& study);

}  // namespace turgor
