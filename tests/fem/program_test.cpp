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

}  // namespace
}  // namespace turgor
