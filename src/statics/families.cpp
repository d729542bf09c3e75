#include "turgor/statics/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shape.hpp"

namespace turgor {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Values between 0 and 1 for those of a range.
struct Unit {
  ParameterRange range;
  [[nodiscard]] double value(double share) const {
    if (share <= 0) return range.from;
    if (share >= 1) return range.to;
    return range.from + share * (range.to - range.from);
  }
  [[nodiscard]] double share(double value) const { return (value - range.from) / (range.to - range.from); }
};

/// Equations in x = (ln R, shares of the parameters' ranges).
using Residual = std::function<VectorXd(const VectorXd&)>;

/// Differences stay in the box; their errors only slow down Newton's method.
VectorXd difference(const ContinuationProblem& problem, const VectorXd& x, Index i, double step) {
  VectorXd above = x;
  VectorXd below = x;
  above(i) = std::min(x(i) + step, problem.greatest(i));
  below(i) = std::max(x(i) - step, problem.least(i));
  return (problem.residual(above) - problem.residual(below)) / (above(i) - below(i));
}

constexpr double parameter_step = 1e-6;
constexpr double stretch_step = 1e-5;  // of ln R, for the derivative of a slope: error O(step^2) = 1e-10

ContinuationProblem problem_of(Residual residual, Index parameters, double least_stretch, double greatest_stretch) {
  ContinuationProblem problem{std::move(residual), {}, VectorXd::Zero(1 + parameters), VectorXd::Ones(1 + parameters)};
  problem.least(0) = std::log(least_stretch);
  problem.greatest(0) = std::log(greatest_stretch);
  return problem;
}

/// The static pressure where equilibria() would look; beyond, not a number, which ends a curve.
StaticPressure pressure_within(const Parameters<double>& p, double R) {
  constexpr double rounding = 1e-9;
  const Shape shape(p);
  const bool within = R > shape.least_stretch() * (1 - rounding) && R < shape.greatest_stretch() * (1 + rounding);
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  return within ? static_pressure(p, R) : StaticPressure{nothing, nothing};
}

bool ends_at(const std::vector<Branch>& branches, const VectorXd& x) {
  constexpr double close = 1e-6;
  return std::ranges::any_of(branches, [&](const Branch& branch) {
    return (branch.points.front().x - x).norm() < close || (branch.points.back().x - x).norm() < close;
  });
}

/// Follows every curve from where it meets the boundary of the box.
/// @param starts  solutions on the boundary; one of the two directions leaves the box at once
/// @param point   reads a solution
template <class Point>
std::vector<RestCurve> follow_all(const ContinuationProblem& problem, const std::vector<VectorXd>& starts,
                                  const Point& point) {
  std::vector<Branch> branches;
  for (const VectorXd& start : starts) {
    if (ends_at(branches, start)) continue;
    Branch up = follow_branch(problem, start, 1);
    Branch down = follow_branch(problem, start, -1);
    Branch& longer = up.points.size() >= down.points.size() ? up : down;
    if (longer.points.size() > 1) branches.push_back(std::move(longer));
  }
  std::vector<RestCurve> curves;
  for (const Branch& branch : branches) {
    RestCurve curve{{}, branch.end};
    for (const BranchPoint& p : branch.points) {
      curve.points.push_back(point(p.x));
      curve.points.back().turning = p.fold;
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

std::vector<RestCurve> equilibrium_curves(const LoadedFamily& family, const ParameterRange& range) {
  const Unit unit{range};
  const auto at = [&](const VectorXd& x) { return family(unit.value(x(1))); };
  const std::array ends{family(range.from), family(range.to)};
  const double scale = std::max(pressure_scale(ends[0].parameters, ends[0].pressure),
                                pressure_scale(ends[1].parameters, ends[1].pressure));
  const auto residual = [&](const VectorXd& x) {
    const LoadedBalloon balloon = at(x);
    const double p0 = pressure_within(balloon.parameters, std::exp(x(0))).value;
    return VectorXd::Constant(1, (p0 - balloon.pressure) / scale);
  };
  ContinuationProblem problem = problem_of(residual, 1, smallest_stretch, largest_stretch);
  problem.jacobian = [&](const VectorXd& x) {
    const double R = std::exp(x(0));
    MatrixXd jacobian(1, 2);
    jacobian << R * static_pressure(at(x).parameters, R).slope / scale, difference(problem, x, 1, parameter_step);
    return jacobian;
  };
  std::vector<VectorXd> starts;
  for (const int end : {0, 1}) {
    const LoadedBalloon& balloon = ends.at(static_cast<std::size_t>(end));
    for (const Equilibrium& state : equilibria(balloon.parameters, balloon.pressure)) {
      starts.push_back(Eigen::Vector2d(std::log(state.stretch), end));
    }
  }
  return follow_all(problem, starts, [&](const VectorXd& x) {
    const LoadedBalloon balloon = at(x);
    const double R = std::exp(x(0));
    const bool stable = static_pressure(balloon.parameters, R).slope > 0;
    return RestPoint{unit.value(x(1)), 0, R, balloon.pressure, stable, false};
  });
}

std::vector<RestCurve> limit_point_curves(const BalloonFamily& family, const ParameterRange& range) {
  const Unit unit{range};
  const auto at = [&](const VectorXd& x) { return family(unit.value(x(1))); };
  const double scale = pressure_scale(family(range.from), 0);
  const auto residual = [&](const VectorXd& x) {
    return VectorXd::Constant(1, pressure_within(at(x), std::exp(x(0))).slope / scale);
  };
  ContinuationProblem problem = problem_of(residual, 1, 1, largest_stretch);
  problem.jacobian = [&](const VectorXd& x) {
    MatrixXd jacobian(1, 2);
    jacobian << difference(problem, x, 0, stretch_step), difference(problem, x, 1, parameter_step);
    return jacobian;
  };
  std::vector<VectorXd> starts;
  for (const int end : {0, 1}) {
    for (const LimitPoint& point : limit_points(family(unit.value(end)))) {
      starts.push_back(Eigen::Vector2d(std::log(point.stretch), end));
    }
  }
  return follow_all(problem, starts, [&](const VectorXd& x) {
    const double R = std::exp(x(0));
    return RestPoint{unit.value(x(1)), 0, R, static_pressure(at(x), R).value, false, false};
  });
}

std::vector<RestCurve> limit_point_curves(const TwoParameterFamily& family, const ParameterRange& first,
                                          const ParameterRange& second) {
  const Unit unit_1{first};
  const Unit unit_2{second};
  const auto at = [&](const VectorXd& x) { return family(unit_1.value(x(1)), unit_2.value(x(2))); };
  const LoadedBalloon corner = family(first.from, second.from);
  const double scale = pressure_scale(corner.parameters, corner.pressure);
  const auto residual = [&](const VectorXd& x) {
    const LoadedBalloon balloon = at(x);
    const StaticPressure p0 = pressure_within(balloon.parameters, std::exp(x(0)));
    return VectorXd(Eigen::Vector2d((p0.value - balloon.pressure) / scale, p0.slope / scale));
  };
  ContinuationProblem problem = problem_of(residual, 2, 1, largest_stretch);
  problem.jacobian = [&](const VectorXd& x) {
    MatrixXd jacobian(2, 3);
    jacobian << difference(problem, x, 0, stretch_step), difference(problem, x, 1, parameter_step),
        difference(problem, x, 2, parameter_step);
    return jacobian;
  };
  std::vector<VectorXd> starts;
  const auto add_turns = [&](const LoadedFamily& section, const ParameterRange& range, const auto& place) {
    for (const RestCurve& curve : equilibrium_curves(section, range)) {
      for (const RestPoint& point : curve.points) {
        if (point.turning && point.stretch > 1) starts.push_back(place(std::log(point.stretch), point.parameter));
      }
    }
  };
  for (const int end : {0, 1}) {  // on the two ends of the second range, then of the first
    add_turns([&](double value) { return family(value, unit_2.value(end)); }, first,
              [&](double x, double value) { return Eigen::Vector3d(x, unit_1.share(value), end); });
    add_turns([&](double value) { return family(unit_1.value(end), value); }, second,
              [&](double x, double value) { return Eigen::Vector3d(x, end, unit_2.share(value)); });
  }
  return follow_all(problem, starts, [&](const VectorXd& x) {
    const LoadedBalloon balloon = at(x);
    return RestPoint{unit_2.value(x(2)), unit_1.value(x(1)), std::exp(x(0)), balloon.pressure, false, false};
  });
}

}  // namespace turgor
