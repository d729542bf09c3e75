// toml++ 3.3 aborts on odd bytes through its own assertion; it throws a parse error instead when that is off.
#define TOML_ASSERT(condition) static_cast<void>(0)  // NOLINT: its own configuration macro
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/node.hpp"

namespace turgor {

namespace {

/// Overrides come from the command line, where lines mean nothing.
const std::string command_line = "--set";

Node convert(const toml::node& node, const std::string& file) {
  Node result{{}, file, file == command_line ? 0 : static_cast<int>(node.source().begin.line)};
  if (const auto* table = node.as_table()) {
    Node::Table entries;
    for (const auto& [key, value] : *table) entries.push_back({std::string(key.str()), convert(value, file)});
    result.value = std::move(entries);
  } else if (const auto* array = node.as_array()) {
    Node::Array items;
    for (const auto& item : *array) items.push_back(convert(item, file));
    result.value = std::move(items);
  } else if (const auto* text = node.as_string()) {
    result.value = text->get();
  } else if (const auto* integer = node.as_integer()) {
    result.value = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    result.value = number->get();
  } else if (const auto* flag = node.as_boolean()) {
    result.value = flag->get();
  } else {
    std::ostringstream stream;
    node.visit([&](const auto& v) { stream << v; });
    result.value = Node::Other{stream.str()};
  }
  return result;
}

/// Tables of a file come sorted by key from the parser; messages are read from top to bottom.
void sort_by_line(Node& node) {
  if (auto* table = std::get_if<Node::Table>(&node.value)) {
    std::ranges::stable_sort(*table, {}, [](const Node::Entry& entry) { return entry.node.line; });
    for (Node::Entry& entry : *table) sort_by_line(entry.node);
  } else if (auto* array = std::get_if<Node::Array>(&node.value)) {
    for (auto& item : *array) sort_by_line(item);
  }
}

InvalidInput bad_override(std::string_view assignment, std::string problem) {
  return InvalidInput(
      {{"", "", "\"" + std::string(assignment) + "\": " + std::move(problem),
        "write --set table.key=value, for example --set 'inlet.orifice_radius=2 cm'", command_line, 0}});
}

/// One step of a path: a key, and what follows it up to the next key.
struct PathStep {
  std::string_view key;
  std::string_view indices;  ///< "[0][2]" or empty
  std::string_view rest;
};

/// Splits off the first key, which may be quoted; an empty key when there is none.
PathStep first_step(std::string_view path) {
  PathStep step;
  std::size_t end = 0;
  while (end < path.size() && path[end] != '.' && path[end] != '[') ++end;
  if (path.starts_with('"')) {
    const std::size_t quote = path.find('"', 1);
    if (quote == std::string_view::npos) return {};
    step.key = path.substr(1, quote - 1);
    end = quote + 1;
  } else {
    step.key = path.substr(0, end);
  }
  path = end >= path.size() ? std::string_view{} : path.substr(end);
  const std::size_t dot = path.find('.');
  step.indices = path.substr(0, dot);
  step.rest = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
  return step;
}

/// Splits "[3]" off a row of indices; nothing when it is not written like that.
std::optional<std::size_t> first_index(std::string_view& indices) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(indices.data() + 1, indices.data() + indices.size(), index);
  if (indices.front() != '[' || error != std::errc{} || end == indices.data() + indices.size() || *end != ']') {
    return std::nullopt;
  }
  indices.remove_prefix(static_cast<std::size_t>(end + 1 - indices.data()));
  return index;
}

Node parse_override_value(const std::string& text) {
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) {
      Node node = convert(*table.get("value"), command_line);
      sort_by_line(node);
      return node;
    }
  } catch (const toml::parse_error&) {  // not TOML: a bare string
  }
  return Node{text, command_line, 0};
}

}  // namespace

const Node* Node::find(std::string_view key) const {
  if (const auto* table = as<Table>()) {
    for (const auto& [name, node] : *table) {
      if (name == key) return &node;
    }
  }
  return nullptr;
}

std::string Node::text() const {
  struct Visitor {
    std::string operator()(const Table& t) const {
      std::string out = "{";
      for (const auto& [key, node] : t) out += (out.size() > 1 ? ", " : " ") + key + " = " + node.text();
      return out + " }";
    }
    std::string operator()(const Array& a) const {
      std::string out = "[";
      for (const Node& item : a) out += (out.size() > 1 ? ", " : "") + item.text();
      return out + "]";
    }
    std::string operator()(const std::string& s) const { return "\"" + s + "\""; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(double d) const { return shortest(d); }
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(const Other& o) const { return o.text; }
    std::string operator()(const Quantity& q) const { return "\"" + shortest(q.value) + " " + q.unit + "\""; }
  };
  std::string out = std::visit(Visitor{}, value);
  if (out.size() > 60) {
    std::size_t end = 57;
    while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0U) == 0x80U) --end;  // not within a character
    out = out.substr(0, end) + "...";
  }
  return out;
}

namespace {

using Difference = std::optional<NodeDifference>;

/// A value that is neither table nor list; only texts are long, which text() would shorten.
bool same_scalar(const Node& a, const Node& b) {
  if (a.value.index() != b.value.index()) return false;
  const auto* text = a.as<std::string>();
  return text != nullptr ? *text == *b.as<std::string>() : a.text() == b.text();
}

Difference difference_at(const std::string& path, const Node* a, const Node* b, std::span<const std::string> ignored);

Difference in_tables(const std::string& path, const Node& a, const Node& b, std::span<const std::string> ignored) {
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const Node::Entry& entry : *a.as<Node::Table>()) {
    if (auto found = difference_at(prefix + entry.key, &entry.node, b.find(entry.key), ignored)) return found;
  }
  for (const Node::Entry& entry : *b.as<Node::Table>()) {
    if (a.find(entry.key) != nullptr) continue;
    if (auto found = difference_at(prefix + entry.key, nullptr, &entry.node, ignored)) return found;
  }
  return std::nullopt;
}

Difference in_lists(const std::string& path, const Node& a, const Node& b, std::span<const std::string> ignored) {
  const auto& first = *a.as<Node::Array>();
  const auto& second = *b.as<Node::Array>();
  if (first.size() != second.size()) return NodeDifference{path, &a, &b};
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::string place = path + "[" + std::to_string(i) + "]";
    if (auto found = difference_at(place, &first[i], &second[i], ignored)) return found;
  }
  return std::nullopt;
}

Difference difference_at(const std::string& path, const Node* a, const Node* b, std::span<const std::string> ignored) {
  if (std::ranges::find(ignored, path) != ignored.end()) return std::nullopt;
  if (a == nullptr || b == nullptr) return NodeDifference{path, a, b};
  if (a->as<Node::Table>() != nullptr && b->as<Node::Table>() != nullptr) return in_tables(path, *a, *b, ignored);
  if (a->as<Node::Array>() != nullptr && b->as<Node::Array>() != nullptr) return in_lists(path, *a, *b, ignored);
  if (same_scalar(*a, *b)) return std::nullopt;
  return NodeDifference{path, a, b};
}

}  // namespace

std::optional<NodeDifference> first_difference(const Node& first, const Node& second,
                                               std::span<const std::string> ignored) {
  return difference_at("", &first, &second, ignored);
}

std::string_view Node::type_name() const {
  static constexpr std::array<std::string_view, 8> names{"a table",  "a list",    "a string",       "an integer",
                                                         "a number", "a boolean", "a date or time", "a quantity"};
  return names[value.index()];
}

Node parse_toml(std::string_view text, const std::string& file) {
  try {
    const toml::table table = toml::parse(text, file);
    Node root = convert(table, file);
    sort_by_line(root);
    return root;
  } catch (const toml::parse_error& error) {
    throw InvalidInput({{"", "", "not valid TOML: " + std::string(error.description()), "", file,
                         static_cast<int>(error.source().begin.line)}});
  }
}

const Node* find_value(const Node& root, std::string_view path) {
  const Node* current = &root;
  while (current != nullptr && !path.empty()) {
    const PathStep step = first_step(path);
    current = current->find(step.key);
    std::string_view indices = step.indices;
    while (current != nullptr && !indices.empty()) {
      const auto index = first_index(indices);
      const auto* array = current->as<Node::Array>();
      current = index && array != nullptr && *index < array->size() ? &(*array)[*index] : nullptr;
    }
    path = step.rest;
  }
  return current;
}

Node& place_value(Node& root, std::string_view path) {
  const auto wrong = [](std::string problem) { return InvalidInput("", "", std::move(problem)); };
  Node* node = &root;
  while (true) {
    const PathStep step = first_step(path);
    if (step.key.empty()) throw wrong("no key before the equals sign");
    auto* table = std::get_if<Node::Table>(&node->value);
    if (table == nullptr) throw wrong("the path runs through " + std::string(node->type_name()));
    auto entry = std::ranges::find(*table, step.key, &Node::Entry::key);
    if (entry == table->end()) {
      entry = table->insert(table->end(), Node::Entry{std::string(step.key), Node{Node::Table{}, command_line, 0}});
    }
    node = &entry->node;
    for (std::string_view indices = step.indices; !indices.empty();) {
      const auto index = first_index(indices);
      if (!index) throw wrong("an index is written [0]");
      auto* array = std::get_if<Node::Array>(&node->value);
      if (array == nullptr || *index >= array->size()) {
        throw wrong(std::string(step.key) + " has no element [" + std::to_string(*index) + "]");
      }
      node = &(*array)[*index];
    }
    if (step.rest.empty()) return *node;
    path = step.rest;
  }
}

void apply_override(Node& root, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) throw bad_override(assignment, "no equals sign");
  std::string_view key = assignment.substr(0, equals);
  while (!key.empty() && key.back() == ' ') key.remove_suffix(1);
  Node* node = nullptr;
  try {
    node = &place_value(root, key);
  } catch (const InvalidInput& error) {
    throw bad_override(assignment, error.issues().front().problem);
  }
  std::string_view value = assignment.substr(equals + 1);
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  *node = parse_override_value(std::string(value));
}

}  // namespace turgor
