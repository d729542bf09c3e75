#pragma once
// A NetCDF-4 file being written, through the C library; every failure is thrown.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace turgor {

class NetcdfFile {
 public:
  struct Dimension {
    int id;
    std::size_t length;
  };
  struct Variable {
    int id;
    std::vector<std::size_t> shape;
  };

  /// Creates the file, replacing one that is there.
  /// @throws ComputationFailed, as do all others
  explicit NetcdfFile(std::filesystem::path file);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  NetcdfFile(NetcdfFile&&) = delete;
  NetcdfFile& operator=(NetcdfFile&&) = delete;

  [[nodiscard]] Dimension dimension(const std::string& name, std::size_t length);

  // Variables; each element must be written, nothing is filled beforehand.
  [[nodiscard]] Variable doubles(const std::string& name, const std::vector<Dimension>& dimensions);
  [[nodiscard]] Variable bytes(const std::string& name, const std::vector<Dimension>& dimensions);
  [[nodiscard]] Variable integers(const std::string& name, const std::vector<Dimension>& dimensions);
  [[nodiscard]] Variable strings(const std::string& name, const std::vector<Dimension>& dimensions);

  /// Attributes of a variable, or of the file where there is none.
  void attribute(const Variable* variable, const std::string& name, const std::string& value);
  void attribute(const Variable* variable, const std::string& name, double value);
  void attribute(const Variable* variable, const std::string& name, std::int64_t value);
  void attribute(const Variable& variable, const std::string& name, const std::vector<signed char>& values);
  /// _FillValue of a variable of bytes or integers.
  void fill_value(const Variable& variable, signed char value);
  void fill_value(const Variable& variable, int value);

  // Elements first, first + 1, ... in the order of the file, the last dimension fastest.
  void put(const Variable& variable, std::size_t first, std::span<const double> values);
  void put(const Variable& variable, std::size_t first, std::span<const signed char> values);
  void put(const Variable& variable, std::size_t first, std::span<const int> values);
  void put(const Variable& variable, const std::vector<std::string>& values);

  /// Writes everything out to the disk and closes the file.
  void close();

 private:
  void check(int status) const;
  [[nodiscard]] Variable define(const std::string& name, int type, const std::vector<Dimension>& dimensions);

  std::filesystem::path path_;
  int id_ = -1;
};

}  // namespace turgor
