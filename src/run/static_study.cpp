#include "turgor/run/static_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "turgor/case/case_template.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

namespace {

double last_pressure(const Case& c) {
  const std::vector<double> knots = c.pressure.knots();
  return c.pressure(knots.empty() ? c.solve.t_end : std::max(knots.back(), c.solve.t_end));
}

/// The case with other values at some keys. Its start does not matter, and shall not be in the way.
class RestingCase {
 public:
  RestingCase(const Case& c, const std::vector<KeyRange>& keys) : keys_(keys), template_(c, names(keys)) {}

  LoadedBalloon operator()(std::span<const double> values) {
    std::vector<Node> nodes{{1.0, "", 0}, {Node::Quantity{0.0, "1/s"}, "", 0}};
    for (std::size_t i = 0; i < keys_.size(); ++i) nodes.push_back(node_of(keys_[i], values[i]));
    const Case c = template_.with(nodes);
    return {c.parameters, last_pressure(c)};
  }

 private:
  static std::vector<std::string> names(const std::vector<KeyRange>& keys) {
    std::vector<std::string> all{"initial.stretch", "initial.stretch_rate"};
    for (const KeyRange& key : keys) all.push_back(key.key);
    return all;
  }

  std::vector<KeyRange> keys_;
  CaseTemplate template_;
};

KeyStudy study_key(const Case& c, const KeyRange& key) {
  RestingCase balloon(c, {key});
  const LoadedFamily loaded = [&](double value) { return balloon(std::array{value}); };
  const BalloonFamily unloaded = [&](double value) { return loaded(value).parameters; };
  const ParameterRange range{key.from, key.to};
  constexpr int enough_for_a_picture = 121;
  return {key, equilibrium_curves(loaded, range), limit_point_curves(unloaded, range),
          bistability_map(unloaded, range, enough_for_a_picture)};
}

PlaneStudy study_plane(const Case& c, const KeyRange& first, const KeyRange& second) {
  RestingCase balloon(c, {first, second});
  const TwoParameterFamily family = [&](double a, double b) { return balloon(std::array{a, b}); };
  return {first, second, limit_point_curves(family, {first.from, first.to}, {second.from, second.to})};
}

}  // namespace

BistabilityMap bistability_map(const BalloonFamily& family, const ParameterRange& range, int points) {
  BistabilityMap map{{}, find_cusps(family, range.from, range.to)};
  for (int k = 0; k < points; ++k) {
    const double parameter =
        k + 1 == points ? range.to : range.from + (range.to - range.from) * k / static_cast<double>(points - 1);
    for (const BistableWindow& window : bistable_windows(family(parameter))) map.rows.push_back({parameter, window});
  }
  return map;
}

std::optional<MooneyRivlinMap> mooney_rivlin_map(const Case& c) {
  const auto* solid = std::get_if<MooneyRivlin<double>>(&c.parameters.material);
  if (solid == nullptr || !(solid->s1 > 0) || !(solid->s2 > 0)) return std::nullopt;
  const double modulus = c.parameters.radius / (4 * c.parameters.thickness);  // S = 4 d0 s/(r0 p_typ) = 1 at 1 Pa
  const BalloonFamily family = [&](double ratio) {
    Parameters<double> p = c.parameters;
    p.material = MooneyRivlin<double>{ratio * modulus, modulus};
    return p;
  };
  const double ratio = solid->s1 / solid->s2;
  constexpr int points = 201;
  return MooneyRivlinMap{bistability_map(family, {2, std::max(15.0, 1.5 * ratio)}, points), ratio, solid->s2 / modulus};
}

StaticStudy study_statics(const Case& c, const StaticQuestions& questions) {
  require_free_motion(c);
  const Parameters<double>& p = c.parameters;
  StaticStudy study{};
  study.pressure = last_pressure(c);
  study.limit_points = limit_points(p);
  study.equilibria = equilibria(p, study.pressure);
  study.wells = wells(p, study.pressure);
  study.windows = bistable_windows(p);
  study.jumps = jumps(p, prescribed_pressure);
  study.critical_compliance = critical_compliance(p);
  if (questions.compliance) {
    study.supply = Loading{*questions.compliance};
    study.filling_jumps = jumps(p, *study.supply);
  }
  if (!questions.over.empty()) study.over = study_key(c, questions.over[0]);
  if (questions.over.size() > 1) study.plane = study_plane(c, questions.over[0], questions.over[1]);
  return study;
}

std::vector<StaticRow> static_curve(const Case& c, const StaticStudy& study) {
  double least = 1;
  double greatest = 2;
  const auto include = [&](double R) {
    least = std::min(least, 0.97 * R);
    greatest = std::max(greatest, 1.15 * R);
  };
  for (const LimitPoint& point : study.limit_points) include(point.stretch);
  for (const Equilibrium& state : study.equilibria) include(state.stretch);
  for (const Jump& jump : study.jumps) include(jump.to.value_or(1.5 * jump.stretch));
  for (const StableBranch& branch : stable_branches(c.parameters)) {
    if (branch.greatest_stretch < greatest && branch.greatest_stretch > 1 &&
        branch.greatest_stretch * 1.01 > stretch_limit(c.parameters.material)) {
      greatest = branch.greatest_stretch;
    }
  }
  const StretchLimits<double> limits = closure_limits(c.parameters);
  least = std::max(least, limits.least);
  greatest = std::min({greatest, limits.greatest, largest_stretch});
  constexpr int points = 600;
  std::vector<StaticRow> rows;
  const auto add = [&](double R, bool limit_point) {
    const StaticPressure p0 = static_pressure(c.parameters, R);
    if (std::isfinite(p0.value)) rows.push_back({R, p0.value, !limit_point && p0.slope > 0, limit_point});
  };
  for (int k = 0; k <= points; ++k) add(least + (greatest - least) * k / points, false);
  for (const LimitPoint& point : study.limit_points) add(point.stretch, true);
  std::ranges::sort(rows, {}, &StaticRow::stretch);
  return rows;
}

}  // namespace turgor
