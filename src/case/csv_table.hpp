#pragma once
// Tables of numbers in CSV files with units in their headers.

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {

/// A column of numbers, in its SI unit.
struct CsvColumn {
  std::string unit;
  std::vector<double> values;
};

/// Reads a CSV file whose first row names its columns with their units: "t [s],p [kPa]".
/// @param units  for each column the SI units that it can have; of several dimensions, the header decides
/// @return the columns, as many as `units`; element i of each stands in row i + 2 of the file
/// @throws InvalidInput (without a key) naming file and row
[[nodiscard]] std::vector<CsvColumn> read_csv(const std::filesystem::path& file,
                                              const std::vector<std::vector<std::string>>& units);

/// A column to look for: "force_mode [N]" has this name and a unit like this.
struct CsvName {
  std::string name;
  std::string unit;  ///< SI
};

/// Some columns of a table that may still be growing.
struct CsvExtract {
  std::vector<std::vector<double>> columns;  ///< as looked for, in SI units; possibly without rows
  bool cut;                                  ///< the last line had no end, and was left out
};

/// Reads columns by their names, wherever they stand; others may hold anything.
/// @throws InvalidInput (without a key) naming file and row
[[nodiscard]] CsvExtract extract_csv(const std::filesystem::path& file, const std::vector<CsvName>& names);

}  // namespace turgor
