#include "turgor/asymptotics/equilibria.hpp"

#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

namespace {

/// S1 and S2 of (2.21), here in Pa.
struct Stiffness {
  double S1, S2;
};

Stiffness stiffness(const Parameters<double>& p) {
  const auto* solid = std::get_if<MooneyRivlin<double>>(&p.material);
  if (solid == nullptr) {
    throw InvalidInput("material.model", "", "(3.3) and (3.5) are those of the Mooney-Rivlin solid",
                       "other materials have their equilibria by equilibria() only");
  }
  const double factor = 4 * p.thickness / p.radius;
  return {factor * solid->s1, factor * solid->s2};
}

/// How far the equilibrium is from R, by the static pressure and its first two derivatives there.
double distance_to_equilibrium(const Stiffness& s, double pressure, double R) {
  const double missing = pressure - (s.S1 * (1 / R - 1 / power<7>(R)) + s.S2 * (R - 1 / power<5>(R)));
  const double r2 = R * R;
  const double slope = s.S1 * (7 / power<4>(r2) - 1 / r2) + s.S2 * (1 + 5 / power<3>(r2));
  const double curvature = s.S1 * (2 / (r2 * R) - 56 / power<9>(R)) - s.S2 * 30 / power<7>(R);
  const double square = slope * slope + 2 * curvature * missing;
  return 2 * missing / (slope + std::sqrt(std::max(square, 0.0)));
}

}  // namespace

SmallEquilibrium small_equilibrium(const Parameters<double>& p, double pressure) {
  const Stiffness s = stiffness(p);
  const auto refuse = [&](const std::string& problem, const std::string& advice) {
    throw InvalidInput("pressure", shortest(pressure) + " Pa", problem, advice);
  };
  for (const LimitPoint& limit : limit_points(p)) {
    if (!limit.maximum) continue;
    if (!(pressure < limit.pressure)) {
      refuse("there is no small equilibrium", "it ends at the limit point, at " + shortest(limit.pressure) + " Pa");
    }
    break;
  }
  const double stiff = 6 * (s.S1 + s.S2);
  const double square = stiff * stiff + 48 * pressure * s.S2 - 63 * pressure * pressure;
  const double divisor = stiff - 7 * pressure + std::sqrt(std::max(square, 0.0));
  if (!(square >= 0) || !(divisor > 0)) {
    refuse("(3.3) has no root near 1 at such a pressure",
           "it is meant for pressures well below " + rounded(stiff) + " Pa");
  }
  const double delta = 2 * pressure / divisor;
  const double R = 1 + delta + delta * delta;
  return {delta, {R, std::abs(distance_to_equilibrium(s, pressure, R))}};
}

Estimate large_equilibrium(const Parameters<double>& p, double pressure) {
  const Stiffness s = stiffness(p);
  if (!(s.S2 > 0)) {
    throw InvalidInput("material.s2", shortest(s.S2 * p.radius / (4 * p.thickness)) + " Pa",
                       "without it nothing holds a large balloon", "(3.5) needs s2 > 0");
  }
  const double least = 2 * std::sqrt(std::max(s.S1, 0.0) * s.S2);
  if (!(pressure >= least) || !(pressure > 0)) {
    throw InvalidInput("pressure", shortest(pressure) + " Pa", "(3.5) is complex below 2 sqrt(S1 S2)",
                       "at least " + shortest(least) + " Pa, though the equilibrium may exist below that");
  }
  const double R = (pressure + std::sqrt(pressure * pressure - 4 * s.S1 * s.S2)) / (2 * s.S2);
  return {R, std::abs(distance_to_equilibrium(s, pressure, R))};
}

}  // namespace turgor
