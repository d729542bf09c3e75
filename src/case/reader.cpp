#include "turgor/case/reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

std::string toml_string(std::string_view text) {
  return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string toml_quantity(double value, const std::string& unit) {
  std::string number = shortest(value);
  if (unit != "1") return "\"" + number + " " + unit + "\"";
  if (number.find_first_of(".en") == std::string::npos) number += ".0";
  return number;
}

std::string toml_list(const std::vector<double>& values, const std::string& unit) {
  std::string out = "[";
  for (const double value : values) out += (out.size() > 1 ? ", " : "") + toml_quantity(value, unit);
  return out + "]";
}

namespace {

std::string choices_text(const std::vector<std::string>& choices) {
  std::string out;
  for (const auto& choice : choices) out += (out.empty() ? "\"" : ", \"") + choice + "\"";
  return out;
}

bool contains(const std::vector<std::string>& list, std::string_view item) {
  return std::ranges::find(list, item) != list.end();
}

}  // namespace

Reader::Reader(const Schema& schema, const Node& root, bool keeps_resolved)
    : schema_(schema), root_(root), keeps_resolved_(keeps_resolved) {
  const Node* model = node("material.model");
  const auto* name = model != nullptr ? model->as<std::string>() : nullptr;
  materials_.push_back(name != nullptr ? *name : "");
  const Node* swept = node("sweep.axes.\"material.model\".values");
  const auto* values = swept != nullptr ? swept->as<Node::Array>() : nullptr;
  if (values == nullptr) return;
  for (const Node& value : *values) {
    if (const auto* other = value.as<std::string>()) materials_.push_back(*other);
  }
}

const Key* Reader::find_key(std::string_view path) const {
  for (const std::string& material : materials_) {
    if (const Key* key = schema_.find(path, material)) return key;
  }
  return nullptr;
}

const Key& Reader::key(std::string_view path) const {
  const Key* key = find_key(path);
  if (key == nullptr) throw std::logic_error("key not declared: " + std::string(path));
  return *key;
}

const Node* Reader::node(std::string_view path) const { return find_value(root_, path); }

bool Reader::is_word(const std::string& path, std::string_view word) const {
  const Node* given = node(path);
  const auto* text = given != nullptr ? given->as<std::string>() : nullptr;
  return text != nullptr && *text == word;
}

void Reader::complain(const std::string& path, std::string problem, std::string advice) {
  Issue issue{path, "", std::move(problem), std::move(advice), root_.file, 0};
  for (std::string at = path; !at.empty();
       at.resize(at.find_last_of(".[") == std::string::npos ? 0 : at.find_last_of(".["))) {
    if (const Node* found = node(at)) {
      if (at == path && (found->as<Node::Table>() == nullptr || path.ends_with(']'))) issue.value = found->text();
      issue.file = found->file;
      issue.line = found->line;
      break;
    }
  }
  issues_.push_back(std::move(issue));
}

void Reader::complain(const InvalidInput& error) {
  for (const Issue& issue : error.issues()) {
    const std::string value = issue.value;
    complain(issue.key, issue.problem, issue.advice);
    if (issues_.back().value.empty()) issues_.back().value = value;
  }
}

std::optional<double> Reader::scalar(const std::string& path, const Key& key, const Node& given) {
  double value = 0;
  if (key.kind == ValueKind::quantity || key.kind == ValueKind::quantity_list) {
    const auto* exact = given.as<Node::Quantity>();
    const auto* text = given.as<std::string>();
    if (exact == nullptr && text == nullptr) {
      const bool bare = given.as<double>() != nullptr || given.as<std::int64_t>() != nullptr;
      complain(path, bare ? "missing unit" : "is " + std::string(given.type_name()) + ", not a number with a unit",
               bare ? "write \"" + given.text() + " " + key.unit + "\", or another unit of that dimension"
                    : "write \"1 " + key.unit + "\", or another unit of that dimension");
      return std::nullopt;
    }
    try {
      value = exact != nullptr ? exact->value : parse_quantity(*text, key.unit);
    } catch (const InvalidInput& error) {
      const Issue& issue = error.issues().front();
      complain(path, issue.problem, issue.advice + (key.choices.empty() ? "" : ", or " + choices_text(key.choices)));
      return std::nullopt;
    }
  } else if (const auto* number = given.as<double>()) {
    value = *number;
  } else if (const auto* integer = given.as<std::int64_t>()) {
    value = static_cast<double>(*integer);
  } else {
    const std::string words = key.choices.empty() ? "" : ", or " + choices_text(key.choices);
    complain(path, "is " + std::string(given.type_name()) + ", not a plain number",
             "write a number without quotes" + words);
    return std::nullopt;
  }
  if (!std::isfinite(value)) {
    complain(path, "not a finite number");
    return std::nullopt;
  }
  if (!key.range.contains(value)) {
    complain(path, "out of range", "allowed is " + key.range.text(key.unit));
    return std::nullopt;
  }
  return value;
}

namespace {
template <class Number>
Number number_from(const std::string& text) {
  Number value{};
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The default of a key as a node.
Node fallback_node(const Key& key) {
  if (key.kind == ValueKind::number) return Node{number_from<double>(key.fallback), "", 0};
  if (key.kind == ValueKind::integer) return Node{number_from<std::int64_t>(key.fallback), "", 0};
  return Node{key.fallback, "", 0};
}
}  // namespace

std::optional<double> Reader::number(const std::string& path) {
  const Key& declared = key(path);
  const Node* given = node(path);
  if (given == nullptr && declared.fallback.empty()) {
    if (declared.required) complain(path, "missing", "give the " + declared.meaning);
    return std::nullopt;
  }
  const std::optional<double> value =
      given != nullptr ? scalar(path, declared, *given) : scalar(path, declared, fallback_node(declared));
  if (value) resolve(path, [&] { return toml_quantity(*value, declared.unit); });
  return value;
}

std::optional<double> Reader::number_like(const std::string& path, const Key& like) {
  const Node* given = node(path);
  if (given == nullptr) {
    complain(path, "missing");
    return std::nullopt;
  }
  return scalar(path, like, *given);
}

std::optional<long> Reader::integer(const std::string& path) {
  const Key& declared = key(path);
  const Node* given = node(path);
  if (given == nullptr && declared.fallback.empty()) return std::nullopt;
  const Node fallback = given != nullptr ? Node{} : fallback_node(declared);
  const Node& source = given != nullptr ? *given : fallback;
  const auto* value = source.as<std::int64_t>();
  if (value == nullptr) {
    complain(path, "is " + std::string(source.type_name()) + ", not an integer");
    return std::nullopt;
  }
  if (!declared.range.contains(static_cast<double>(*value))) {
    complain(path, "out of range", "allowed is " + declared.range.text("1"));
    return std::nullopt;
  }
  resolve(path, [&] { return std::to_string(*value); });
  return static_cast<long>(*value);
}

std::optional<bool> Reader::boolean(const std::string& path) {
  const Key& declared = key(path);
  const Node* given = node(path);
  const bool fallback = declared.fallback == "true";
  const bool* value = given != nullptr ? given->as<bool>() : &fallback;
  if (value == nullptr) {
    complain(path, "is " + std::string(given->type_name()) + ", not true or false");
    return std::nullopt;
  }
  resolve(path, [&] { return std::string(*value ? "true" : "false"); });
  return *value;
}

std::optional<std::string> Reader::text(const std::string& path) {
  const Key& declared = key(path);
  const Node* given = node(path);
  if (given == nullptr && declared.fallback.empty()) {
    if (declared.required) {
      complain(path, "missing",
               declared.choices.empty() ? "give the " + declared.meaning : "one of " + choices_text(declared.choices));
    }
    return std::nullopt;
  }
  const std::string* value = given != nullptr ? given->as<std::string>() : &declared.fallback;
  if (value == nullptr) {
    complain(path, "is " + std::string(given->type_name()) + ", not a string");
    return std::nullopt;
  }
  if (!declared.choices.empty() && !contains(declared.choices, *value)) {
    complain(path, "unknown name", "one of " + choices_text(declared.choices));
    return std::nullopt;
  }
  resolve(path, [&] { return toml_string(*value); });
  return *value;
}

std::optional<std::vector<double>> Reader::list(const std::string& path) {
  const Key& declared = key(path);
  const Node* given = node(path);
  if (given == nullptr) {
    if (declared.required) complain(path, "missing", "give the " + declared.meaning);
    return std::nullopt;
  }
  const auto* array = given->as<Node::Array>();
  if (array == nullptr) {
    complain(path, "is " + std::string(given->type_name()) + ", not a list");
    return std::nullopt;
  }
  if (array->empty()) {
    complain(path, "is empty");
    return std::nullopt;
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const auto value = scalar(path + "[" + std::to_string(i) + "]", declared, (*array)[i]);
    if (value) values.push_back(*value);
  }
  if (values.size() != array->size()) return std::nullopt;
  resolve(path, [&] { return toml_list(values, declared.unit); });
  return values;
}

std::optional<std::vector<std::string>> Reader::texts(const std::string& path) {
  const Key& declared = key(path);
  const Node* given = node(path);
  if (given == nullptr) return std::nullopt;
  const auto* array = given->as<Node::Array>();
  if (array == nullptr) {
    complain(path, "is " + std::string(given->type_name()) + ", not a list");
    return std::nullopt;
  }
  std::vector<std::string> values;
  std::string toml;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const auto* value = (*array)[i].as<std::string>();
    const std::string place = path + "[" + std::to_string(i) + "]";
    if (value == nullptr) {
      complain(place, "is " + std::string((*array)[i].type_name()) + ", not a string");
    } else if (!declared.choices.empty() && !contains(declared.choices, *value)) {
      complain(place, "unknown name", "one of " + choices_text(declared.choices));
    } else {
      values.push_back(*value);
      toml += (toml.empty() ? "" : ", ") + toml_string(*value);
    }
  }
  resolve(path, [&] { return "[" + toml + "]"; });
  return values;
}

void Reader::check_unknown() { check_unknown(root_, ""); }

void Reader::check_unknown(const Node& node, const std::string& path) {
  if (const auto* table = node.as<Node::Table>()) {
    for (const auto& entry : *table) check_entry(entry.node, path.empty() ? entry.key : path + "." + entry.key);
  } else if (const auto* array = node.as<Node::Array>()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string item = path + "[" + std::to_string(i) + "]";
      if ((*array)[i].as<Node::Table>() == nullptr) {
        complain(item, "is " + std::string((*array)[i].type_name()) + ", not a table");
      } else {
        check_unknown((*array)[i], item);
      }
    }
  }
}

void Reader::check_entry(const Node& child, const std::string& path) {
  const Key* known = find_key(path);
  if (known == nullptr && !schema_.has_below(path)) {
    complain_unknown(path);
    return;
  }
  const ValueKind kind = known != nullptr ? known->kind : ValueKind::table;
  if ((kind == ValueKind::table || kind == ValueKind::free_table) && child.as<Node::Table>() == nullptr) {
    complain(path, "is " + std::string(child.type_name()) + ", not a table");
  } else if (kind == ValueKind::table_list && child.as<Node::Array>() == nullptr) {
    complain(path, "is " + std::string(child.type_name()) + ", not a list of tables");
  } else if (kind == ValueKind::table || kind == ValueKind::table_list) {
    check_unknown(child, path);
  }
}

void Reader::complain_unknown(const std::string& path) {
  std::string advice;
  for (const Key& key : schema_.keys()) {
    if (key.path == path) advice += (advice.empty() ? "it belongs to the model " : ", ") + key.only_with;
  }
  const std::string problem = advice.empty() ? "unknown key" : "not a key of this material";
  const std::string near = schema_.nearest(path, materials_.front());
  if (!near.empty()) advice += (advice.empty() ? "" : "; ") + ("did you mean " + near + "?");
  complain(path, problem, advice);
}

void Reader::record(const std::string& path, std::string toml) {
  const auto found = std::ranges::find(resolved_, path, &std::pair<std::string, std::string>::first);
  if (found != resolved_.end()) {
    found->second = std::move(toml);
  } else {
    resolved_.emplace_back(path, std::move(toml));
  }
}

std::string Reader::resolved() const {
  std::string out;
  const auto write = [&](const std::string& table) {
    std::string lines;
    for (const auto& [path, toml] : resolved_) {
      const std::size_t dot = path.find('.');
      const std::string parent = dot == std::string::npos ? "" : path.substr(0, dot);
      const std::string name = dot == std::string::npos ? path : path.substr(dot + 1);
      if (parent != table || name.find_first_of(".[") != std::string::npos) continue;  // parts of a value written whole
      lines += name + " = " + toml + "\n";
    }
    if (lines.empty()) return;
    if (!table.empty()) out += "\n[" + table + "]\n";
    out += lines;
  };
  write("");
  for (const auto& table : schema_.tables()) {
    if (!table.name.empty() && table.name.find('.') == std::string::npos) write(table.name);
  }
  return out;
}

}  // namespace turgor
