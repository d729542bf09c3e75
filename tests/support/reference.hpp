#pragma once
// The file of reference values.

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace turgor::test {

struct ReferenceValue {
  std::string name;
  nlohmann::json inputs;
  double value;
  double error_bound;

  [[nodiscard]] bool has(const char* key) const { return inputs.contains(key); }
  [[nodiscard]] double input(const char* key) const { return inputs.at(key).get<double>(); }
  [[nodiscard]] std::string text(const char* key) const { return inputs.at(key).get<std::string>(); }
  /// An input as its decimal text means it, to the last digit of long double.
  template <class T>
  [[nodiscard]] T exact(const char* key) const {
    return static_cast<T>(std::strtold(inputs.at(key).dump().c_str(), nullptr));
  }
};

/// All entries, grouped by name.
[[nodiscard]] inline const std::map<std::string, std::vector<ReferenceValue>>& reference() {
  static const auto entries = [] {
    std::map<std::string, std::vector<ReferenceValue>> all;
    std::ifstream stream(TURGOR_REFERENCE_FILE);
    for (const auto& entry : nlohmann::json::parse(stream)) {
      const std::string name = entry.at("name");
      all[name].push_back({name, entry.at("inputs"), entry.at("value"), entry.at("abs_err")});
    }
    return all;
  }();
  return entries;
}

}  // namespace turgor::test
