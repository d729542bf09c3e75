#include "turgor/case/case_template.hpp"

#include <algorithm>

#include "parts.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

/// Converts every text that a key of the schema reads as a quantity.
void convert_units(Node& node, const std::string& path, const Reader& reader) {
  if (auto* table = std::get_if<Node::Table>(&node.value)) {
    for (auto& entry : *table) convert_units(entry.node, path.empty() ? entry.key : path + "." + entry.key, reader);
    return;
  }
  const Key* key = path.starts_with("sweep.") ? nullptr : reader.find_key(path);
  if (auto* list = std::get_if<Node::Array>(&node.value)) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      Node& item = (*list)[i];
      const auto* text = item.as<std::string>();
      if (key != nullptr && key->kind == ValueKind::quantity_list && text != nullptr) {
        item.value = Node::Quantity{parse_quantity(*text, key->unit), key->unit};
      } else {
        convert_units(item, path + "[" + std::to_string(i) + "]", reader);
      }
    }
  } else if (const auto* text = node.as<std::string>(); key != nullptr && text != nullptr) {
    const bool word = std::ranges::find(key->choices, *text) != key->choices.end();
    if (key->kind == ValueKind::quantity && !word)
      node.value = Node::Quantity{parse_quantity(*text, key->unit), key->unit};
  }
}

}  // namespace

CaseTemplate::CaseTemplate(const Case& base, const std::vector<std::string>& keys)
    : tree_(*base.tree), keys_(keys), base_(base) {
  convert_units(tree_, "", Reader(case_schema(), *base.tree, false));
  for (const std::string& key : keys) (void)place_value(tree_, key);
  for (const Part& part : case_parts()) {
    if (!part.of_a_member) continue;
    const bool differs = std::ranges::any_of(keys, [&](const std::string& key) {
      return std::ranges::find(part.tables, key.substr(0, key.find('.'))) != part.tables.end();
    });
    if (differs || part.uses_earlier) readers_.push_back(part.read);
  }
  base_.expectations.clear();
  base_.sweep.reset();
  base_.source.clear();
  base_.resolved.clear();
  base_.tree.reset();
}

Case CaseTemplate::with(std::span<const Node> values) {
  for (std::size_t i = 0; i < keys_.size(); ++i) place_value(tree_, keys_[i]) = values[i];
  Case c = base_;
  Reader reader(case_schema(), tree_, false);
  for (const auto read : readers_) read(reader, c);
  if (!reader.issues().empty()) throw InvalidInput(reader.issues());
  return c;
}

}  // namespace turgor
