#include <algorithm>
#include <cmath>
#include <mutex>

#include "parts.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/profile.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

void declare_dynamics(Schema& schema) {
  using enum ValueKind;
  schema.describe("initial", "state at t = 0");
  schema.add({.path = "initial.stretch",
              .kind = number,
              .range = {0, largest_stretch, true},
              .choices = {"equilibrium"},
              .fallback = "1.0",
              .meaning = "R = r/r0, or \"equilibrium\": the lowest stable one at the pressure at t = 0"});
  schema.add({.path = "initial.stretch_rate", .unit = "1/s", .fallback = "0 1/s", .meaning = "dR/dt"});

  schema.describe("model", "which equation of motion");
  schema.add({.path = "model.name",
              .kind = text,
              .choices = {"full", "orifice", "long-channel", "auto"},
              .fallback = "auto",
              .meaning = "(2.22), (2.23), (2.25), or the simplest whose dropped terms are all below auto_tolerance"});
  schema.add({.path = "model.closure",
              .kind = text,
              .choices = {"theoretical", "corrected", "potential", "profile", "calibrated"},
              .fallback = "corrected",
              .meaning =
                  "liquid in the balloon during deflation: (2.12), (2.15), (2.8) itself, (2.8) for a profile, or (2.8) "
                  "fitted to finite elements"});
  schema.add({.path = "model.profile",
              .kind = text,
              .meaning = "CSV file of an outflow profile (2.13), beside the case; with closure = \"profile\""});
  schema.add({.path = "model.profile_points", .kind = table, .meaning = "instead of profile: its points"});
  schema.add({.path = "model.profile_points.upsilon",
              .kind = number_list,
              .range = {0, 1},
              .required = true,
              .meaning = "distances from the axis over r_ch, increasing from 0 to 1"});
  schema.add({.path = "model.profile_points.f",
              .kind = number_list,
              .required = true,
              .meaning = "axial velocities there, in any unit, positive out of the balloon"});
  schema.add({.path = "model.auto_tolerance",
              .kind = number,
              .range = {0, 1, true},
              .fallback = "0.05",
              .meaning = "for name = \"auto\": largest relative size of a dropped term"});

  schema.describe("scales", "for the dimensionless form of results (2.21); they change no physical result");
  schema.add(
      {.path = "scales.pressure",
       .unit = "Pa",
       .range = positive,
       .meaning =
           "p_typ; when not given, the greatest size of the gauge pressure up to t_end (d0 W''(1)/r0 when that is 0)"});
  schema.add({.path = "scales.time",
              .unit = "s",
              .range = positive,
              .meaning = "t_typ; the inverse natural frequency of deflation about R = 1 when not given"});
}

namespace {

/// The points of the case's profile.
/// @throws InvalidInput when its file is none
std::optional<ProfileTable> given_profile(Reader& reader, const Case& c) {
  if (const Node* given = reader.node("model.profile")) {
    if (const auto* file = given->as<std::string>()) return read_profile_table(c.file.parent_path() / *file);
    reader.complain("model.profile", "is " + std::string(given->type_name()) + ", not the name of a CSV file",
                    "write profile = \"f.csv\", or give profile_points");
    return std::nullopt;
  }
  if (reader.node("model.profile_points")->as<Node::Table>() == nullptr) return std::nullopt;  // said by check_unknown
  auto upsilon = reader.list("model.profile_points.upsilon");
  auto velocity = reader.list("model.profile_points.f");
  if (!upsilon || !velocity) return std::nullopt;
  return ProfileTable{std::move(*upsilon), std::move(*velocity)};
}

/// The table of a profile. That of the last one is remembered: the members of a sweep share it, and with it what it has
/// computed.
/// @throws InvalidInput when the points make no profile
std::shared_ptr<const ForceTable> force_table_of(const ProfileTable& points) {
  static std::mutex mutex;
  static ProfileTable last;
  static std::shared_ptr<const ForceTable> table;
  const std::scoped_lock lock(mutex);
  if (table == nullptr || last != points) {
    table = std::make_shared<const ForceTable>(OutflowProfile::table(points.upsilon, points.velocity));
    last = points;
  }
  return table;
}

void read_outflow(Reader& reader, Case& c) {
  const Node* file = reader.node("model.profile");
  const Node* points = reader.node("model.profile_points");
  const bool wanted = c.parameters.closure == Closure::profile;
  if (!wanted) c.parameters.outflow.reset();
  if (wanted && (file == nullptr) == (points == nullptr)) {
    reader.complain("model.closure", file == nullptr ? "there is no profile" : "there are two profiles",
                    "give one of model.profile = \"f.csv\" and model.profile_points");
    return;
  }
  if (file == nullptr && points == nullptr) return;
  const char* key = file != nullptr ? "model.profile" : "model.profile_points";
  if (!wanted) {
    if (reader.node("sweep.axes.\"model.closure\"") != nullptr) return;  // other members may want it
    reader.complain(key, "goes with closure = \"profile\" only",
                    "the closure is \"" + std::string(name_of(c.parameters.closure)) + "\"");
    return;
  }
  try {
    const auto table = given_profile(reader, c);
    if (!table) return;
    c.parameters.outflow = force_table_of(*table);
    reader.resolve("model.profile_points", [&] {
      return "{ upsilon = " + toml_list(table->upsilon, "1") + ", f = " + toml_list(table->velocity, "1") + " }";
    });
  } catch (const InvalidInput& error) {
    for (const Issue& issue : error.issues()) {
      reader.complain(key, issue.value.empty() ? issue.problem : issue.value + ": " + issue.problem, issue.advice);
    }
  }
}

void read_closure(Reader& reader, Case& c) {
  const auto name = reader.text("model.closure");
  for (const Closure closure : all_closures) {
    if (name == name_of(closure)) c.parameters.closure = closure;
  }
  if (name) read_outflow(reader, c);
  if (!reader.issues().empty()) return;  // a table needs a valid balloon
  try {
    static_cast<void>(force_table(c.parameters));
  } catch (const InvalidInput& error) {
    reader.complain(error);
  }
}

void read_initial(Reader& reader, Case& c) {
  if (reader.is_word("initial.stretch", "equilibrium")) {
    if (!reader.issues().empty()) return;  // an equilibrium needs a valid balloon and pressure
    const double pressure = c.pressure(0.0);
    const auto states = equilibria(c.parameters, pressure);
    const auto lowest = std::ranges::find(states, true, &Equilibrium::stable);
    if (lowest == states.end()) {
      reader.complain("initial.stretch",
                      "the balloon has no stable equilibrium at p(0) = " + shortest(pressure) + " Pa",
                      "`turgor info` lists limit points and equilibria");
      return;
    }
    c.stretch = lowest->stretch;
    reader.resolve("initial.stretch", [&] { return toml_quantity(c.stretch, "1"); });
  } else {
    c.stretch = reader.number("initial.stretch").value_or(1);
  }
  c.stretch_rate = reader.number("initial.stretch_rate").value_or(0);
  if (!reader.issues().empty()) return;
  const Parameters<double>& p = c.parameters;
  if (!std::isfinite(strain_energy(p.material, c.stretch).first)) {
    reader.complain("initial.stretch", "beyond the stretch at which the material locks",
                    "this one locks at " + rounded(stretch_limit(p.material), 6) + ", and in compression likewise");
  }
  if (c.max_stretch > 0 && c.stretch >= c.max_stretch) {
    reader.complain("initial.stretch", "the wall has burst already",
                    "material.max_stretch is " + shortest(c.max_stretch));
  }
  if (p.orifice_radius >= c.stretch * p.radius) {
    reader.complain("initial.stretch", "compresses the balloon to less than its orifice",
                    "must be more than orifice_radius/radius = " + shortest(p.orifice_radius / p.radius));
    return;
  }
  try {
    require_closure(p, c.stretch);
  } catch (const InvalidInput& error) {
    reader.complain(error);
  }
}

void read_model(Reader& reader, Case& c) {
  const auto name = reader.text("model.name");
  c.auto_tolerance = reader.number("model.auto_tolerance").value_or(0.05);
  c.model.reset();
  for (const Model model : {Model::full, Model::orifice, Model::long_channel}) {
    if (name == name_of(model)) c.model = model;
  }
  const bool channel = c.parameters.channel_length > 0;
  if (c.model == Model::orifice && channel) {
    reader.complain(
        "model.name", "there is a channel (inlet.channel_length = " + shortest(c.parameters.channel_length) + " m)",
        "the orifice model has none: use \"full\", \"long-channel\" or \"auto\", or set channel_length to \"0 m\"");
  }
  if (c.model == Model::long_channel && !channel) {
    reader.complain("model.name", "there is no channel (inlet.channel_length is 0)",
                    "use \"orifice\", \"full\" or \"auto\", or give inlet.channel_length");
  }
}

}  // namespace

void read_dynamics(Reader& reader, Case& c) {
  read_closure(reader, c);
  if (c.motion) {
    check_motion(reader, c);
  } else {
    read_initial(reader, c);
  }
  read_model(reader, c);
  const auto pressure = reader.number("scales.pressure");
  const auto time = reader.number("scales.time");
  if (!reader.issues().empty()) return;
  const Scales<double> scales = natural_scales(c.parameters, c.pressure, c.solve.t_end);
  c.scales = {scales.length, pressure.value_or(scales.pressure), time.value_or(scales.time)};
  reader.resolve("scales.pressure", [&] { return toml_quantity(c.scales.pressure, "Pa"); });
  reader.resolve("scales.time", [&] { return toml_quantity(c.scales.time, "s"); });
}

}  // namespace turgor
