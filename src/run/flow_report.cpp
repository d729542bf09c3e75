#include "turgor/run/flow_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

/// Half of them evenly spaced, half geometrically down to 1e-6 r_ch; from the pole to the rim.
std::vector<double> wall_offsets(const PotentialFlow& flow) {
  constexpr int half = 250;
  constexpr double nearest = 1e-6;
  const double whole = flow.wall_angle();
  std::vector<double> offsets;
  for (int k = 1; k <= half; ++k) offsets.push_back(whole * k / half);
  for (int k = 0; k < half; ++k) {
    const double share = static_cast<double>(k) / half;
    offsets.push_back(nearest * flow.kappa() * std::pow(whole / (nearest * flow.kappa()), share));
  }
  std::ranges::sort(offsets, std::greater<>());
  const auto rest = std::ranges::unique(offsets);
  offsets.erase(rest.begin(), rest.end());
  return offsets;
}

}  // namespace

std::string flow_json(const Case& c, const FlowSnapshot& snapshot, const MeridionalFlow& field) {
  const FlowState<double>& s = snapshot.state();
  const FlowInstant& instant = snapshot.instant();
  const FlowForces forces = snapshot.forces();
  const OutflowProfile& profile = snapshot.flow().profile();
  const double area = std::numbers::pi * s.orifice_radius * s.orifice_radius;
  const auto equation = snapshot.equation();
  Json state{{"R", instant.stretch},
             {"dRdt_1_per_s", instant.rate},
             {"d2Rdt2_1_per_s2", *instant.acceleration},
             {"r_m", s.radius},
             {"p_gauge_Pa", s.inlet_pressure},
             {"t_s", instant.time},
             {"acceleration_from", equation ? Json(name_of(*equation)) : Json("given")},
             {"closure", equation ? Json(name_of(c.parameters.closure)) : Json(nullptr)}};
  const Json document{
      {"title", c.title},
      {"versions", {{"turgor", version}, {"compiler", compiler}}},
      {"state", state},
      {"kappa", snapshot.flow().kappa()},
      {"epsilon", snapshot.flow().eps()},
      {"orifice",
       {{"pressure_Pa", snapshot.at_orifice()},
        {"velocity_m_per_s", snapshot.channel_velocity()},
        {"flow_rate_m3_per_s", area * snapshot.channel_velocity()},
        {"reynolds", snapshot.reynolds()}}},
      {"force_N", {{"exact", forces.exact}, {"theoretical", forces.theoretical}, {"corrected", forces.corrected}}},
      {"profile", {{"uniform", profile.is_uniform()}, {"momentum_factor", profile.momentum_factor()}}},
      {"mesh", {{"cells", field.mesh().cells()}, {"nodes", field.nodes().size()}}}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<WallPoint> wall_points(const FlowSnapshot& snapshot) {
  const PotentialFlow& flow = snapshot.flow();
  const FlowState<double>& s = snapshot.state();
  std::vector<WallPoint> points;
  for (const double offset : wall_offsets(flow)) {
    const double angle = flow.cap_angle() + offset;  // from the axis through the orifice
    const FlowPoint point{1, std::numbers::pi - angle};
    const FlowField field = flow.on_wall(offset);
    const double height = 2 * std::sin(flow.cap_angle() + offset / 2) * std::sin(offset / 2);  // cos cap - cos angle
    points.push_back({point.theta, s.radius * offset, s.radius * std::sin(angle), s.radius * height,
                      snapshot.pressure(point, field), s.radial_rate * field.tangential});
  }
  return points;
}

std::string wall_csv(const FlowSnapshot& snapshot) {
  std::string out = "theta [rad],s [m],r [m],z [m],p_gauge [Pa],velocity [m/s]\n";
  for (const WallPoint& p : wall_points(snapshot)) {
    for (const double value : {p.theta, p.way, p.distance, p.height, p.pressure, p.velocity}) {
      out += shortest(value + 0.0) + ",";
    }
    out.back() = '\n';
  }
  return out;
}

std::string flow_vtu(const FlowSnapshot& snapshot, const MeridionalFlow& field) {
  const FlowState<double>& s = snapshot.state();
  const double rate = s.radial_rate;
  VtuGrid grid;
  PointData pressure{"pressure", 1, {}};
  PointData velocity{"velocity", 3, {}};
  PointData relative{"velocity_relative", 3, {}};
  PointData potential{"potential", 1, {}};
  PointData stream{"stream_function", 1, {}};
  for (const MeridionalFlow::Node& node : field.nodes()) {
    const double height = node.polar.radius * std::cos(node.polar.theta);
    grid.points.insert(grid.points.end(), {s.radius * node.point.distance, s.radius * node.point.height, 0});
    pressure.values.push_back(snapshot.pressure(node.polar, node.field));
    const double across = rate * node.across + 0.0;
    velocity.values.insert(velocity.values.end(), {across, rate * (node.along + field.centre_speed()), 0});
    relative.values.insert(relative.values.end(), {across, rate * node.along, 0});
    potential.values.push_back(s.radius * rate * (node.field.potential + field.centre_speed() * height));
    stream.values.push_back(s.radius * s.radius * rate * node.stream_function + 0.0);
  }
  const auto size = static_cast<std::int32_t>(field.mesh().size());
  for (std::int32_t i = 0; i + 1 < size; ++i) {
    for (std::int32_t j = 0; j + 1 < size; ++j) {
      const std::int32_t corner = i * size + j;
      grid.quadrilaterals.push_back({corner, corner + size, corner + size + 1, corner + 1});
    }
  }
  grid.data = {std::move(pressure), std::move(velocity), std::move(relative), std::move(potential), std::move(stream)};
  return vtu_text(grid);
}

std::string flow_summary(const Case& c, const FlowSnapshot& snapshot) {
  const FlowState<double>& s = snapshot.state();
  const FlowInstant& instant = snapshot.instant();
  const FlowForces forces = snapshot.forces();
  std::string out = c.title + "\n";
  const auto line = [&](const std::string& name, const std::string& text) {
    out += "  " + name + std::string(name.size() < 18 ? 18 - name.size() : 1, ' ') + text + "\n";
  };
  const auto with_unit = [](double value, const char* unit) { return rounded(value, 7) + " " + unit; };
  line("stretch", rounded(instant.stretch, 9) + ", r = " + with_unit(s.radius, "m"));
  line("rate", with_unit(instant.rate, "1/s"));
  const auto equation = snapshot.equation();
  line("acceleration", with_unit(*instant.acceleration, "1/s^2") +
                           (equation ? " by " + std::string(equation_of(*equation)) + ", " +
                                           std::string(name_of(c.parameters.closure)) + " closure"
                                     : ""));
  line("inlet pressure", with_unit(s.inlet_pressure, "Pa"));
  line("kappa = r_ch/r", rounded(snapshot.flow().kappa(), 7) + ", eps = " + rounded(snapshot.flow().eps(), 7));
  line("outflow",
       with_unit(-snapshot.channel_velocity(), "m/s") + ", Reynolds number " + rounded(snapshot.reynolds(), 4) +
           (snapshot.flow().profile().is_uniform()
                ? ", uniform"
                : ", profile with momentum factor " + rounded(snapshot.flow().profile().momentum_factor(), 5)));
  line("orifice pressure", with_unit(snapshot.at_orifice(), "Pa") + "  (2.3)");
  line("force", with_unit(forces.exact, "N") + "  (2.8)");
  line("", with_unit(forces.theoretical, "N") + " by (2.12), " + with_unit(forces.corrected, "N") + " by (2.15)");
  return out;
}

}  // namespace turgor
