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
  Reader(const Schema& schema, const Node& root);

  // Each takes a path that the schema declares and returns its value in SI units, or its default. Nothing is returned
  // when the key is absent without a default, or wrong; in the latter case, and when a required key is absent, an issue
  // is kept.
  [[nodiscard]] std::optional<double> number(const std::string& path);
  [[nodiscard]] std::optional<long> integer(const std::string& path);
  [[nodiscard]] std::optional<bool> boolean(const std::string& path);
  [[nodiscard]] std::optional<std::string> text(const std::string& path);
  [[nodiscard]] std::optional<std::vector<double>> list(const std::string& path);

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

  /// Replaces or adds a value of the resolved case, as TOML text; plain keys are recorded as they are read.
  void resolve(const std::string& path, const std::string& toml);
  /// The resolved case: every key that was read, defaults filled, in SI units, numbers that read back exactly.
  [[nodiscard]] std::string resolved() const;

 private:
  [[nodiscard]] const Key& key(std::string_view path) const;
  std::optional<double> scalar(const std::string& path, const Key& key, const Node& given);
  void check_unknown(const Node& node, const std::string& path);
  void check_entry(const Node& child, const std::string& path);
  void complain_unknown(const std::string& path);
  [[nodiscard]] std::string material() const;

  const Schema& schema_;
  const Node& root_;
  std::vector<Issue> issues_;
  std::vector<std::pair<std::string, std::string>> resolved_;
};

/// A string as TOML writes it.
[[nodiscard]] std::string toml_string(std::string_view text);
/// A value in an SI unit as TOML writes it: "0.3 m", or the bare number when the unit is 1.
[[nodiscard]] std::string toml_quantity(double value, const std::string& unit);

}  // namespace turgor
