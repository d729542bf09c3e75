#include "parts.hpp"
#include "turgor/case/quantities.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

void declare_report(Schema& schema) {
  using enum ValueKind;
  schema.describe("output", "units of tables and pictures");
  const auto unit = [&](const char* key, const char* fallback, const char* meaning) {
    schema.add({.path = std::string("output.") + key, .kind = text, .fallback = fallback, .meaning = meaning});
  };
  unit("time_unit", "s", "unit of times");
  unit("length_unit", "m", "unit of radii");
  unit("pressure_unit", "Pa", "unit of pressures: kPa, mmHg, psi, ...");
  unit("volume_unit", "m^3", "unit of volumes: mL, L, cm^3, ...");
  unit("flow_unit", "m^3/s", "unit of flow rates: mL/s, L/min, ...");
  unit("energy_unit", "J", "unit of energies");
  schema.add({.path = "output.pictures", .kind = boolean, .fallback = "true", .meaning = "draw pictures"});

  schema.describe("expect", "quantities checked after the run (exit code 3 when one is missed)");
  for (const auto& quantity : quantity_names()) {
    const std::string path = "expect." + std::string(quantity.name);
    const std::string si(quantity.unit);
    const ValueKind kind = si == "1" ? number : ValueKind::quantity;
    schema.add({.path = path, .kind = table, .meaning = std::string(quantity.meaning)});
    schema.add({.path = path + ".value", .kind = kind, .unit = si, .required = true, .meaning = "expected value"});
    schema.add({.path = path + ".tolerance",
                .kind = kind,
                .unit = si,
                .range = not_negative,
                .required = true,
                .meaning = "largest allowed difference"});
  }
}

namespace {

std::string read_unit(Reader& reader, const std::string& key, const std::string& si) {
  const std::string path = "output." + key;
  const auto unit = reader.text(path);
  if (!unit) return si;
  try {
    (void)unit_factor(*unit, si);
  } catch (const InvalidInput& error) {
    reader.complain(path, error.issues().front().problem, "a unit of the same kind as " + si);
  }
  return *unit;
}

}  // namespace

void read_report(Reader& reader, Case& c) {
  c.output = {read_unit(reader, "time_unit", "s"),
              read_unit(reader, "length_unit", "m"),
              read_unit(reader, "pressure_unit", "Pa"),
              read_unit(reader, "volume_unit", "m^3"),
              read_unit(reader, "flow_unit", "m^3/s"),
              read_unit(reader, "energy_unit", "J"),
              reader.boolean("output.pictures").value_or(true)};
  for (const auto& quantity : quantity_names()) {
    const std::string path = "expect." + std::string(quantity.name);
    if (reader.node(path) == nullptr || reader.node(path)->as<Node::Table>() == nullptr)
      continue;  // check_unknown tells
    const auto value = reader.number(path + ".value");
    const auto tolerance = reader.number(path + ".tolerance");
    if (!value || !tolerance) continue;
    const std::string unit(quantity.unit);
    c.expectations.push_back({std::string(quantity.name), *value, *tolerance});
    reader.resolve(path, [&] {
      return "{ value = " + toml_quantity(*value, unit) + ", tolerance = " + toml_quantity(*tolerance, unit) + " }";
    });
  }
}

}  // namespace turgor
