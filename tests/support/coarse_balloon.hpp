#pragma once
// A balloon for runs by finite elements that take seconds.

#include <string>

namespace turgor {

/// The paper's 30 cm balloon with an orifice of 3 cm, on a mesh of 400 cells.
/// @param program  tables that move it: [motion], or [pressure] and [initial]
/// @param more     further keys of [fem], further tables
inline std::string coarse_balloon(const std::string& program, const std::string& more = "",
                                  const std::string& channel = "0 cm") {
  return R"(
title = "test"
[balloon]
radius = "30 cm"
thickness = "3 mm"
density = "1000 kg/m^3"
[material]
model = "mooney-rivlin"
s1 = "1.5 MPa"
s2 = "0.15 MPa"
[fluid]
density = "1000 kg/m^3"
viscosity = "8.94e-4 Pa s"
[inlet]
orifice_radius = "3 cm"
channel_length = ")" +
         channel + "\"\n" + program + R"(
[fem]
h_rim = "2 mm"
h_orifice = "5 mm"
h_wall = "25 mm"
)" + more;
}

}  // namespace turgor
