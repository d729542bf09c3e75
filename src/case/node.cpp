// toml++ 3.3 aborts on odd bytes through its own assertion; it throws a parse error instead when that is off.
#define TOML_ASSERT(condition) static_cast<void>(0)  // NOLINT: its own configuration macro
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
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

/// One step of a path: a key, and the list indices that follow it.
struct PathStep {
  std::string key;
  std::vector<std::size_t> indices;
};

std::vector<PathStep> parse_path(std::string_view path, std::string_view assignment) {
  std::vector<PathStep> steps;
  while (true) {
    const std::size_t dot = path.find('.');
    std::string_view part = path.substr(0, dot);
    PathStep step;
    const std::size_t bracket = part.find('[');
    step.key = std::string(part.substr(0, bracket));
    part = bracket == std::string_view::npos ? std::string_view{} : part.substr(bracket);
    while (!part.empty()) {
      std::size_t index = 0;
      const auto [end, error] = std::from_chars(part.data() + 1, part.data() + part.size(), index);
      if (error != std::errc{} || part.front() != '[' || end == part.data() + part.size() || *end != ']') {
        throw bad_override(assignment, "an index is written [0]");
      }
      step.indices.push_back(index);
      part.remove_prefix(static_cast<std::size_t>(end + 1 - part.data()));
    }
    if (step.key.empty()) throw bad_override(assignment, "no key before the equals sign");
    steps.push_back(std::move(step));
    if (dot == std::string_view::npos) return steps;
    path.remove_prefix(dot + 1);
  }
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
  };
  std::string out = std::visit(Visitor{}, value);
  if (out.size() > 60) out = out.substr(0, 57) + "...";
  return out;
}

std::string_view Node::type_name() const {
  static constexpr std::array<std::string_view, 7> names{"a table",  "a list",    "a string",      "an integer",
                                                         "a number", "a boolean", "a date or time"};
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

void apply_override(Node& root, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) throw bad_override(assignment, "no equals sign");
  std::string_view key = assignment.substr(0, equals);
  while (!key.empty() && key.back() == ' ') key.remove_suffix(1);
  Node* node = &root;
  for (const PathStep& step : parse_path(key, assignment)) {
    auto* table = std::get_if<Node::Table>(&node->value);
    if (table == nullptr) throw bad_override(assignment, "the path runs through " + std::string(node->type_name()));
    auto entry = std::ranges::find(*table, step.key, &Node::Entry::key);
    if (entry == table->end())
      entry = table->insert(table->end(), Node::Entry{step.key, Node{Node::Table{}, command_line, 0}});
    node = &entry->node;
    for (const std::size_t index : step.indices) {
      auto* array = std::get_if<Node::Array>(&node->value);
      if (array == nullptr || index >= array->size()) {
        throw bad_override(assignment, step.key + " has no element [" + std::to_string(index) + "]");
      }
      node = &(*array)[index];
    }
  }
  std::string_view value = assignment.substr(equals + 1);
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  *node = parse_override_value(std::string(value));
}

}  // namespace turgor
