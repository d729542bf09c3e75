#include <filesystem>

#include "csv_table.hpp"
#include "parts.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

void declare_pressure(Schema& schema) {
  using enum ValueKind;
  schema.describe("pressure", "gauge pressure at the inlet: one of constant, segments, harmonic, table");
  schema.add({.path = "pressure.constant", .unit = "Pa", .meaning = "the same pressure throughout"});
  schema.add({.path = "pressure.start",
              .unit = "Pa",
              .meaning = "pressure at t = 0 of a list of segments; 0 Pa when not given"});
  schema.add({.path = "pressure.segments",
              .kind = table_list,
              .meaning = "one after the other from t = 0; the last value holds to t_end"});
  schema.add(
      {.path = "pressure.segments[].hold", .unit = "s", .range = positive, .meaning = "keep the pressure this long"});
  schema.add({.path = "pressure.segments[].step", .unit = "Pa", .meaning = "jump to this pressure"});
  schema.add({.path = "pressure.segments[].to", .unit = "Pa", .meaning = "go to this pressure, over `over`"});
  schema.add({.path = "pressure.segments[].over", .unit = "s", .range = positive, .meaning = "duration of `to`"});
  schema.add({.path = "pressure.segments[].shape",
              .kind = text,
              .choices = {"linear", "smooth"},
              .fallback = "linear",
              .meaning = "of `to`: a straight line, or x^3 (10 - 15 x + 6 x^2)"});
  schema.add({.path = "pressure.harmonic", .kind = table, .meaning = "mean + amplitude sin(2 pi frequency t + phase)"});
  schema.add({.path = "pressure.harmonic.mean", .unit = "Pa", .fallback = "0 Pa", .meaning = "mean"});
  schema.add({.path = "pressure.harmonic.amplitude", .unit = "Pa", .required = true, .meaning = "amplitude"});
  schema.add({.path = "pressure.harmonic.frequency",
              .unit = "Hz",
              .range = positive,
              .required = true,
              .meaning = "frequency"});
  schema.add({.path = "pressure.harmonic.phase", .unit = "rad", .fallback = "0 rad", .meaning = "phase at t = 0"});
  schema.add(
      {.path = "pressure.table", .kind = table, .meaning = "points, inline or from a CSV file; constant beyond them"});
  schema.add({.path = "pressure.table.file",
              .kind = text,
              .meaning = "CSV file, beside the case; two columns headed \"t [s]\" and \"p [kPa]\", any units"});
  schema.add({.path = "pressure.table.t", .kind = quantity_list, .unit = "s", .meaning = "times, increasing"});
  schema.add({.path = "pressure.table.p", .kind = quantity_list, .unit = "Pa", .meaning = "pressures"});
  schema.add({.path = "pressure.table.interpolation",
              .kind = text,
              .choices = {"linear", "cubic"},
              .fallback = "cubic",
              .meaning = "between points: straight lines, or a monotone cubic"});
}

namespace {

/// One segment as it was read.
struct Segment {
  std::string kind;
  double value;
  double duration = 0;
  std::string shape{};
};

std::string toml_of(const std::vector<Segment>& segments) {
  std::string out;
  for (const Segment& s : segments) {
    out += (out.empty() ? "[{ " : ", { ") + s.kind + " = " + toml_quantity(s.value, s.kind == "hold" ? "s" : "Pa");
    if (s.kind == "to") out += ", over = " + toml_quantity(s.duration, "s") + ", shape = " + toml_string(s.shape);
    out += " }";
  }
  return out + "]";
}

/// One segment; nothing is appended when something is wrong with it.
void read_segment(Reader& reader, const std::string& path, SegmentList<double>& list, std::vector<Segment>& segments) {
  const auto given = [&](const char* key) { return reader.node(path + "." + key) != nullptr; };
  const int kinds = (given("hold") ? 1 : 0) + (given("step") ? 1 : 0) + (given("to") ? 1 : 0);
  const std::string forms = "write { hold = \"2 s\" }, { step = \"36 kPa\" } or { to = \"36 kPa\", over = \"2 s\" }";
  if (kinds != 1) {
    reader.complain(path, kinds == 0 ? "says neither hold, step nor to" : "says more than one of hold, step and to",
                    forms);
    return;
  }
  if (given("hold")) {
    if (const auto duration = reader.number(path + ".hold")) {
      list.hold(*duration);
      segments.push_back({"hold", *duration});
    }
  } else if (given("step")) {
    if (const auto value = reader.number(path + ".step")) {
      list.step(*value);
      segments.push_back({"step", *value});
    }
  } else {
    if (!given("over")) reader.complain(path, "says to but not over", forms);
    const auto value = reader.number(path + ".to");
    const auto duration = reader.number(path + ".over");
    const auto shape = reader.text(path + ".shape");
    if (value && duration && shape) {
      list.ramp(*value, *duration, *shape == "smooth" ? RampShape::smooth : RampShape::linear);
      segments.push_back({"to", *value, *duration, *shape});
    }
  }
  if (!given("to")) {
    for (const char* extra : {"over", "shape"}) {
      if (given(extra)) reader.complain(path + "." + extra, "goes with `to` only", forms);
    }
  }
}

void read_segments(Reader& reader, Case& c) {
  const auto* items = reader.node("pressure.segments")->as<Node::Array>();
  if (items == nullptr) return;  // said by check_unknown
  if (items->empty()) {
    reader.complain("pressure.segments", "is empty", "give at least one segment, or constant = \"0 Pa\"");
    return;
  }
  SegmentList<double> list(reader.number("pressure.start").value_or(0));
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < items->size(); ++i) {
    if ((*items)[i].as<Node::Table>() != nullptr) {
      read_segment(reader, "pressure.segments[" + std::to_string(i) + "]", list, segments);
    }
  }
  c.pressure = list.build();
  reader.resolve("pressure.segments", [&] { return toml_of(segments); });
}

void read_harmonic(Reader& reader, Case& c) {
  if (reader.node("pressure.harmonic")->as<Node::Table>() == nullptr) return;  // said by check_unknown
  const auto mean = reader.number("pressure.harmonic.mean");
  const auto amplitude = reader.number("pressure.harmonic.amplitude");
  const auto frequency = reader.number("pressure.harmonic.frequency");
  const auto phase = reader.number("pressure.harmonic.phase");
  if (!(mean && amplitude && frequency && phase)) return;
  c.pressure = harmonic_pressure(HarmonicPressure<double>{*mean, *amplitude, *frequency, *phase});
  reader.resolve("pressure.harmonic", [&] {
    return "{ mean = " + toml_quantity(*mean, "Pa") + ", amplitude = " + toml_quantity(*amplitude, "Pa") +
           ", frequency = " + toml_quantity(*frequency, "Hz") + ", phase = " + toml_quantity(*phase, "rad") + " }";
  });
}

void read_table(Reader& reader, Case& c) {
  if (reader.node("pressure.table")->as<Node::Table>() == nullptr) return;  // said by check_unknown
  const bool inline_points = reader.node("pressure.table.t") != nullptr || reader.node("pressure.table.p") != nullptr;
  const auto interpolation = reader.text("pressure.table.interpolation");
  const auto file = reader.text("pressure.table.file");
  CsvTable table;
  if (inline_points == file.has_value()) {
    reader.complain("pressure.table", inline_points ? "has both a file and inline points" : "has no points",
                    "write { file = \"p.csv\" } or { t = [\"0 s\", ...], p = [\"0 Pa\", ...] }");
    return;
  }
  try {
    if (file) {
      table = read_csv(c.file.parent_path() / *file, {"s", "Pa"});
    } else {
      for (const char* key : {"pressure.table.t", "pressure.table.p"}) {
        if (reader.node(key) == nullptr) reader.complain("pressure.table", std::string("has no list ") + key);
      }
      const auto times = reader.list("pressure.table.t");
      const auto pressures = reader.list("pressure.table.p");
      if (!times || !pressures) return;
      table = {*times, *pressures};
    }
    if (!interpolation) return;
    c.pressure = table_pressure(table[0], table[1],
                                *interpolation == "linear" ? TableInterpolation::linear : TableInterpolation::cubic);
  } catch (const InvalidInput& error) {
    for (const Issue& issue : error.issues()) {
      reader.complain(file ? "pressure.table.file" : "pressure.table",
                      issue.value.empty() ? issue.problem : issue.value + ": " + issue.problem, issue.advice);
    }
    return;
  }
  reader.resolve("pressure.table", [&] {
    return "{ t = " + toml_list(table[0], "s") + ", p = " + toml_list(table[1], "Pa") +
           ", interpolation = " + toml_string(*interpolation) + " }";
  });
}

}  // namespace

void read_pressure(Reader& reader, Case& c) {
  std::vector<std::string> given;
  for (const char* key : {"constant", "segments", "harmonic", "table"}) {
    if (reader.node(std::string("pressure.") + key) != nullptr) given.emplace_back(key);
  }
  if (given.size() != 1) {
    std::string names;
    for (const auto& name : given) names += (names.empty() ? "" : " and ") + name;
    reader.complain("pressure", given.empty() ? "no pressure program" : "more than one pressure program: " + names,
                    "give one of constant, segments, harmonic, table");
    return;
  }
  if (given.front() != "segments" && reader.node("pressure.start") != nullptr) {
    reader.complain("pressure.start", "goes with segments only");
  }
  if (given.front() == "constant") {
    if (const auto value = reader.number("pressure.constant")) c.pressure = constant_pressure(*value);
  } else if (given.front() == "segments") {
    read_segments(reader, c);
  } else if (given.front() == "harmonic") {
    read_harmonic(reader, c);
  } else {
    read_table(reader, c);
  }
}

}  // namespace turgor
