#pragma once
// A table on disk that grows by whole rows.

#include <cstdint>
#include <filesystem>
#include <string>

namespace turgor {

/// A CSV file with a header. Each row is one write of the system, so that what was appended outlives the process.
/// The file is locked: a second process that would add to it is refused.
class TableFile {
 public:
  /// Begins a table, or goes on with the first `rows` rows of an existing one, cutting off what comes after.
  /// @throws InvalidInput when another process has it, or the existing one is not this table or has too few rows
  /// @throws ComputationFailed when it cannot be written
  TableFile(std::filesystem::path file, const std::string& header, bool existing, std::uint64_t rows);
  ~TableFile();
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;
  TableFile(TableFile&&) = delete;
  TableFile& operator=(TableFile&&) = delete;

  /// @param row  without the end of the line
  void append(const std::string& row);
  /// What was appended outlives a loss of power from here on.
  void sync() const;
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

 private:
  void write(const std::string& text) const;
  /// Size in bytes of the header and so many rows.
  [[nodiscard]] std::uintmax_t size_of(std::uint64_t rows, const std::string& header) const;

  std::filesystem::path path_;
  int file_;
  std::uint64_t rows_;
};

}  // namespace turgor
