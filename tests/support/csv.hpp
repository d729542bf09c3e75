#pragma once
// Reads the tables that the program writes.

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "program.hpp"

namespace turgor::test {

class Csv {
 public:
  explicit Csv(const std::filesystem::path& file) {
    std::istringstream stream(contents(file));
    std::string line;
    std::getline(stream, line);
    names_ = fields(line);
    while (std::getline(stream, line)) rows_.push_back(fields(line));
  }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const {
    const auto found = std::ranges::find(names_, column);
    if (found == names_.end()) throw std::out_of_range("no column " + column);
    return rows_.at(row).at(static_cast<std::size_t>(found - names_.begin()));
  }
  [[nodiscard]] bool empty(std::size_t row, const std::string& column) const { return text(row, column).empty(); }
  [[nodiscard]] double operator()(std::size_t row, const std::string& column) const {
    return std::stod(text(row, column));
  }

 private:
  static std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> all(1);
    for (const char c : line) {
      if (c == ',') {
        all.emplace_back();
      } else {
        all.back() += c;
      }
    }
    return all;
  }

  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace turgor::test
