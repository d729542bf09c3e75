#include "parts.hpp"
#include "points.hpp"
#include "segments.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {
const SegmentKeys segment_keys{.start = "pressure.start",
                               .list = "pressure.segments",
                               .unit = "Pa",
                               .quantity = "pressure",
                               .example = "36 kPa",
                               .steps = true};

const PointKeys table_keys{
    "pressure.table", {"t", "p"}, R"(write { file = "p.csv" } or { t = ["0 s", ...], p = ["0 Pa", ...] })"};
}  // namespace

void declare_pressure(Schema& schema) {
  using enum ValueKind;
  schema.describe("pressure", "gauge pressure at the inlet: one of constant, segments, harmonic, table");
  schema.add({.path = "pressure.constant", .unit = "Pa", .meaning = "the same pressure throughout"});
  declare_segments(schema, segment_keys);
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
  const auto interpolation = reader.text("pressure.table.interpolation");
  const auto points = read_points(reader, c, table_keys, [&](const Points& p) {
    if (!interpolation) return;
    c.pressure =
        table_pressure(p[0], p[1], *interpolation == "linear" ? TableInterpolation::linear : TableInterpolation::cubic);
  });
  if (!points || !interpolation) return;
  reader.resolve("pressure.table", [&] {
    return "{ t = " + toml_list((*points)[0], "s") + ", p = " + toml_list((*points)[1], "Pa") +
           ", interpolation = " + toml_string(*interpolation) + " }";
  });
}

}  // namespace

void read_pressure(Reader& reader, Case& c) {
  if (reader.node("motion") != nullptr) return;  // it has a pressure of its own
  std::vector<std::string> given;
  for (const char* key : {"constant", "segments", "harmonic", "table"}) {
    if (reader.node(std::string("pressure.") + key) != nullptr) given.emplace_back(key);
  }
  if (given.size() != 1) {
    std::string names;
    for (const auto& name : given) names += (names.empty() ? "" : " and ") + name;
    reader.complain("pressure", given.empty() ? "no pressure program" : "more than one pressure program: " + names,
                    "give one of constant, segments, harmonic, table" +
                        std::string(given.empty() ? ", or dictate the radius with [motion]" : ""));
    return;
  }
  if (given.front() != "segments" && reader.node("pressure.start") != nullptr) {
    reader.complain("pressure.start", "goes with segments only");
  }
  if (given.front() == "constant") {
    if (const auto value = reader.number("pressure.constant")) c.pressure = constant_pressure(*value);
  } else if (given.front() == "segments") {
    if (const auto list = read_segments(reader, segment_keys)) c.pressure = list->build();
  } else if (given.front() == "harmonic") {
    read_harmonic(reader, c);
  } else {
    read_table(reader, c);
  }
}

}  // namespace turgor
