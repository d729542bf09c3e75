#pragma once
// Reads values out of a parsed case by its schema, and collects everything that is wrong on the way.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "turgor/base/errors.hpp"
#include "turgor/case/node.hpp"
#include "turgor/case/schema.hpp"

namespace turgor {

class Reader {
 public:
  /// @param root  the parsed case, with its overrides; both must outlive the reader
  /// @param keeps_resolved  whether resolved() is wanted
  Reader(const Schema& schema, const Node& root, bool keeps_resolved = true);

  // Each takes a path that the schema declares and returns its value in SI units, or its default. Nothing is returned
  // when the key is absent without a default, or wrong; in the latter case, and when a required key is absent, an issue
  // is kept.
  [[nodiscard]] std::optional<double> number(const std::string& path);
  [[nodiscard]] std::optional<long> integer(const std::string& path);
  [[nodiscard]] std::optional<bool> boolean(const std::string& path);
  [[nodiscard]] std::optional<std::string> text(const std::string& path);
  [[nodiscard]] std::optional<std::vector<double>> list(const std::string& path);
  [[nodiscard]] std::optional<std::vector<std::string>> texts(const std::string& path);

  /// The number at a path that need not be declared, read as if it stood at another key: unit and range are that key's.
  [[nodiscard]] std::optional<double> number_like(const std::string& path, const Key& like);
  /// The declared key at a path for the materials in play: that of the case, and those that a sweep puts in its place.
  [[nodiscard]] const Key* find_key(std::string_view path) const;

  [[nodiscard]] const Node& root() const { return root_; }
  /// The declared key that is spelled most like this one; empty when none is near.
  [[nodiscard]] std::string nearest(std::string_view path) const { return schema_.nearest(path, materials_.front()); }

  /// The value as written, or nothing; also says whether a key was given at all.
  [[nodiscard]] const Node* node(std::string_view path) const;
  /// Whether a number key was given as this word instead ("equilibrium").
  [[nodiscard]] bool is_word(const std::string& path, std::string_view word) const;

  /// Keeps an issue about a key, located where the key stands (or where its nearest table does).
  void complain(const std::string& path, std::string problem, std::string advice = {});
  /// Keeps the issues of a lower room, locating those whose keys stand in the case.
  void complain(const InvalidInput& error);
  [[nodiscard]] const std::vector<Issue>& issues() const { return issues_; }

  /// Complains about every key that no part of the program knows.
  void check_unknown();

  /// Replaces or adds a value of the resolved case; plain keys are recorded as they are read.
  /// @param toml  returns the value as TOML text; called only when the resolved case is wanted
  template <class Toml>
  void resolve(const std::string& path, const Toml& toml) {
    if (keeps_resolved_) record(path, toml());
  }
  /// The resolved case: every key that was read, defaults filled, in SI units, numbers that read back exactly.
  [[nodiscard]] std::string resolved() const;

 private:
  [[nodiscard]] const Key& key(std::string_view path) const;
  std::optional<double> scalar(const std::string& path, const Key& key, const Node& given);
  void check_unknown(const Node& node, const std::string& path);
  void check_entry(const Node& child, const std::string& path);
  void complain_unknown(const std::string& path);
  void record(const std::string& path, std::string toml);

  const Schema& schema_;
  const Node& root_;
  bool keeps_resolved_;
  std::vector<std::string> materials_;  ///< in play; that of the case first
  std::vector<Issue> issues_;
  std::vector<std::pair<std::string, std::string>> resolved_;
};

/// A string as TOML writes it.
[[nodiscard]] std::string toml_string(std::string_view text);
/// A value in an SI unit as TOML writes it: "0.3 m", or the bare number when the unit is 1.
[[nodiscard]] std::string toml_quantity(double value, const std::string& unit);
[[nodiscard]] std::string toml_list(const std::vector<double>& values, const std::string& unit);

}  // namespace turgor
