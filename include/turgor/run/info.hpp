#pragma once
// What can be said about a case beyond its trajectory.

#include <string>
#include <vector>

#include "turgor/run/run_case.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

/// Equilibria at one of the pressures that a program holds or reaches.
struct EquilibriaAt {
  double time;      ///< [s]
  double pressure;  ///< [Pa]
  std::vector<Equilibrium> states;
};

/// Oscillation about a stable equilibrium, on each regime's own clock: eqs. (3.6a), (3.6b), (3.7) for the chosen model.
struct TimeConstants {
  double stretch;
  double deflation;  ///< 1/omega with the mass of deflation [s]
  double inflation;  ///< 1/omega with the mass of inflation [s]
};

struct CaseInfo {
  Groups<double> groups_si;       ///< with p_typ = 1 Pa and t_typ = 1 s
  Groups<double> groups_natural;  ///< with the case's own scales
  std::vector<LimitPoint> limit_points;
  std::vector<EquilibriaAt> equilibria;  ///< at t = 0, at knots and at the end: up to 12 different pressures
  std::vector<TimeConstants> time_constants;
  RunResult run;  ///< the model choice and the strained assumptions need the range of stretches
};

[[nodiscard]] CaseInfo case_info(const Case& c);

[[nodiscard]] std::string info_text(const Case& c, const CaseInfo& info);
[[nodiscard]] std::string info_json(const Case& c, const CaseInfo& info);

}  // namespace turgor
