#pragma once
// For tests that use deal.II and PETSc: both run while the tests do.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "turgor/fem/session.hpp"

namespace turgor {

class FemEnvironment : public testing::Environment {
 public:
  void SetUp() override { session_ = std::make_unique<FemSession>(); }
  void TearDown() override { session_.reset(); }

 private:
  std::unique_ptr<FemSession> session_;
};

inline const auto* const fem_environment = testing::AddGlobalTestEnvironment(new FemEnvironment);  // NOLINT: gtest's

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
