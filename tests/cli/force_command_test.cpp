// The force command and its directory, as a user meets them.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::shipped;
using test::turgor;

std::vector<std::vector<double>> rows_of(const fs::path& file) {
  std::istringstream stream(contents(file));
  std::string line;
  std::getline(stream, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
  }
  return rows;
}

TEST(ForceCommand, WritesItsDirectory) {
  const Folder folder;
  const auto result = turgor(folder, {"force", shipped("motion-channel-30mm")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("peak inflating"), std::string::npos);
  const fs::path directory = folder / "motion-channel-30mm.force";
  EXPECT_EQ(contents(directory / "case.toml"), contents(shipped("motion-channel-30mm")));
  EXPECT_TRUE(
      contents(directory / "force.csv")
          .starts_with("t [s],r [cm],drdt [cm/s],d2rdt2 [cm/s^2],kappa [1],regime,force_theoretical [N],"
                       "force_corrected [N],force_potential [N],force_calibrated [N],static [N],channel_inertial [N],"
                       "channel_centripetal [N],balloon_inertial [N],balloon_centripetal [N]\n0,30,0,0,0.1,1,"));
  const auto rows = rows_of(directory / "force.csv");
  ASSERT_EQ(rows.size(), 2001U);
  double greatest = 0;
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 15U);
    for (const double value : row) ASSERT_TRUE(std::isfinite(value));
    EXPECT_NEAR(row[4] * row[1], 3, 1e-14 * 3);                                         // kappa = r_ch/r
    EXPECT_NEAR(row[7], row[10] + row[11] + row[12] + row[13] + row[14], 1e-11 * 1e5);  // the case's own closure
    EXPECT_EQ(row[5], row[2] != 0 || row[0] == 0 || row[0] == 2.5 ? (row[0] < 2.5 ? 1 : -1) : 0) << row[0];
    greatest = std::max(greatest, row[7]);
  }
  EXPECT_EQ(rows.back()[0], 5);
  EXPECT_EQ(rows.back()[1], 30);

  const json document = json::parse(contents(directory / "force.json"));
  EXPECT_EQ(document.at("status"), "complete");
  EXPECT_EQ(document.at("motion").at("r_end_m"), 0.3);
  const double peak = document.at("forces").at("corrected").at("peak_deflating").at("force_N");
  EXPECT_NEAR(peak, greatest, 1e-5 * peak);
  EXPECT_NE(contents(directory / "force.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(contents(directory / "force.png").substr(1, 3), "PNG");
  for (const auto& entry : fs::directory_iterator(directory)) {
    EXPECT_NE(entry.path().extension(), ".part");
    EXPECT_NE(entry.path().extension(), ".log");
  }
}

TEST(ForceCommand, TheResolvedCaseGivesIdenticalBits) {
  for (const char* name : {"motion-orifice-10mm", "motion-channel-5mm"}) {
    const Folder folder;
    ASSERT_EQ(turgor(folder, {"force", shipped(name), "-o", "first", "--no-pictures", "-q"}).code, 0);
    ASSERT_EQ(turgor(folder, {"force", "first/resolved.toml", "-o", "second", "--no-pictures", "-q"}).code, 0);
    for (const char* file : {"force.csv", "force.json", "resolved.toml"}) {
      EXPECT_EQ(contents(folder / "first" / file), contents(folder / "second" / file)) << name << " " << file;
    }
  }
}

class ShippedMotion : public testing::TestWithParam<std::string> {};

TEST_P(ShippedMotion, RunsFromEndToEnd) {
  const Folder folder;
  const auto result = turgor(folder, {"force", shipped(GetParam()), "-o", "result"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(fs::exists(folder / "result" / "force.png"));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(TURGOR_CASES)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".toml" && name.starts_with("motion-")) all.push_back(name);
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, ShippedMotion, testing::ValuesIn(names()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(ForceCommand, RowsAndUnitsAreTheRequestedOnes) {
  const Folder folder;
  ASSERT_EQ(
      turgor(folder, {"force", shipped("motion-orifice-30mm"), "-o", "result", "--no-pictures", "-q", "--set",
                      "solve={times=[\"1 s\",\"3.5 s\"]}", "--set", "output={length_unit=\"mm\",time_unit=\"ms\"}"})
          .code,
      0);
  const std::string table = contents(folder / "result" / "force.csv");
  EXPECT_TRUE(table.starts_with("t [ms],r [mm],drdt [mm/ms],d2rdt2 [mm/ms^2]")) << table;
  const auto rows = rows_of(folder / "result" / "force.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1][0], 3500);
  EXPECT_NEAR(rows[1][1], 315, 1e-12);
  EXPECT_NEAR(rows[1][2], -0.02, 1e-17);
}

TEST(ForceCommand, JsonAndQuietSayNothingElse) {
  const Folder folder;
  const auto result = turgor(folder, {"force", shipped("motion-orifice-30mm"), "--json"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, contents(folder / "motion-orifice-30mm.force" / "force.json"));
  const auto quiet = turgor(folder, {"force", shipped("motion-orifice-30mm"), "-q", "-o", "other"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST(ForceCommand, ForceLeavesNothingOfAnEarlierRun) {
  const Folder folder;
  const std::vector<std::string> again{"force", shipped("motion-orifice-30mm"), "-o", "result", "--no-pictures"};
  ASSERT_EQ(turgor(folder, {"run", shipped("orifice-30mm"), "-o", "result"}).code, 0);
  test::write(folder / "result" / "notes.txt", "mine");
  const auto refused = turgor(folder, again);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("exists already"), std::string::npos);
  auto forced = again;
  forced.emplace_back("--force");
  ASSERT_EQ(turgor(folder, forced).code, 0);
  for (const char* file : {"run.json", "trajectory.csv", "history.png"})
    EXPECT_FALSE(fs::exists(folder / "result" / file));
  EXPECT_EQ(contents(folder / "result" / "notes.txt"), "mine");
}

// A motion whose curves are flat, or jump, is drawn without complaint.
TEST(ForceCommand, DrawsRestAndSharpTurns) {
  const Folder folder;
  for (const std::string velocity :
       {"[{ hold = \"1 s\" }]", "[{ to = \"2 cm/s\", over = \"1 s\" }, { to = \"-2 cm/s\", over = \"1 s\" }]"}) {
    const auto result = turgor(folder, {"force", shipped("motion-channel-20mm"), "-o", "result", "--force", "--set",
                                        "motion.velocity=" + velocity});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(fs::exists(folder / "result" / "force.png"));
  }
}

}  // namespace
}  // namespace turgor
