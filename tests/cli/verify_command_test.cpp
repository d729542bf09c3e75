// turgor verify, and figures with finite elements, as a user meets them.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../support/csv.hpp"
#include "../support/fem_run.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::Folder;
using test::MadeUpForces;
using test::turgor;

const std::string motion = (fs::path(TURGOR_CASES) / "motion-orifice-30mm.toml").string();

/// Writes motion-orifice-30mm.fem into a folder.
void make_run(const Folder& folder, const test::MadeUpRun& run = {}) {
  test::write_fem_run(
      folder / "motion-orifice-30mm.fem", read_case(motion),
      [](double t) { return MadeUpForces{t > 2.5 ? 1e4 : 10, t > 2.5 ? 1.1e4 : 10}; }, run);
}

TEST(VerifyCommand, WritesItsDirectory) {
  const Folder folder;
  make_run(folder);
  const auto result = turgor(folder, {"verify", motion});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("deflating, constant velocity"), std::string::npos) << result.out;
  const fs::path directory = folder / "motion-orifice-30mm.verify";
  EXPECT_EQ(contents(directory / "case.toml"), contents(motion));
  EXPECT_EQ(nlohmann::json::parse(contents(directory / "verify.json")).at("finite_elements").at("rows"), 2001);
  EXPECT_TRUE(contents(directory / "verify.csv").starts_with("t [s],r [cm],drdt [cm/s],d2rdt2 [cm/s^2],force_fem [N]"));
  EXPECT_NE(contents(directory / "verify.svg").find("<svg"), std::string::npos);
  EXPECT_NE(contents(directory / "verify.gp").find("title 'finite elements'"), std::string::npos);
  EXPECT_EQ(contents(directory / "verify.png").substr(1, 3), "PNG");
  EXPECT_EQ(turgor(folder, {"verify", motion}).code, 2);
  EXPECT_EQ(turgor(folder, {"verify", motion, "--force", "--no-pictures", "-q"}).out, "");
  EXPECT_FALSE(fs::exists(directory / "verify.png"));
  const auto json = turgor(folder, {"verify", motion, "--json", "-o", "other", "--fem", "motion-orifice-30mm.fem"});
  EXPECT_EQ(json.out, contents(folder / "other" / "verify.json"));
}

TEST(VerifyCommand, DrawsRunsOfOneRow) {
  const Folder folder;
  make_run(folder, {.status = "interrupted", .end = 0});
  const auto result = turgor(folder, {"verify", motion});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("is not complete"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "motion-orifice-30mm.verify" / "verify.png"));
}

TEST(VerifyCommand, SaysHowToComputeWhatIsMissing) {
  const Folder folder;
  const auto missing = turgor(folder, {"verify", motion, "--set", "inlet.orifice_radius=2 cm"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(
      missing.err.find("`turgor fem flow " + motion + " -o motion-orifice-30mm.fem --set 'inlet.orifice_radius=2 cm'`"),
      std::string::npos)
      << missing.err;
  EXPECT_FALSE(fs::exists(folder / "motion-orifice-30mm.verify"));
  make_run(folder);
  const auto other = turgor(folder, {"verify", motion, "--set", "inlet.orifice_radius=2 cm"});
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("it has inlet.orifice_radius = \"0.03 m\""), std::string::npos) << other.err;
  const auto same = turgor(folder, {"verify", motion, "-o", "motion-orifice-30mm.fem", "--force"});
  EXPECT_EQ(same.code, 2);
  EXPECT_TRUE(fs::exists(folder / "motion-orifice-30mm.fem" / "resolved.toml"));
  const std::string balloon = test::shipped("orifice-30mm");
  const auto free = turgor(folder, {"verify", balloon});
  EXPECT_EQ(free.code, 2);
  EXPECT_NE(free.err.find("`turgor fem fsi " + balloon + " -o orifice-30mm.fem`"), std::string::npos) << free.err;
  const auto dictated = turgor(folder, {"verify", balloon, "--fem", "motion-orifice-30mm.fem"});
  EXPECT_EQ(dictated.code, 2);
  EXPECT_NE(dictated.err.find("is a run of dictated motion"), std::string::npos) << dictated.err;
}

TEST(VerifyCommand, FigureThreeShowsFiniteElements) {
  const Folder folder;
  make_run(folder, {.status = "failed", .end = 3});
  const auto result = turgor(folder, {"figure", "3", "--fem", ".", "-q"});
  EXPECT_EQ(result.code, 0) << result.err;
  const std::string index = contents(folder / "figure-3" / "index.md");
  EXPECT_NE(index.find("Solid black: finite elements. There are none of `motion-orifice-5mm.fem`, "), std::string::npos)
      << index;
  EXPECT_NE(index.find("Not complete: `motion-orifice-30mm.fem`."), std::string::npos) << index;
  const std::string script = contents(folder / "figure-3" / "figure-3.gp");
  EXPECT_NE(script.find("$orifice3fem << EOD"), std::string::npos);
  EXPECT_EQ(script.find("$orifice2fem"), std::string::npos);
  EXPECT_NE(script.find("keyentry with lines lw 2 lc rgb 'black' title 'F by finite elements'"), std::string::npos);
  EXPECT_EQ(turgor(folder, {"figure", "7", "--fem", ".", "-o", "7"}).code, 2);
  EXPECT_EQ(turgor(folder, {"figure", "3", "--fem", "nowhere", "-o", "3"}).code, 2);
  ASSERT_EQ(turgor(folder, {"figure", "3", "--no-pictures", "-o", "plain", "-q"}).code, 0);
  EXPECT_EQ(contents(folder / "plain" / "index.md").find("finite elements"), std::string::npos);
}

/// Writes orifice-30mm.fem into a folder, whose effective radius is 0.3 m + 1 mm/s t.
void make_elastic_run(const Folder& folder, const test::MadeUpRun& run = {}) {
  const auto radius = [](double t) { return 0.3 + 1e-3 * t; };
  test::write_fsi_run(folder / "orifice-30mm.fem", read_case(test::shipped("orifice-30mm")), radius, run);
}

TEST(VerifyCommand, WritesItsDirectoryForAnElasticBalloon) {
  const Folder folder;
  make_elastic_run(folder);
  const std::string balloon = test::shipped("orifice-30mm");
  const auto result = turgor(folder, {"verify", balloon});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("falling, 4 to 6 s"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("(2.23) calibrated"), std::string::npos) << result.out;
  const fs::path directory = folder / "orifice-30mm.verify";
  EXPECT_EQ(contents(directory / "case.toml"), contents(balloon));
  EXPECT_EQ(nlohmann::json::parse(contents(directory / "verify.json")).at("finite_elements").at("rows"), 2000);
  EXPECT_TRUE(contents(directory / "verify.csv")
                  .starts_with("t [s],p_gauge [Pa],r_eff_fem [m],shape_energy_fem [J],r_full_theoretical [m]"));
  EXPECT_NE(contents(directory / "verify.svg").find("<svg"), std::string::npos);
  EXPECT_NE(contents(directory / "verify.gp").find("title '(2.23) corrected'"), std::string::npos);
  EXPECT_EQ(contents(directory / "verify.png").substr(1, 3), "PNG");
  const auto json = turgor(folder, {"verify", balloon, "--json", "-o", "other", "--fem", "orifice-30mm.fem"});
  EXPECT_EQ(json.out, contents(folder / "other" / "verify.json"));
}

TEST(VerifyCommand, DrawsElasticRunsOfOneRow) {
  const Folder folder;
  make_elastic_run(folder, {.status = "running", .end = 0});
  const auto result = turgor(folder, {"verify", test::shipped("orifice-30mm")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("is not complete"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "orifice-30mm.verify" / "verify.png"));
}

TEST(VerifyCommand, FigureFourShowsElasticRuns) {
  const Folder folder;
  make_elastic_run(folder, {.status = "interrupted", .end = 3});
  const auto result = turgor(folder, {"figure", "4", "--fem", ".", "-q"});
  EXPECT_EQ(result.code, 0) << result.err;
  const std::string index = contents(folder / "figure-4" / "index.md");
  EXPECT_NE(index.find("Vermilion: finite elements. There are none of `orifice-10mm.fem`, `orifice-15mm.fem`, "
                       "`orifice-20mm.fem`. Not complete: "
                       "`orifice-30mm.fem`."),
            std::string::npos)
      << index;
  const std::string script = contents(folder / "figure-4" / "figure-4.gp");
  EXPECT_NE(script.find("$fem3 << EOD"), std::string::npos);
  EXPECT_EQ(script.find("$fem2"), std::string::npos);
  EXPECT_NE(script.find("$fem3 with lines lw 2 lc rgb '#D55E00' title 'finite elements'"), std::string::npos);
  const test::Csv table(folder / "figure-4" / "figure-4.csv");
  std::size_t rows = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table.text(i, "model") != "finite elements") continue;
    ++rows;
    EXPECT_EQ(table(i, "r_ch [m]"), 0.03);
    EXPECT_NEAR(table(i, "R [1]"), 1 + table(i, "t [s]") / 300, 1e-12);
  }
  EXPECT_EQ(rows, 100U);  // 2000 over 60 s
  EXPECT_EQ(turgor(folder, {"figure", "6", "--fem", ".", "-o", "6", "--no-pictures", "-q"}).code, 0);
  EXPECT_NE(contents(folder / "6" / "index.md").find("There are none of `channel-10mm.fem`"), std::string::npos);
}

}  // namespace
}  // namespace turgor
