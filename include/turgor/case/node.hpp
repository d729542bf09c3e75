#pragma once
// A parsed case file: a tree of values that know where they stand.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace turgor {

/// One value of a case file.
struct Node {
  struct Entry;
  using Array = std::vector<Node>;
  using Table = std::vector<Entry>;  ///< in the order of the file

  /// A value of a type that no key takes, such as a date; holds its TOML text.
  struct Other {
    std::string text;
  };

  /// A number in an SI unit, as programs put it in place of a text like "30 cm".
  struct Quantity {
    double value;
    std::string unit;
  };

  std::variant<Table, Array, std::string, std::int64_t, double, bool, Other, Quantity> value;
  std::string file;  ///< "--set" for an override
  int line = 0;

  template <class Type>
  [[nodiscard]] const Type* as() const {
    return std::get_if<Type>(&value);
  }
  /// The entry of a table, or nothing.
  [[nodiscard]] const Node* find(std::string_view key) const;
  /// As it would be written in a file, shortened when long.
  [[nodiscard]] std::string text() const;
  /// "a table", "a string", ...
  [[nodiscard]] std::string_view type_name() const;
};

/// One line of a table.
struct Node::Entry {
  std::string key;
  Node node;
};

/// Parses TOML text.
/// @param file  name for messages
/// @throws InvalidInput with file and line when it is not valid TOML
[[nodiscard]] Node parse_toml(std::string_view text, const std::string& file);

/// The place of a value: "inlet.orifice_radius", "pressure.segments[0].to"; a key that has dots itself is quoted, as in
/// TOML: sweep.axes."inlet.orifice_radius".n. Nothing when there is none.
[[nodiscard]] const Node* find_value(const Node& root, std::string_view path);

/// A value that differs between two trees.
struct NodeDifference {
  std::string path;
  const Node* first;  ///< in the trees; null where the key is missing
  const Node* second;
};
/// The first one in the order of the trees.
/// @param ignored  paths that may differ, with all below them
[[nodiscard]] std::optional<NodeDifference> first_difference(const Node& first, const Node& second,
                                                             std::span<const std::string> ignored);

/// As find_value(), where missing keys are added as empty tables.
/// @throws InvalidInput (without a key) when the path has no key, or runs through something that is not a table or list
[[nodiscard]] Node& place_value(Node& root, std::string_view path);

/// Replaces or adds one value: "inlet.orifice_radius=2 cm", "pressure.segments[0].to=30 kPa". What is right of the
/// equals sign is read as TOML where it is valid TOML (numbers, true, arrays, quoted strings) and as a bare string
/// otherwise.
/// @throws InvalidInput when the text has no key, or the path runs through something that is not a table or list
void apply_override(Node& root, std::string_view assignment);

}  // namespace turgor
