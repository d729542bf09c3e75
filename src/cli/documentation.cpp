#include <iostream>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/case/case.hpp"

namespace turgor::cli {

namespace {

using Json = nlohmann::ordered_json;

/// "quantity [m], > 0 m, required" and the like.
std::string rule(const Key& key) {
  std::string out(name_of(key.kind));
  const bool dimensional = key.kind == ValueKind::quantity || key.kind == ValueKind::quantity_list;
  if (dimensional) out += " [" + key.unit + "]";
  if (!key.range.is_everything()) out += ", " + key.range.text(dimensional ? key.unit : "1");
  std::string separator = key.kind == ValueKind::text ? ": " : ", or ";
  for (const std::string& choice : key.choices) {
    out += separator + choice;
    separator = " | ";
  }
  if (!key.fallback.empty()) out += ", default " + key.fallback;
  if (key.required) out += ", required";
  return out;
}

}  // namespace

int print_documentation(const DocArguments& arguments) {
  const Schema& schema = case_schema();
  std::string names;
  bool found = arguments.table.empty();
  for (const auto& table : schema.tables()) {
    names += (names.empty() ? "" : ", ") + table.name;
    found = found || table.name == arguments.table;
  }
  if (!found) throw InvalidInput("table", arguments.table, "no such table in a case file", "known are " + names);

  if (arguments.json) {
    std::cout << schema_json(schema, arguments.table);
    return exit_done;
  }
  std::string text;
  std::string table = "?";
  for (const Key& key : schema.keys()) {
    if (!arguments.table.empty() && table_of(key) != arguments.table) continue;
    if (table_of(key) != table) {
      table = table_of(key);
      for (const auto& described : schema.tables()) {
        if (described.name == table) text += "\n[" + table + "]  " + described.meaning + "\n";
      }
    }
    const std::string only = key.only_with.empty() ? "" : " (" + key.only_with + ")";
    text += "  " + key.path + only + "\n      " + rule(key) + "\n      " + key.meaning + "\n";
  }
  std::cout << text;
  return exit_done;
}

int print_materials(bool json) {
  Json document = Json::array();
  std::string text = "W is the strain energy density; I1 = 2 lambda^2 + lambda^-4, I2 = lambda^4 + 2 lambda^-2.\n";
  for (const MaterialEntry& entry : catalogue()) {
    text += "\n" + std::string(entry.name) + "\n  W = " + std::string(entry.energy) + "\n  " +
            std::string(entry.reference) + "\n";
    Json constants = Json::array();
    for (const MaterialConstant& constant : entry.constants) {
      const std::string unit(constant.unit);
      text += "    " + std::string(constant.key) + " [" + unit + "]" + (constant.is_list ? " list" : "") +
              (constant.positive ? " > 0" : "") + "  " + std::string(constant.meaning) + "\n";
      constants.push_back({{"key", constant.key},
                           {"unit", unit},
                           {"list", constant.is_list},
                           {"positive", constant.positive},
                           {"meaning", constant.meaning}});
    }
    document.push_back(
        {{"name", entry.name}, {"energy", entry.energy}, {"reference", entry.reference}, {"constants", constants}});
  }
  std::cout << (json ? document.dump(2) + "\n" : text);
  return exit_done;
}

}  // namespace turgor::cli
