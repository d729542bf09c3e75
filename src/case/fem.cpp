#include <algorithm>

#include "parts.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

std::string_view name_of(FemScheme scheme) { return scheme == FemScheme::bdf1 ? "bdf1" : "bdf2"; }

namespace {

void declare_steps(Schema& schema) {
  using enum ValueKind;
  schema.add({.path = "fem.scheme",
              .kind = text,
              .choices = {"bdf2", "bdf1"},
              .fallback = "bdf2",
              .meaning = "backward differences of second or first order in time"});
  schema.add({.path = "fem.cfl",
              .kind = number,
              .range = positive,
              .meaning =
                  "time step times the velocity in the orifice, or of its jet along the axis, over the orifice's "
                  "radius; 0.5 when neither this nor time_step is given"});
  schema.add({.path = "fem.time_step", .unit = "s", .range = positive, .meaning = "instead of cfl: a fixed time step"});
  schema.add({.path = "fem.error_tolerance",
              .kind = number,
              .range = {0, 1, true},
              .meaning = "with cfl: greatest local error of a step of the velocity, root mean square, over the "
                         "greatest velocity in the orifice; no such control "
                         "when not given"});
  schema.add({.path = "fem.tolerance",
              .kind = number,
              .range = {1e-14, 1e-2},
              .fallback = "1e-3",
              .meaning = "nonlinear solve of a step: error of the velocity that it leaves by the rate of "
                         "its changes, relative"});
  schema.add({.path = "fem.max_iterations",
              .kind = integer,
              .range = {1, 1000},
              .fallback = "10",
              .meaning = "nonlinear iterations after which a step has failed"});
  schema.add({.path = "fem.max_steps",
              .kind = integer,
              .range = {1, 1e8},
              .fallback = "1000000",
              .meaning = "give up after this many steps"});
}

void declare_mesh(Schema& schema) {
  schema.add({.path = "fem.h_rim",
              .unit = "m",
              .range = positive,
              .meaning = "cell size at the rim of the orifice; r_ch/60 when not given, at most h_orifice"});
  schema.add({.path = "fem.h_orifice",
              .unit = "m",
              .range = positive,
              .meaning = "cell size across the orifice; r_ch/15 when not given, at most h_wall and r_ch/3"});
  schema.add({.path = "fem.h_wall",
              .unit = "m",
              .range = positive,
              .meaning = "cell size along the balloon's wall; r0/37.5 when not given"});
}

void declare_files(Schema& schema) {
  using enum ValueKind;
  schema.add({.path = "fem.checkpoint_every",
              .unit = "s",
              .range = not_negative,
              .fallback = "60 s",
              .meaning = "time between checkpoints, by the clock on the wall; 0: after every step"});
  schema.add({.path = "fem.fields",
              .kind = integer,
              .range = {0, 1e5},
              .meaning = "fields for ParaView at so many uniform times, both ends included; 21 when neither this nor "
                         "field_times is given, 0: none, 1: at the end"});
  schema.add({.path = "fem.field_times",
              .kind = quantity_list,
              .unit = "s",
              .range = not_negative,
              .meaning = "instead of fields: fields at exactly these times"});
}

}  // namespace

void declare_fem(Schema& schema) {
  schema.describe("fem", "the finite element flow, for `turgor fem`; other commands check it and leave it at that");
  declare_steps(schema);
  declare_mesh(schema);
  declare_files(schema);
}

namespace {

void read_step_size(Reader& reader, FemSettings& s) {
  const bool cfl = reader.node("fem.cfl") != nullptr;
  const bool fixed = reader.node("fem.time_step") != nullptr;
  s.error_tolerance = reader.number("fem.error_tolerance").value_or(0);
  if (cfl && fixed) {
    reader.complain("fem.time_step", "given together with fem.cfl", "give one of them");
  } else if (fixed) {
    s.time_step = reader.number("fem.time_step").value_or(0);
    if (reader.node("fem.error_tolerance") != nullptr) {
      reader.complain("fem.error_tolerance", "given together with the fixed fem.time_step",
                      "leave it out, or give fem.cfl in place of the step");
    }
  } else if (cfl) {
    s.cfl = reader.number("fem.cfl").value_or(0);
  } else {
    s.cfl = 0.5;
    reader.resolve("fem.cfl", [] { return std::string("0.5"); });
  }
}

/// A cell size that has a default.
double read_size(Reader& reader, const std::string& path, double fallback) {
  if (reader.node(path) != nullptr) return reader.number(path).value_or(fallback);
  reader.resolve(path, [&] { return toml_quantity(fallback, "m"); });
  return fallback;
}

void read_mesh(Reader& reader, const Parameters<double>& p, FemSettings& s) {
  constexpr double per_rim = 60;  // as fine as the pressure's singularity at the rim wants it for its force
  constexpr double per_orifice = 15;
  constexpr double per_balloon = 37.5;
  s.h_wall = read_size(reader, "fem.h_wall", p.radius / per_balloon);
  s.h_orifice = read_size(reader, "fem.h_orifice", std::min(p.orifice_radius / per_orifice, s.h_wall));
  s.h_rim = read_size(reader, "fem.h_rim", std::min(p.orifice_radius / per_rim, s.h_orifice));
  const auto at_most = [&](const char* path, double size, double limit, const std::string& what) {
    if (size > limit)
      reader.complain(path, "out of range", "allowed is up to " + what + " = " + shortest(limit) + " m");
  };
  at_most("fem.h_wall", s.h_wall, p.radius / 2, "half of balloon.radius");
  at_most("fem.h_orifice", s.h_orifice, p.orifice_radius / 3, "a third of inlet.orifice_radius");
  at_most("fem.h_orifice", s.h_orifice, s.h_wall, "fem.h_wall");
  at_most("fem.h_rim", s.h_rim, s.h_orifice, "fem.h_orifice");
}

void check_times(Reader& reader, const std::vector<double>& times, double t_end) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string path = "fem.field_times[" + std::to_string(i) + "]";
    if (i > 0 && times[i] <= times[i - 1]) reader.complain(path, "times must increase");
    if (t_end > 0 && times[i] > t_end) {
      reader.complain(path, "later than solve.t_end", "the run ends at " + shortest(t_end) + " s");
    }
  }
}

void read_fields(Reader& reader, double t_end, FemSettings& s) {
  const bool count = reader.node("fem.fields") != nullptr;
  const bool times = reader.node("fem.field_times") != nullptr;
  if (count && times) {
    reader.complain("fem.field_times", "given together with fem.fields", "give one of them");
  } else if (times) {
    s.field_times = reader.list("fem.field_times").value_or(std::vector<double>{});
    check_times(reader, s.field_times, t_end);
  } else if (count) {
    s.fields = reader.integer("fem.fields").value_or(0);
  } else {
    s.fields = 21;
    reader.resolve("fem.fields", [] { return std::string("21"); });
  }
}

}  // namespace

void read_fem(Reader& reader, Case& c) {
  c.fem = {};
  FemSettings& s = c.fem;
  s.scheme = reader.text("fem.scheme") == "bdf1" ? FemScheme::bdf1 : FemScheme::bdf2;
  read_step_size(reader, s);
  s.tolerance = reader.number("fem.tolerance").value_or(1e-8);
  s.max_iterations = reader.integer("fem.max_iterations").value_or(1);
  s.max_steps = reader.integer("fem.max_steps").value_or(1);
  read_mesh(reader, c.parameters, s);
  s.checkpoint_every = reader.number("fem.checkpoint_every").value_or(0);
  read_fields(reader, c.solve.t_end, s);
}

}  // namespace turgor
