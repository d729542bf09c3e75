#pragma once
// Branches of solutions of nonlinear equations by pseudo-arclength continuation: H. B. Keller, in: Applications of
// Bifurcation Theory, ed. P. H. Rabinowitz (Academic Press 1977), 359.

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace turgor {

/// n equations F(x) = 0 in n + 1 unknowns, the last of which is called the parameter. Scale them such that a branch
/// looks about equally long in all of them.
struct ContinuationProblem {
  /// F(x), n numbers; a number that is not finite means that x is out of reach.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residual;
  /// dF/dx, n x (n+1). Newton's method forgives errors; folds are located where its first n columns become singular, so
  /// those decide on their accuracy.
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian;
  Eigen::VectorXd least;     ///< the branch is followed up to where it leaves this box; residual and jacobian are never
  Eigen::VectorXd greatest;  ///< evaluated outside of it, but for 1e-12
};

struct ContinuationOptions {
  double step = 0.01;           ///< first step of arclength
  double greatest_step = 0.02;  ///< largest step of arclength
  double least_step = 1e-9;     ///< the branch ends as `lost` when steps become shorter
  double turn = 0.1;            ///< largest angle between tangents at the ends of a step [rad]
  double tolerance = 1e-13;     ///< Newton's method ends when its corrections are smaller
  int most_points = 20'000;
};

struct BranchPoint {
  Eigen::VectorXd x;
  Eigen::VectorXd tangent;  ///< unit length, along the branch; its last entry is 0 at a fold
  bool fold = false;        ///< a turning point of the parameter, located to rounding
};

/// Why a branch ends.
enum class BranchEnd {
  left_box,  ///< the last point lies on the box's boundary
  closed,    ///< back at the start
  lost,      ///< no solution was found any more, by steps down to least_step
  too_long,  ///< more than most_points
};

struct Branch {
  std::vector<BranchPoint> points;  ///< in order, folds among them
  BranchEnd end = BranchEnd::lost;
};

/// Follows the branch through a solution. Two folds within one step are missed.
/// @param start      near a solution, in the box; corrected with its parameter kept
/// @param direction  +1 or -1: the parameter's first direction
/// @return no points when there is no solution near `start`
[[nodiscard]] Branch follow_branch(const ContinuationProblem& problem, const Eigen::VectorXd& start, double direction,
                                   const ContinuationOptions& options = {});

}  // namespace turgor
