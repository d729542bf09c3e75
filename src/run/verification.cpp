#include "turgor/run/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parts.hpp"
#include "turgor/run/force_history.hpp"

namespace turgor {

namespace {

using Motion = PrescribedMotion<double>;
using Force = double FemForces::*;

/// Velocities are monotone within a phase, and keep their sign.
MotionCourse course_of(const Motion::Interval& in) {
  const double first = std::abs(in.phase.velocity(in.begin));
  const double last = std::abs(in.phase.velocity(in.end));
  if (in.phase.velocity.is_constant()) return MotionCourse::constant;
  return last > first ? MotionCourse::accelerating : MotionCourse::decelerating;
}

std::vector<VerifiedRow> rows_of(const Case& c, const std::vector<FemForces>& fem,
                                 const std::vector<Closure>& closures) {
  const Motion& motion = dictated_motion(c);
  const std::vector<Motion::Interval> intervals = motion.intervals(c.solve.t_end);
  const double rounding = 1e-12 * c.solve.t_end;  // of times in other units
  std::vector<VerifiedRow> rows;
  std::size_t i = 0;
  for (const FemForces& row : fem) {
    while (i + 1 < intervals.size() && row.time > intervals[i].end + rounding) ++i;
    const Motion::State state = motion.within(intervals[i].phase, row.time);
    rows.push_back({state, course_of(intervals[i]), row, forces_at(c, closures, row.time, state).all});
  }
  return rows;
}

using Rows = std::vector<const VerifiedRow*>;

Rows rows_in(const std::vector<VerifiedRow>& all, const MotionPart& part) {
  Rows rows;
  for (const VerifiedRow& row : all) {
    if (row.state.regime == part.regime && (!part.course || row.course == *part.course)) rows.push_back(&row);
  }
  return rows;
}

double rms_of(const Rows& rows, Force force) {
  double sum = 0;
  for (const VerifiedRow* row : rows) sum += row->fem.*force * (row->fem.*force);
  return rows.empty() ? 0 : std::sqrt(sum / static_cast<double>(rows.size()));
}

Deviation error_of(const Rows& rows, std::size_t closure, Force force) {
  std::vector<Difference> differences;
  for (const VerifiedRow* row : rows) differences.push_back({row->fem.time, row->models[closure] - row->fem.*force});
  return deviation_of(differences);
}

/// Nothing where a force is 0.
std::optional<ForceRatio> ratio_of(const Rows& rows, std::size_t closure, Force force) {
  ForceRatio ratio{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const VerifiedRow* row : rows) {
    const double here = row->models[closure] / (row->fem.*force) - 1;
    if (!std::isfinite(here)) return std::nullopt;
    ratio.mean += here / static_cast<double>(rows.size());
    ratio.least = std::min(ratio.least, here);
    ratio.greatest = std::max(ratio.greatest, here);
  }
  return rows.empty() ? std::nullopt : std::optional(ratio);
}

ForceComparison compare(const std::vector<VerifiedRow>& all, std::size_t closures, Force force) {
  ForceComparison comparison;
  constexpr double small = 0.1;
  const double deflation = rms_of(rows_in(all, {Regime::deflating, {}}), force);
  const auto add = [&](const MotionPart& part) {
    const Rows rows = rows_in(all, part);
    if (rows.empty()) return;
    const double rms = rms_of(rows, force);
    const bool is_small = rms < small * deflation;
    PartErrors errors{part, rows.size(), rms, is_small, is_small ? deflation : rms, {}};
    for (std::size_t i = 0; i < closures; ++i) errors.closures.push_back(error_of(rows, i, force));
    comparison.parts.push_back(std::move(errors));
  };
  for (const Regime regime : {Regime::inflating, Regime::rest, Regime::deflating}) {
    add({regime, {}});
    if (regime == Regime::rest) continue;
    for (const MotionCourse course : {MotionCourse::accelerating, MotionCourse::constant, MotionCourse::decelerating})
      add({regime, course});
  }
  const Rows even = rows_in(all, {Regime::deflating, MotionCourse::constant});
  for (std::size_t i = 0; i < closures; ++i) {
    if (const auto ratio = ratio_of(even, i, force)) comparison.even_deflation.push_back(*ratio);
  }
  if (comparison.even_deflation.size() < closures) comparison.even_deflation.clear();
  return comparison;
}

}  // namespace

std::string MotionPart::name() const {
  std::string name = "deflating";
  if (regime != Regime::deflating) name = regime == Regime::rest ? "at rest" : "inflating";
  if (!course) return name;
  if (*course == MotionCourse::constant) return name + ", constant velocity";
  return name + (*course == MotionCourse::accelerating ? ", accelerating" : ", decelerating");
}

Verification verify(const Case& c, FemHistory fem) {
  const std::vector<Closure> closures = compared_closures(c);
  std::vector<VerifiedRow> rows = rows_of(c, fem.rows, closures);
  ForceComparison mode = compare(rows, closures.size(), &FemForces::force_mode);
  ForceComparison whole = compare(rows, closures.size(), &FemForces::force);
  std::vector<Warning> warnings = fem.warnings;
  const RadiusRange<double> radius = range_of(dictated_motion(c), c.solve.t_end);
  const double r0 = c.parameters.radius;
  for (Warning& warning : strained_orifice(c.parameters, {radius.least / r0, radius.greatest / r0})) {
    warnings.push_back(std::move(warning));
  }
  return {std::move(fem), closures, std::move(rows), std::move(mode), std::move(whole), std::move(warnings)};
}

}  // namespace turgor
