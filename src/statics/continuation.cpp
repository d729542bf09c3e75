#include "turgor/statics/continuation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "shape.hpp"

namespace turgor {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Follower {
 public:
  Follower(const ContinuationProblem& problem, const ContinuationOptions& options)
      : problem_(problem), options_(options) {}

  Branch follow(const VectorXd& start, double direction);

 private:
  /// Where the plane lies in which Newton's method looks for a solution: normal.(x - origin) = distance.
  struct Plane {
    const VectorXd& normal;
    const VectorXd& origin;
    double distance;
  };

  [[nodiscard]] bool inside(const VectorXd& x) const {
    constexpr double rounding = 1e-12;
    return (x.array() >= problem_.least.array() - rounding).all() &&
           (x.array() <= problem_.greatest.array() + rounding).all();
  }
  /// The solution in a plane near x.
  [[nodiscard]] std::optional<VectorXd> solve(VectorXd x, const Plane& plane) const;
  /// Unit tangent at a solution, pointing as `along` does; nothing where there is no single one.
  [[nodiscard]] std::optional<VectorXd> tangent(const VectorXd& x, const VectorXd& along) const;
  /// That solution with its tangent.
  [[nodiscard]] std::optional<BranchPoint> corrected(const VectorXd& guess, const Plane& plane,
                                                     const VectorXd& along) const;
  [[nodiscard]] std::optional<BranchPoint> point(const BranchPoint& from, double distance) const;
  /// The turning point of the parameter between two points.
  [[nodiscard]] std::optional<BranchPoint> fold(const BranchPoint& from, const BranchPoint& to) const;
  /// Where the branch crosses the box's boundary less than `distance` ahead.
  [[nodiscard]] std::optional<BranchPoint> exit(const BranchPoint& from, double distance) const;
  /// Keeps a point, with the fold before it.
  void keep(Branch& branch, const BranchPoint& next) const;

  const ContinuationProblem& problem_;
  const ContinuationOptions& options_;
};

std::optional<VectorXd> Follower::solve(VectorXd x, const Plane& plane) const {
  constexpr int most_iterations = 12;
  const Index n = x.size() - 1;
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    if (!inside(x)) return std::nullopt;
    VectorXd defect(n + 1);
    defect << problem_.residual(x), plane.normal.dot(x - plane.origin) - plane.distance;
    MatrixXd matrix(n + 1, n + 1);
    matrix << problem_.jacobian(x), plane.normal.transpose();
    if (!defect.allFinite() || !matrix.allFinite()) return std::nullopt;
    const VectorXd correction = matrix.fullPivLu().solve(defect);
    const double size = correction.norm();
    if (!std::isfinite(size)) return std::nullopt;
    // Rounding of the residual may keep corrections above the tolerance; then they cease to shrink.
    const bool stalled = size < 1e3 * options_.tolerance * (1 + x.norm()) && size > last / 2;
    if (stalled) return x;
    x -= correction;
    if (size < options_.tolerance * (1 + x.norm())) return inside(x) ? std::optional(x) : std::nullopt;
    last = size;
  }
  return std::nullopt;
}

std::optional<VectorXd> Follower::tangent(const VectorXd& x, const VectorXd& along) const {
  const Index n = x.size() - 1;
  const MatrixXd jacobian = problem_.jacobian(x);
  if (!jacobian.allFinite()) return std::nullopt;
  MatrixXd matrix(n + 1, n + 1);
  matrix << jacobian, along.transpose();
  const VectorXd direction = matrix.fullPivLu().solve(VectorXd::Unit(n + 1, n));
  const double length = direction.norm();
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return direction / length;
}

std::optional<BranchPoint> Follower::corrected(const VectorXd& guess, const Plane& plane, const VectorXd& along) const {
  const auto x = solve(guess, plane);
  if (!x) return std::nullopt;
  const auto direction = tangent(*x, along);
  if (!direction) return std::nullopt;
  return BranchPoint{*x, *direction};
}

std::optional<BranchPoint> Follower::point(const BranchPoint& from, double distance) const {
  return corrected(from.x + distance * from.tangent, {from.tangent, from.x, distance}, from.tangent);
}

std::optional<BranchPoint> Follower::fold(const BranchPoint& from, const BranchPoint& to) const {
  const VectorXd way = to.x - from.x;  // not along the tangent, which may lead out of the box
  const auto between = [&](double share) {
    return corrected(from.x + share * way, {from.tangent, from.x, share * from.tangent.dot(way)}, from.tangent);
  };
  const auto rise = [&](double share) {
    const auto at = between(share);
    return at ? at->tangent(at->tangent.size() - 1) : std::numeric_limits<double>::quiet_NaN();
  };
  auto found = between(root(rise, 0, 1));
  if (found) found->fold = true;
  return found;
}

std::optional<BranchPoint> Follower::exit(const BranchPoint& from, double distance) const {
  // The wall that the tangent meets first; the branch meets it next to there.
  const Index size = from.x.size();
  double nearest = std::numeric_limits<double>::infinity();
  Index wall = 0;
  for (Index i = 0; i < size; ++i) {
    const double slope = from.tangent(i);
    if (slope == 0) continue;
    const double way = ((slope > 0 ? problem_.greatest(i) : problem_.least(i)) - from.x(i)) / slope;
    if (way < nearest) {
      nearest = way;
      wall = i;
    }
  }
  if (!(nearest < 2 * distance)) return std::nullopt;
  const VectorXd normal = VectorXd::Unit(size, wall);
  const VectorXd origin = from.x + nearest * from.tangent;
  VectorXd guess = origin;
  guess(wall) = from.tangent(wall) > 0 ? problem_.greatest(wall) : problem_.least(wall);
  const double limit = guess(wall);
  guess = guess.cwiseMax(problem_.least).cwiseMin(problem_.greatest);
  auto x = solve(guess, {normal, guess, 0});
  if (!x || (*x - origin).norm() > distance) return std::nullopt;
  (*x)(wall) = limit;
  const auto direction = tangent(*x, from.tangent);
  if (!direction || direction->dot(from.tangent) < std::cos(2 * options_.turn)) return std::nullopt;
  return BranchPoint{*x, *direction};
}

void Follower::keep(Branch& branch, const BranchPoint& next) const {
  const BranchPoint& last = branch.points.back();
  const Index parameter = next.x.size() - 1;
  if ((last.tangent(parameter) > 0) != (next.tangent(parameter) > 0)) {
    if (auto turning = fold(last, next)) branch.points.push_back(std::move(*turning));
  }
  branch.points.push_back(next);
}

Branch Follower::follow(const VectorXd& start, double direction) {
  Branch branch;
  const Index size = start.size();
  const VectorXd parameter = VectorXd::Unit(size, size - 1);
  const auto first = solve(start, {parameter, start, 0});
  if (!first) return branch;
  const auto first_tangent = tangent(*first, direction * parameter);
  if (!first_tangent) return branch;
  branch.points.push_back({*first, *first_tangent});
  double step = options_.step;
  double travelled = 0;
  while (static_cast<int>(branch.points.size()) < options_.most_points) {
    const BranchPoint from = branch.points.back();
    const auto next = point(from, step);
    const double cosine = next ? next->tangent.dot(from.tangent) : -1;
    if (!next || cosine < std::cos(options_.turn)) {
      if (const auto last = exit(from, step)) {
        keep(branch, *last);
        branch.end = BranchEnd::left_box;
        return branch;
      }
      step /= 2;
      if (step < options_.least_step) return branch;
      continue;
    }
    keep(branch, *next);
    travelled += step;
    const VectorXd way = *first - next->x;
    if (travelled > 4 * step && way.norm() < step && next->tangent.dot(*first_tangent) > 0 &&
        next->tangent.dot(way) >= 0) {
      keep(branch, {*first, *first_tangent});
      branch.end = BranchEnd::closed;
      return branch;
    }
    if (cosine > std::cos(options_.turn / 2)) step = std::min(1.5 * step, options_.greatest_step);
  }
  branch.end = BranchEnd::too_long;
  return branch;
}

}  // namespace

Branch follow_branch(const ContinuationProblem& problem, const Eigen::VectorXd& start, double direction,
                     const ContinuationOptions& options) {
  return Follower(problem, options).follow(start, direction);
}

}  // namespace turgor
