#include "turgor/case/schema.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "turgor/base/text.hpp"

namespace turgor {

bool Range::is_everything() const { return std::isinf(least) && std::isinf(greatest); }

std::string Range::text(const std::string& unit) const {
  const std::string suffix = unit == "1" ? "" : " " + unit;
  if (is_everything()) return "any";
  if (std::isinf(greatest)) return (open_least ? "> " : ">= ") + shortest(least) + suffix;
  if (std::isinf(least)) return "<= " + shortest(greatest) + suffix;
  return (open_least ? "above " : "from ") + shortest(least) + " to " + shortest(greatest) + suffix;
}

std::string without_indices(std::string_view path) {
  std::string out;
  bool inside = false;
  for (const char c : path) {
    if (c == ']') inside = false;
    if (!inside) out += c;
    if (c == '[') inside = true;
  }
  return out;
}

void Schema::add(Key key) {
  by_path_[key.path].push_back(keys_.size());
  keys_.push_back(std::move(key));
}

const Key* Schema::find(std::string_view path, std::string_view material) const {
  const bool has_indices = path.find('[') != std::string_view::npos;
  const auto found = has_indices ? by_path_.find(without_indices(path)) : by_path_.find(path);
  if (found == by_path_.end()) return nullptr;
  for (const std::size_t at : found->second) {
    const Key& key = keys_[at];
    if (key.only_with.empty() || key.only_with == material) return &key;
  }
  return nullptr;
}

bool Schema::has_below(std::string_view path) const {
  const std::string name = without_indices(path);
  return std::ranges::any_of(
      keys_, [&](const Key& key) { return key.path.starts_with(name + ".") || key.path.starts_with(name + "[]."); });
}

namespace {

/// Levenshtein distance: how many letters to insert, delete or replace.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string Schema::nearest(std::string_view path, std::string_view material) const {
  const std::string name = without_indices(path);
  const std::size_t dot = name.rfind('.');
  const std::string parent = dot == std::string::npos ? "" : name.substr(0, dot + 1);
  const std::string last = name.substr(parent.size());
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, last.size() / 2) + 1;
  for (const Key& key : keys_) {
    if (!key.path.starts_with(parent) || !(key.only_with.empty() || key.only_with == material)) continue;
    std::string candidate = key.path.substr(parent.size());
    candidate = candidate.substr(0, candidate.find_first_of(".["));
    const bool abbreviated =
        last.size() > 2 && (candidate.find(last) != std::string::npos || last.find(candidate) != std::string::npos);
    const std::size_t distance = abbreviated ? 1 : edit_distance(last, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = parent + candidate;
    }
  }
  return best;
}

std::string_view name_of(ValueKind kind) {
  switch (kind) {
    case ValueKind::quantity: return "quantity";
    case ValueKind::number: return "number";
    case ValueKind::integer: return "integer";
    case ValueKind::boolean: return "true/false";
    case ValueKind::text: return "string";
    case ValueKind::quantity_list: return "list of quantities";
    case ValueKind::number_list: return "list of numbers";
    case ValueKind::text_list: return "list of strings";
    case ValueKind::table:
    case ValueKind::free_table: return "table";
    case ValueKind::table_list: return "list of tables";
  }
  return "";
}

std::string table_of(const Key& key) {
  const std::size_t dot = key.path.find('.');
  return dot == std::string::npos ? "" : key.path.substr(0, dot);
}

std::string schema_json(const Schema& schema, std::string_view table) {
  nlohmann::ordered_json document = nlohmann::ordered_json::array();
  for (const Key& key : schema.keys()) {
    if (!table.empty() && table_of(key) != table) continue;
    document.push_back({{"key", key.path},
                        {"type", name_of(key.kind)},
                        {"unit", key.unit},
                        {"range", key.range.text(key.unit)},
                        {"choices", key.choices},
                        {"default", key.fallback},
                        {"required", key.required},
                        {"only_with_material", key.only_with},
                        {"meaning", key.meaning}});
  }
  return document.dump(2) + "\n";
}

}  // namespace turgor
