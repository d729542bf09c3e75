#pragma once
// What the closed approximations of section 3 say about a case at its final pressure.

#include <optional>
#include <string>
#include <vector>

#include "turgor/asymptotics/decay.hpp"
#include "turgor/asymptotics/matched_deflation.hpp"
#include "turgor/case/case.hpp"

namespace turgor {

/// An approximation that has a domain: its value, or why there is none.
struct Attempt {
  std::optional<Estimate> estimate;
  std::string refusal;  ///< empty when there is an estimate
};

/// An approximation of an equilibrium beside the stable one that is nearest to it.
struct ClosedEquilibrium {
  std::string equation;  ///< "(3.3)" or "(3.5)"
  Attempt stretch;
  std::optional<double> exact;
};

/// Free motion about one stable equilibrium, deflating first, on deflation's own clock: t_typ = t_-.
struct MotionForecast {
  FreeMotion motion;
  double start;                      ///< R_i
  std::optional<Gammas> constants;   ///< nothing for the full model, whose deflation has no closed approximation
  double alpha2;                     ///< (3.20b)
  Attempt deflation_paper;           ///< T_d->i of (3.17) [s]
  Attempt deflation;                 ///< the same by the uniform solution [s]
  Attempt turning_point;             ///< R at its end, by the uniform solution
  Estimate inflation;                ///< T_i->d from the undershoot [s]
  Estimate undershoot;               ///< below R_eq, from R_i
  Estimate greatest_undershoot;      ///< 1/(2 beta)
  double cycle_time;                 ///< of small oscillations [s]
  std::vector<long> cycles;          ///< after which
  std::vector<Estimate> amplitudes;  ///< the upper turning point is so far above R_eq
};

struct AsymptoticsReport {
  double pressure;  ///< final gauge pressure [Pa]
  Model model;
  std::vector<Equilibrium> equilibria;  ///< exact
  std::vector<ClosedEquilibrium> closed;
  std::vector<MotionForecast> motions;  ///< one for each stable equilibrium, in order of R
};

/// The model is the case's own, or with "auto" (2.23) without and (2.25) with a channel. Nothing is integrated.
/// @param start  R_i of the equilibrium in whose well it lies; the others, and all without it, start at 1.05 R_eq or,
///               where that is less, halfway to the next unstable equilibrium
/// @throws InvalidInput for `pressure` when it never becomes constant, or holds no stable equilibrium; for --from when
/// it
///         lies above no stable equilibrium
[[nodiscard]] AsymptoticsReport asymptotics_report(const Case& c, std::optional<double> start = {});

[[nodiscard]] std::string asymptotics_text(const Case& c, const AsymptoticsReport& report);
[[nodiscard]] std::string asymptotics_json(const Case& c, const AsymptoticsReport& report);

}  // namespace turgor
