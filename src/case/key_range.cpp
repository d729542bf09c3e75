#include "turgor/case/key_range.hpp"

#include <charconv>
#include <cmath>

#include "turgor/case/units.hpp"

namespace turgor {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(' ');
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

double read_value(const Key& key, const std::string& path, std::string_view given) {
  const std::string text(trimmed(given));
  double value = 0;
  if (key.kind == ValueKind::quantity) {
    value = parse_argument(path, text, key.unit);
  } else {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
      throw InvalidInput(path, "\"" + text + "\"", "is not a finite number", "write for example 1.5");
    }
  }
  if (!key.range.contains(value)) {
    throw InvalidInput(path, "\"" + text + "\"", "out of range", "allowed is " + key.range.text(key.unit));
  }
  return value;
}

/// The declaration of a key that a range can be given for.
Key ranged_key(const Case& c, const std::string& option, const std::string& path) {
  const std::string table = path.substr(0, path.find('.'));
  if (table == "sweep" || table == "output" || table == "expect" || table == "solve" || table == "initial" ||
      table == "fem" || table == "wall") {
    throw InvalidInput(option, path, "has no influence on states of rest", "give a key of the balloon or its pressure");
  }
  const Key* found = case_schema().find(path, c.material_name);
  if (found == nullptr) {
    const std::string near = case_schema().nearest(path, c.material_name);
    throw InvalidInput(option, path, "no such key in this case", near.empty() ? "" : "did you mean \"" + near + "\"?");
  }
  if (found->kind != ValueKind::quantity && found->kind != ValueKind::number) {
    throw InvalidInput(option, path, "does not take a number", "give a key that takes a quantity or a number");
  }
  Node places = *c.tree;
  try {
    static_cast<void>(place_value(places, path));
  } catch (const InvalidInput& error) {
    throw InvalidInput(option, path, error.issues().front().problem, "give a key that the case can have");
  }
  return *found;
}

}  // namespace

KeyRange read_key_range(const Case& c, const std::string& option, std::string_view text) {
  const std::string example = "write " + option + " 'material.s1=1 MPa:2 MPa'";
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':', equals == std::string_view::npos ? 0 : equals);
  if (equals == std::string_view::npos || colon == std::string_view::npos ||
      text.find(':', colon + 1) != std::string_view::npos) {
    throw InvalidInput(option, "\"" + std::string(text) + "\"", "is not of the form KEY=FROM:TO", example);
  }
  const std::string path(trimmed(text.substr(0, equals)));
  const Key key = ranged_key(c, option, path);
  KeyRange range{path, key.unit, read_value(key, path, text.substr(equals + 1, colon - equals - 1)),
                 read_value(key, path, text.substr(colon + 1))};
  if (!(range.from < range.to)) {
    throw InvalidInput(option, "\"" + std::string(text) + "\"", "FROM must be less than TO", example);
  }
  return range;
}

Node node_of(const KeyRange& range, double value) {
  if (range.unit == "1") return {value, "", 0};
  return {Node::Quantity{value, range.unit}, "", 0};
}

}  // namespace turgor
