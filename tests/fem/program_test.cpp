// turgor fem, as a user calls it.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../support/fem.hpp"
#include "../support/program.hpp"

namespace turgor {
namespace {

using test::Folder;
using test::turgor;

TEST(FemProgram, KnowsItsLibraries) {
  const Folder folder;
  const auto versions = turgor(folder, {"fem", "versions", "--json"});
  ASSERT_EQ(versions.code, 0) << versions.err;
  const auto document = nlohmann::json::parse(versions.out);
  for (const auto& [library, number] : fem_versions()) EXPECT_EQ(document.at(library), number);
  EXPECT_EQ(document.size(), 3U);
}

TEST(FemProgram, ExplainsBadInput) {
  const Folder folder;
  const std::string free = (std::filesystem::path(TURGOR_CASES) / "orifice-30mm.toml").string();
  const auto run = turgor(folder, {"fem", "flow", free, "-o", "run"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("no [motion] table"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
  EXPECT_EQ(turgor(folder, {"fem"}).code, 2);
}

TEST(FemProgram, TheWallAtRest) {
  const Folder folder;
  const std::string balloon = (std::filesystem::path(TURGOR_CASES) / "coupled-orifice-30mm.toml").string();
  const auto statics = turgor(folder, {"fem", "statics", balloon, "--up-to", "1.6", "--json"});
  ASSERT_EQ(statics.code, 0) << statics.err;
  EXPECT_EQ(nlohmann::json::parse(statics.out).at("limit_points").size(), 1U);
  EXPECT_EQ(turgor(folder, {"fem", "statics", balloon, "--up-to", "0.5"}).code, 2);
}

// A coarse run through a short deflation. There the corrected closure is known to be some 10 % below finite elements
// and the theoretical one 1.56 times further down; the mode and the mean pressure differ by 0.4 kappa^2 = 0.4 % and
// viscosity.
TEST(FemProgram, ARunIsVerified) {
  const Folder folder;
  const std::string motion = (std::filesystem::path(TURGOR_CASES) / "motion-orifice-30mm.toml").string();
  const std::vector<std::string> settings{
      "--set", "motion.velocity=[{ to = \"-2 cm/s\", over = \"60 ms\", shape = \"smooth\" }, { hold = \"40 ms\" }]",
      "--set", "solve.samples=11",
      "--set", "fem.h_rim=2 mm",
      "--set", "fem.h_orifice=6 mm",
      "--set", "fem.h_wall=24 mm",
      "--set", "fem.fields=0",
      "--set", "fem.cfl=1"};
  std::vector<std::string> compute{"fem", "flow", motion, "-q"};
  compute.insert(compute.end(), settings.begin(), settings.end());
  const auto run = turgor(folder, compute);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto verified = turgor(folder, {"verify", motion, settings[0], settings[1], "--json", "--no-pictures"});
  ASSERT_EQ(verified.code, 0) << verified.err;
  const auto report = nlohmann::json::parse(verified.out);
  EXPECT_EQ(report.at("finite_elements").at("rows"), 11);
  EXPECT_GT(report.at("finite_elements").at("discretisation").at("cells"), 100);
  const auto ratio = [&](const char* force, const char* closure) {
    return report.at(force).at("even_deflation_ratio_minus_1").at(closure).at("mean").get<double>();
  };
  EXPECT_NEAR(ratio("force_mode", "corrected"), -0.1, 0.1);
  EXPECT_NEAR((1 + ratio("force_mode", "theoretical")) / (1 + ratio("force_mode", "corrected")), 0.64, 1e-12);
  EXPECT_NEAR((1 + ratio("force", "corrected")) / (1 + ratio("force_mode", "corrected")), 1, 0.01);
}

}  // namespace
}  // namespace turgor
