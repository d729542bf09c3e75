#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "balance.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/statics/continuation.hpp"

namespace turgor {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// d0 mu/r0, or the pressure in a sphere of a volume where that is greater: a material that stiffens would make the
/// branch as long as its pressure is high.
double typical_pressure(const Membrane& membrane, double radius, double volume) {
  const double stretch = std::cbrt(volume * 3 / (4 * std::numbers::pi)) / radius;
  const MembraneWall& wall = membrane.wall();
  const double there = strain_energy(wall.material, stretch).first / (stretch * stretch);
  return wall.thickness / radius * std::max(shear_modulus(wall.material), std::isfinite(there) ? there : 0.0);
}

/// The balance of forces as a branch: unknowns are the free places over the radius and over the root of their number,
/// the radius of a sphere of the same volume, and the pressure, all of the order of one.
class Branching {
 public:
  /// @param volume  at which the branch is to end [m^3]
  Branching(const Membrane& membrane, const MembraneState& start, double volume)
      : membrane_(membrane),
        places_(start.places),
        unknowns_(balance_of(membrane, start.places, start.pressure, membrane.volume(start.places)).unknowns),
        radius_(slack_state(membrane).radius),
        length_(radius_ * std::sqrt(static_cast<double>(unknowns_.size()))),
        pressure_(typical_pressure(membrane, radius_, volume)) {}

  [[nodiscard]] double scaled_volume(double volume) const {
    return std::cbrt(volume * 3 / (4 * std::numbers::pi)) / radius_;
  }

  [[nodiscard]] VectorXd scaled(const MembraneState& state) const {
    VectorXd x(size() + 2);
    x << state.places(unknowns_) / length_, scaled_volume(state.volume), state.pressure / pressure_;
    return x;
  }

  [[nodiscard]] MembraneState state(const VectorXd& x) const { return state_at(membrane_, places(x), pressure(x)); }

  [[nodiscard]] VectorXd residual(const VectorXd& x) const {
    VectorXd out(size() + 1);
    try {
      const MembraneForm volume = membrane_.volume(places(x));
      out << balance_of(membrane_, places(x), pressure(x), volume).force / force(),
          x(size()) - scaled_volume(2 * std::numbers::pi * volume.value);
    } catch (const ComputationFailed&) {
      out.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return out;
  }

  [[nodiscard]] MatrixXd jacobian(const VectorXd& x) const {
    const Index n = size();
    MatrixXd out = MatrixXd::Zero(n + 1, n + 2);
    try {
      const MembraneForm volume = membrane_.volume(places(x));
      const Balance balance = balance_of(membrane_, places(x), pressure(x), volume);
      const VectorXd load = volume.gradient(unknowns_);
      const double whole = 2 * std::numbers::pi * volume.value;
      out.topLeftCorner(n, n) = MatrixXd(balance.tangent) * (length_ / force());
      out.col(n + 1).head(n) = load * (-pressure_ / force());
      const double slope = scaled_volume(whole) / (3 * volume.value);
      out.row(n).head(n) = -slope * length_ * load.transpose();
      out(n, n) = 1;
    } catch (const ComputationFailed&) {
      out.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return out;
  }

 private:
  [[nodiscard]] Index size() const { return static_cast<Index>(unknowns_.size()); }
  [[nodiscard]] double force() const { return pressure_ * radius_ * radius_; }
  [[nodiscard]] double pressure(const VectorXd& x) const { return x(size() + 1) * pressure_; }
  [[nodiscard]] VectorXd places(const VectorXd& x) const {
    VectorXd out = places_;
    out(unknowns_) = x.head(size()) * length_;
    return out;
  }

  const Membrane& membrane_;
  VectorXd places_;
  std::vector<Index> unknowns_;
  double radius_;    // [m]
  double length_;    // of places [m]
  double pressure_;  // [Pa]
};

}  // namespace

InflationCurve inflation_curve(const Membrane& membrane, const MembraneState& start, double volume) {
  if (!(volume > start.volume) || !std::isfinite(volume)) {
    throw InvalidInput("volume", shortest(volume) + " m^3", "must be finite and greater than at the start",
                       "that is " + shortest(start.volume) + " m^3");
  }
  const Branching branching(membrane, start, volume);
  const VectorXd from = branching.scaled(start);
  ContinuationProblem problem;
  problem.residual = [&](const VectorXd& x) { return branching.residual(x); };
  problem.jacobian = [&](const VectorXd& x) { return branching.jacobian(x); };
  constexpr double far = 1e3;
  const Index ball = from.size() - 2;
  problem.least = VectorXd::Constant(from.size(), -far);
  problem.greatest = VectorXd::Constant(from.size(), far);
  problem.greatest(ball) = branching.scaled_volume(volume);
  const Branch branch = follow_branch(problem, from, 1, {.greatest_step = 0.05, .tolerance = 1e-11});
  InflationCurve curve;
  for (const BranchPoint& point : branch.points) {
    if (point.fold) curve.limit_points.push_back(curve.states.size());
    curve.states.push_back(branching.state(point.x));
  }
  if (branch.end == BranchEnd::left_box && branch.points.back().x(ball) == problem.greatest(ball)) return curve;
  const MembraneState last = curve.states.empty() ? start : curve.states.back();
  throw ComputationFailed("the curve of equilibria ends before a volume of " + shortest(volume) +
                          " m^3, at a gauge pressure of " + shortest(last.pressure) + " Pa and a volume of " +
                          shortest(last.volume) + " m^3");
}

MembraneState limit_point(const Membrane& membrane, double volume) {
  const InflationCurve curve = inflation_curve(membrane, slack_state(membrane), volume);
  if (!curve.limit_points.empty()) return curve.states[curve.limit_points.front()];
  throw ComputationFailed("the membrane has no limit point: its pressure rises all the way to " +
                          shortest(curve.states.back().pressure) + " Pa at a volume of " + shortest(volume) + " m^3");
}

}  // namespace turgor
