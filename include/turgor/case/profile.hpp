#pragma once
// Outflow profiles (2.13) from files.

#include <filesystem>
#include <vector>

#include "turgor/flow/outflow_profile.hpp"

namespace turgor {

/// Reads a measured or computed profile from a CSV file of two columns with their units in the header: the distance
/// from the axis, "Upsilon [1]" from 0 to 1 or a length such as "radius [mm]" up to the orifice's radius in the last
/// row, and the axial velocity, "f [1]" or such as "velocity [m/s]", positive out of the balloon. Velocities are
/// normalised.
/// @throws InvalidInput (key "profile") naming the file, and the row where there is one
[[nodiscard]] OutflowProfile read_profile(const std::filesystem::path& file);

/// The same as points of OutflowProfile::table().
struct ProfileTable {
  std::vector<double> upsilon;
  std::vector<double> velocity;  ///< as given, in its SI unit

  bool operator==(const ProfileTable&) const = default;
};
/// @throws InvalidInput as read_profile(), but for what makes points no profile
[[nodiscard]] ProfileTable read_profile_table(const std::filesystem::path& file);

}  // namespace turgor
