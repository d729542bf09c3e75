#pragma once
// Tables of numbers in CSV files with units in their headers.

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {

/// Columns of numbers, in SI units.
using CsvTable = std::vector<std::vector<double>>;

/// Reads a CSV file whose first row names its columns with their units: "t [s],p [kPa]".
/// @param units  SI unit of each column; their number is the number of columns the file must have
/// @throws InvalidInput (without a key) naming file and row
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& file, const std::vector<std::string>& units);

}  // namespace turgor
