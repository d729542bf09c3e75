#pragma once
// The keys of a case file. Every part of the program declares its own; reading, checking, `turgor doc` and the resolved
// case all follow from the declaration.

#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace turgor {

enum class ValueKind {
  quantity,
  number,
  integer,
  boolean,
  text,
  quantity_list,
  number_list,
  text_list,
  table,
  table_list,
  free_table,  ///< a table whose keys are not declared; the part that reads it checks them
};

/// "quantity", "list of numbers", ...
[[nodiscard]] std::string_view name_of(ValueKind kind);

/// Allowed values of a number, in the SI unit of its key.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool open_least = false;  ///< `least` itself is not allowed

  [[nodiscard]] bool contains(double value) const {
    return (open_least ? value > least : value >= least) && value <= greatest;
  }
  [[nodiscard]] bool is_everything() const;
  /// "> 0 m", "from 2 to 1e7", ...
  [[nodiscard]] std::string text(const std::string& unit) const;
};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false};

/// One key of a case file.
struct Key {
  std::string path;  ///< "inlet.orifice_radius"; elements of a list of tables are written "pressure.segments[].to"
  ValueKind kind = ValueKind::quantity;
  std::string unit = "1";  ///< SI unit of a quantity
  Range range{};
  std::vector<std::string> choices{};  ///< allowed texts; for a number, words allowed in its place
  std::string fallback{};              ///< default as it would be written; empty when there is none
  bool required = false;
  std::string only_with{};  ///< material model that has this key; empty: always there
  std::string meaning{};
};

/// All keys, in the order in which they are declared.
class Schema {
 public:
  void add(Key key);
  /// A table's own line in the documentation.
  void describe(std::string table, std::string meaning) { tables_.push_back({std::move(table), std::move(meaning)}); }

  struct Table {
    std::string name;
    std::string meaning;
  };
  [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
  [[nodiscard]] const std::vector<Table>& tables() const { return tables_; }

  /// The key at a path (list indices allowed), for the given material model; nothing when there is none.
  [[nodiscard]] const Key* find(std::string_view path, std::string_view material = {}) const;
  /// Whether some key lies below this path.
  [[nodiscard]] bool has_below(std::string_view path) const;
  /// The name among a path's neighbours that is spelled most like it; empty when none is near.
  [[nodiscard]] std::string nearest(std::string_view path, std::string_view material) const;

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };

  std::vector<Key> keys_;
  std::unordered_map<std::string, std::vector<std::size_t>, Hash, std::equal_to<>> by_path_;
  std::vector<Table> tables_;
};

/// "inlet" of "inlet.orifice_radius"; empty for a key outside tables.
[[nodiscard]] std::string table_of(const Key& key);

/// The keys of a table, or all, as a JSON array: key, type, unit, range, choices, default, required,
/// only_with_material, meaning.
[[nodiscard]] std::string schema_json(const Schema& schema, std::string_view table = {});

/// "pressure.segments[2].to" -> "pressure.segments[].to"
[[nodiscard]] std::string without_indices(std::string_view path);

}  // namespace turgor
