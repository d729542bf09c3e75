#include "material.hpp"

#include <algorithm>

#include "points.hpp"

namespace turgor {

namespace {

const PointKeys table_keys{"material.table",
                           {"stretch", "stress"},
                           R"(write { file = "wall.csv" } or { stretch = [1.0, 1.1, ...], stress = ["0 Pa", ...] })"};

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const auto& entry : catalogue()) names.emplace_back(entry.name);
  return names;
}

ValueKind kind_of(const MaterialConstant& constant) {
  if (constant.unit == "1") return constant.is_list ? ValueKind::number_list : ValueKind::number;
  return constant.is_list ? ValueKind::quantity_list : ValueKind::quantity;
}

/// The constants of a material; nothing when something was wrong with one.
std::optional<MaterialValues> read_constants(Reader& reader, const MaterialEntry& entry) {
  MaterialValues values;
  bool complete = true;
  for (const auto& constant : entry.constants) {
    const std::string path = "material." + std::string(constant.key);
    if (constant.is_list) {
      const auto list = reader.list(path);
      complete = complete && list;
      if (list) values[std::string(constant.key)] = *list;
    } else {
      const auto value = reader.number(path);
      complete = complete && value;
      if (value) values[std::string(constant.key)] = {*value};
    }
  }
  if (!complete) return std::nullopt;
  return values;
}

void read_table(Reader& reader, Case& c) {
  if (reader.node(table_keys.table) == nullptr) {
    reader.complain(table_keys.table, "missing", table_keys.forms);
    return;
  }
  const auto points = read_points(reader, c, table_keys, [&](const Points& p) {
    c.parameters.material = make_material("table", {{"table.stretch", p[0]}, {"table.stress", p[1]}});
  });
  if (!points) return;
  reader.resolve(table_keys.table, [&] {
    return "{ stretch = " + toml_list((*points)[0], "1") + ", stress = " + toml_list((*points)[1], "Pa") + " }";
  });
}

}  // namespace

void declare_material(Schema& schema) {
  using enum ValueKind;
  schema.describe("material", "hyperelastic wall; `turgor materials` lists energies and references");
  schema.add({.path = "material.model",
              .kind = text,
              .choices = material_names(),
              .required = true,
              .meaning = "material model"});
  for (const auto& entry : catalogue()) {
    const bool is_table = entry.name == "table";
    if (is_table) {
      schema.add({.path = "material.table",
                  .kind = table,
                  .only_with = "table",
                  .meaning = "stress in equal biaxial stretch: points, inline or from a CSV file"});
      schema.add({.path = "material.table.file",
                  .kind = text,
                  .only_with = "table",
                  .meaning = "CSV file, beside the case; two columns headed \"stretch [1]\" and \"stress [kPa]\", any "
                             "units"});
    }
    for (const auto& constant : entry.constants) {
      schema.add({.path = "material." + std::string(constant.key),
                  .kind = kind_of(constant),
                  .unit = std::string(constant.unit),
                  .range = constant.positive ? positive : Range{},
                  .required = !is_table,  // a file has them too
                  .only_with = std::string(entry.name),
                  .meaning = std::string(constant.meaning)});
    }
  }
  schema.add({.path = "material.max_stretch",
              .kind = number,
              .range = {1, largest_stretch, true},
              .meaning = "stretch at which the wall bursts, which ends the run"});
}

void read_material(Reader& reader, Case& c) {
  const auto model = reader.text("material.model");
  c.max_stretch = reader.number("material.max_stretch").value_or(0);
  if (!model) return;
  c.material_name = *model;
  if (*model == "table") {
    read_table(reader, c);
    return;
  }
  const auto entry = std::ranges::find(catalogue(), *model, &MaterialEntry::name);
  const auto values = read_constants(reader, *entry);
  if (!values) return;
  try {
    c.parameters.material = make_material(*model, *values);
  } catch (const InvalidInput& error) {
    reader.complain(error);
  }
}

}  // namespace turgor
