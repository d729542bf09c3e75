#include "turgor/case/profile.hpp"

#include "csv_table.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr const char* key = "profile";

/// What read_csv says, under the key that every issue of a profile has.
std::vector<CsvColumn> read_columns(const std::filesystem::path& file) {
  try {
    return read_csv(file, {{"1", "m"}, {"1", "m/s"}});
  } catch (const InvalidInput& error) {
    const Issue& issue = error.issues().front();
    throw InvalidInput(key, issue.value, issue.problem, issue.advice);
  }
}

InvalidInput wrong_row(const std::filesystem::path& file, std::size_t index, std::string problem, std::string advice) {
  constexpr std::size_t first = 2;  // below the header
  return InvalidInput(key, file.string() + ", row " + std::to_string(index + first), std::move(problem),
                      std::move(advice));
}

/// Distances from the axis over that of the last row, which for dimensionless ones has to be 1.
std::vector<double> upsilon_of(const std::filesystem::path& file, const CsvColumn& column) {
  std::vector<double> distance = column.values;
  for (std::size_t i = 1; i < distance.size(); ++i) {
    if (distance[i] <= distance[i - 1]) {
      throw wrong_row(file, i, "distances from the axis must increase strictly", "sort the rows");
    }
  }
  if (distance.front() != 0) {
    throw wrong_row(file, 0, "the profile must begin on the axis", "the first distance is 0");
  }
  const std::size_t last = distance.size() - 1;
  if (column.unit != "m" && distance.back() != 1) {
    throw wrong_row(file, last, "ends at Upsilon = " + shortest(distance.back()) + " instead of at the rim",
                    "the last Upsilon is 1; a length in mm or m is divided by that of the last row");
  }
  const double radius = distance.back();
  for (double& x : distance) x /= radius;
  distance[last] = 1;
  return distance;
}

}  // namespace

ProfileTable read_profile_table(const std::filesystem::path& file) {
  std::vector<CsvColumn> columns = read_columns(file);
  std::vector<double> upsilon = upsilon_of(file, columns[0]);
  return {std::move(upsilon), std::move(columns[1].values)};
}

OutflowProfile read_profile(const std::filesystem::path& file) {
  const ProfileTable table = read_profile_table(file);
  try {
    return OutflowProfile::table(table.upsilon, table.velocity);
  } catch (const InvalidInput& error) {
    const Issue& issue = error.issues().front();
    throw InvalidInput(key, file.string(), issue.value + ": " + issue.problem, issue.advice);
  }
}

}  // namespace turgor
