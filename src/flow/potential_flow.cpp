#include "turgor/flow/potential_flow.hpp"

#include <algorithm>
#include <cmath>

#include "ring.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

/// A point of the flow, with its angle measured from the rim: offset = angle - cap angle, exact near 0.
struct PotentialFlow::Target : RingTarget {
  double offset;
};

/// What the sources add up to at one target.
class PotentialFlow::Sum {
 public:
  Sum(const PotentialFlow& flow, const Target& target) : flow_(flow), target_(target) {}

  /// @param angle       of the ring, from the axis
  /// @param difference  angle of the target less that of the ring
  /// @param weight      width of the ring
  void add(double angle, double difference, double weight) {
    const double sine = std::sin(angle);
    const CapSource source = flow_.source(angle);
    const RingField ring = flow_.quadrature_->average(target_, difference, sine);
    const double strength = weight * sine * source.strength;
    field_.potential += strength * ring.potential;
    field_.potential_change += weight * sine * source.change * ring.potential;
    field_.radial += strength * ring.radial;
    field_.tangential -= strength * ring.tangential;  // theta = pi - angle
  }

  /// As eps grows the rim moves over the sphere, and the jump of the velocity there moves with it.
  void add_moving_rim() {
    const double jump = flow_.source(flow_.cap_angle_).strength;
    field_.potential_change += jump * flow_.quadrature_->potential(target_, target_.offset, flow_.kappa_);
  }

  [[nodiscard]] const Target& target() const { return target_; }
  [[nodiscard]] const FlowField& field() const { return field_; }

 private:
  const PotentialFlow& flow_;
  const Target& target_;
  FlowField field_{};
};

PotentialFlow::PotentialFlow(double kappa, OutflowProfile profile, double tolerance)
    : kappa_(kappa), profile_(std::move(profile)), tolerance_(tolerance) {
  if (!(kappa > 0 && kappa < 1)) {
    throw InvalidInput("kappa", shortest(kappa), "the orifice must be smaller than the balloon",
                       "kappa = r_ch/r lies between 0 and 1");
  }
  if (!(tolerance >= 1e-15 && tolerance <= 1e-4)) {
    throw InvalidInput("tolerance", shortest(tolerance), "is out of range", "allowed are 1e-15 to 1e-4");
  }
  eps_ = cap_depth(kappa);
  cap_angle_ = std::asin(kappa);
  quadrature_ = std::make_shared<const RingQuadrature>(tolerance);
  at_orifice_ = field({{eps_, 1 - eps_, 0, 0, 1}, -cap_angle_});
}

PotentialFlow::CapSource PotentialFlow::source(double angle) const {
  const double x = -std::cos(angle);
  const double height = 1 - eps_;
  const double upsilon = std::sin(angle) / kappa_;
  const auto f = profile_.at(upsilon);
  const double speed = channel_speed(eps_);
  const double speed_slope = -(2 - 4 * eps_ + eps_ * eps_) / (eps_ * eps_ * height * height);
  const double upsilon_slope = -upsilon * height / (kappa_ * kappa_);
  const double centre = 1 / height;  // speed of the balloon's centre
  return {(f.value * speed - centre) * x - 1,
          (f.value * speed_slope + f.slope * upsilon_slope * speed - centre * centre) * x};
}

/// The rings between two angles, counted from the rim. One end is the ring nearest to the target, or none is near;
/// rings crowd there as sinh w does.
void PotentialFlow::add_piece(Sum& sum, double from, double to) const {
  const Target& target = sum.target();
  const bool near_from = std::abs(target.offset + from) <= std::abs(target.offset + to);
  const double end = near_from ? from : to;
  const double sign = near_from ? 1 : -1;
  const double nearest = target.offset + end;
  const double half = std::sin(nearest / 2);
  const double distance = std::sqrt(target.depth * target.depth + 4 * target.radius * half * half);
  constexpr double smallest = 1e-20;  // the rounding of a point in the orifice's plane beside the rim
  const double unit = std::max(distance, smallest);
  const double length = std::asinh((to - from) / unit);
  const GaussLegendre& rule = quadrature_->stretched_rule(length);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double stretched = std::sinh(length * rule.node[i]);
    const double way = sign * unit * stretched;
    const double weight = rule.weight[i] * length * unit * std::sqrt(1 + stretched * stretched);
    sum.add(cap_angle_ - end - way, nearest + way, weight);
  }
}

FlowField PotentialFlow::field(const Target& target) const {
  std::vector<double> ends{0, cap_angle_};
  const std::vector<double>& knots = profile_.knots();
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) ends.push_back(cap_angle_ - std::asin(knots[i] * kappa_));
  if (target.offset < 0 && target.offset > -cap_angle_) ends.push_back(-target.offset);
  std::ranges::sort(ends);
  Sum sum(*this, target);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i + 1] > ends[i]) add_piece(sum, ends[i], ends[i + 1]);
  }
  sum.add_moving_rim();
  return sum.field();
}

FlowField PotentialFlow::at(const FlowPoint& point) const {
  const std::string text = "radius = " + shortest(point.radius) + " r, theta = " + shortest(point.theta);
  if (!(point.radius >= 0 && point.radius <= 1)) {
    throw InvalidInput("point", text, "lies outside the balloon", "its radius is 0 to 1, in units of the balloon's");
  }
  if (!(point.theta >= 0 && point.theta <= pi)) {
    throw InvalidInput("point", text, "has no such angle", "theta is 0 to pi, from the pole opposite the orifice");
  }
  const double angle = pi - point.theta;
  constexpr double rounding = 1e-14;
  if (point.radius * std::cos(angle) > (1 - eps_) * (1 + rounding)) {
    throw InvalidInput("point", text, "lies beyond the orifice, in the channel",
                       "the potential flow (2.6) holds up to the plane of the orifice");
  }
  if (std::abs(angle - cap_angle_) < rounding && 1 - point.radius < rounding) {
    throw InvalidInput("point", text, "lies on the rim of the orifice, where the velocity is infinite");
  }
  return field({{1 - point.radius, point.radius, angle, std::sin(angle), std::cos(angle)}, angle - cap_angle_});
}

FlowField PotentialFlow::on_wall(double offset) const {
  if (!(offset > 0 && offset <= wall_angle())) {
    throw InvalidInput("offset", shortest(offset), "is not on the wall",
                       "it is counted from the rim: above 0, up to " + shortest(wall_angle()));
  }
  const double angle = cap_angle_ + offset;
  return field({{0, 1, angle, std::sin(angle), std::cos(angle)}, offset});
}

}  // namespace turgor
