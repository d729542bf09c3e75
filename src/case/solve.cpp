#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/integrate/quadrature.hpp"

namespace turgor {

void declare_solve(Schema& schema) {
  using enum ValueKind;
  schema.describe("solve", "time integration");
  schema.add(
      {.path = "solve.t_end",
       .unit = "s",
       .range = positive,
       .required = true,
       .meaning = "end of the run, which starts at t = 0; with [motion] the end of its last segment when not given"});
  schema.add(
      {.path = "solve.method",
       .kind = text,
       .choices = {"adaptive", "quadrature"},
       .fallback = "adaptive",
       .meaning = "time steps of adaptive size, or exact integrals where the pressure is constant between steps"});
  schema.add({.path = "solve.rtol",
              .kind = number,
              .range = {1e-13, 1e-2},
              .fallback = "1e-9",
              .meaning = "relative tolerance per step"});
  schema.add({.path = "solve.atol",
              .kind = number,
              .range = {1e-16, 1},
              .meaning = "absolute tolerance per step, dimensionless; as rtol when not given"});
  schema.add(
      {.path = "solve.samples",
       .kind = integer,
       .range = {2, 1e7},
       .meaning = "uniform rows of trajectory.csv, both ends included; 1000 when neither this nor times is given"});
  schema.add({.path = "solve.times",
              .kind = quantity_list,
              .unit = "s",
              .range = not_negative,
              .meaning = "instead of samples: rows at exactly these times"});
  schema.add({.path = "solve.max_events",
              .kind = integer,
              .range = not_negative,
              .fallback = "0",
              .meaning = "stop after this many regime changes; 0: no limit"});
  schema.add({.path = "solve.rest_tol",
              .kind = number,
              .range = {0, 0.1},
              .fallback = "0.0",
              .meaning = "stop at a regime change this close (in R) to a stable equilibrium, once the pressure stays "
                         "constant; 0: never"});
  schema.add({.path = "solve.max_steps",
              .kind = integer,
              .range = {1, 1e8},
              .fallback = "5000000",
              .meaning = "give up after this many steps"});
}

std::string_view name_of(Method method) { return method == Method::quadrature ? "quadrature" : "adaptive"; }

namespace {

double read_end(Reader& reader, const Case& c) {
  if (reader.node("motion") == nullptr || reader.node("solve.t_end") != nullptr) {
    return reader.number("solve.t_end").value_or(0);
  }
  if (!c.motion) return 0;  // something is wrong with it
  const double end = c.motion->end();
  reader.resolve("solve.t_end", [&] { return toml_quantity(end, "s"); });
  return end;
}

void read_method(Reader& reader, const Case& c, SolveSettings& s) {
  s.method = reader.text("solve.method") == "quadrature" ? Method::quadrature : Method::adaptive;
  if (s.method != Method::quadrature || !(s.t_end > 0)) return;
  try {
    require_piecewise_constant(c.pressure, 0.0, s.t_end, 1.0);
  } catch (const InvalidInput& error) {
    reader.complain(error);
  }
}

void read_rows(Reader& reader, SolveSettings& s) {
  const bool samples = reader.node("solve.samples") != nullptr;
  const bool times = reader.node("solve.times") != nullptr;
  if (samples && times) {
    reader.complain("solve.times", "given together with solve.samples", "give one of them");
  } else if (times) {
    s.times = reader.list("solve.times").value_or(std::vector<double>{});
    for (std::size_t i = 0; i < s.times.size(); ++i) {
      const std::string path = "solve.times[" + std::to_string(i) + "]";
      if (i > 0 && s.times[i] <= s.times[i - 1]) reader.complain(path, "times must increase");
      if (s.t_end > 0 && s.times[i] > s.t_end)
        reader.complain(path, "later than solve.t_end", "the run ends at " + shortest(s.t_end) + " s");
    }
  } else if (samples) {
    s.samples = reader.integer("solve.samples").value_or(2);
  } else {
    s.samples = 1000;
    reader.resolve("solve.samples", [] { return std::string("1000"); });
  }
}

}  // namespace

void read_solve(Reader& reader, Case& c) {
  c.solve = {};
  SolveSettings& s = c.solve;
  s.t_end = read_end(reader, c);
  read_method(reader, c, s);
  s.rtol = reader.number("solve.rtol").value_or(1e-9);
  s.atol = reader.number("solve.atol").value_or(s.rtol);
  reader.resolve("solve.atol", [&] { return toml_quantity(s.atol, "1"); });
  read_rows(reader, s);
  s.max_events = reader.integer("solve.max_events").value_or(0);
  s.rest_tol = reader.number("solve.rest_tol").value_or(0);
  s.max_steps = reader.integer("solve.max_steps").value_or(1);
}

}  // namespace turgor
