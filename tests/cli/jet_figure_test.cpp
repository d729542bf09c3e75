// turgor figure 5: it shows nothing but a run of finite elements, here a made-up one.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "../support/balloon_fields.hpp"
#include "../support/csv.hpp"
#include "../support/fem_run.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Csv;
using test::Folder;
using test::Jar;
using test::turgor;

constexpr const char* run = "jet-orifice-30mm.fem";

/// Writes the run of the shipped case into a folder, with so many fields.
void make_run(const Folder& folder, int fields, const test::MadeUpRun& how = {}) {
  const Case c = read_case(test::shipped("jet-orifice-30mm"));
  test::write_fsi_run(folder / run, c, [](double) { return 0.3; }, how);
  test::write_fields(folder / run, fields);
}

TEST(JetFigure, ShowsTheFieldsOfARun) {
  const Folder folder;
  make_run(folder, 9);
  const auto result = turgor(folder, {"figure", "5", "--fem", ".", "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const fs::path out = folder / "figure-5";
  const json figure = json::parse(result.out).at("figures").at(0);
  const std::set<std::string> files = figure.at("files");
  for (const std::string& file : files) EXPECT_TRUE(fs::exists(out / file)) << file;
  EXPECT_TRUE(files.contains("figure-5.png"));
  EXPECT_TRUE(files.contains("figure-5-film.gif"));
  EXPECT_EQ(contents(out / "figure-5.png").substr(1, 3), "PNG");
  const std::string gif = contents(out / "figure-5-film.gif");
  EXPECT_TRUE(gif.starts_with("GIF89a"));
  std::size_t images = 0;  // each has a graphic control extension before it
  for (std::size_t at = gif.find("\x21\xF9\x04"); at != std::string::npos; at = gif.find("\x21\xF9\x04", at + 1)) {
    ++images;
  }
  EXPECT_EQ(images, 9U);
  EXPECT_EQ(contents(out / "figure-5-film" / "frame-0001.png").substr(1, 3), "PNG");
  EXPECT_TRUE(fs::exists(out / "figure-5-film" / "frame-0009.png"));
  EXPECT_FALSE(fs::exists(out / "figure-5-film" / "frame-0010.png"));
  const std::string index = contents(out / "index.md");
  EXPECT_NE(index.find("](figure-5.png)"), std::string::npos);
  EXPECT_NE(index.find("](figure-5-film.gif)"), std::string::npos);
  EXPECT_NE(index.find("`turgor figure 5 --fem .`"), std::string::npos);
  EXPECT_EQ(index.find("Not complete"), std::string::npos);
}

// The jar stretched by 1 + t holds liquid at the rate t: heights, speeds, fluxes follow.
TEST(JetFigure, ItsTablesAreThoseOfTheFields) {
  const Folder folder;
  make_run(folder, 9);
  EXPECT_EQ(turgor(folder, {"figure", "5", "--fem", ".", "--no-pictures", "-q"}).code, 0);
  const Csv shapes(folder / "figure-5" / "figure-5.csv");
  ASSERT_EQ(shapes.size(), 9U);
  const double widest = Jar::radius(0.5);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double t = 0.1 * static_cast<double>(i);
    const double part = std::min(t / 0.4, 1.0);
    const double top = 0.6 * (1 + t);
    EXPECT_NEAR(shapes(i, "t [s]"), t, 1e-12);
    EXPECT_NEAR(shapes(i, "p_gauge [Pa]"), 36e3 * part * part * part * (10 + part * (6 * part - 15)), 1e-8);
    EXPECT_NEAR(shapes(i, "z_top [m]"), top, 1e-12);
    EXPECT_NEAR(shapes(i, "r_max [m]"), widest, 1e-12);
    EXPECT_NEAR(shapes(i, "height by width [1]"), top / (2 * widest), 1e-12);
    EXPECT_NEAR(shapes(i, "centre by height [1]"), shapes(0, "centre by height [1]"), 1e-12);
    EXPECT_NEAR(shapes(i, "speed_max [m/s]"), t * std::hypot(0.1, 2 * top), 1e-12);
  }
  const Csv lines(folder / "figure-5" / "figure-5-streamlines.csv");
  std::map<double, std::set<double>> fluxes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double r = lines(i, "r [m]");
    const double flux = 2 * std::numbers::pi * lines(i, "t [s]") * r * r * lines(i, "z [m]");  // of (-r, 2 z)
    fluxes[lines(i, "t [s]")].insert(lines(i, "flux [m^3/s]"));
    EXPECT_NEAR(lines(i, "flux [m^3/s]"), flux, 0.06 * lines(i, "t [s]"));  // on 4 by 4 cells
  }
  EXPECT_EQ(fluxes.size(), 6U);       // panels
  EXPECT_TRUE(fluxes.contains(0.8));  // the longest
  const Csv walls(folder / "figure-5" / "figure-5-walls.csv");
  ASSERT_EQ(walls.size(), 6U * (2U * Jar::nodes - 1));
  for (std::size_t i = 0; i < walls.size(); ++i) {
    EXPECT_NEAR(walls(i, "z [m]"), (1 + walls(i, "t [s]")) * walls(i, "z at start [m]"), 1e-12);
  }
}

TEST(JetFigure, DrawsRunsOfOneFieldAndRunsUnderWay) {
  const Folder folder;
  make_run(folder, 1, {.status = "running", .end = 0});
  const auto result = turgor(folder, {"figure", "5", "--fem", ".", "-q"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(fs::exists(folder / "figure-5" / "figure-5-film.gif"));
  EXPECT_NE(contents(folder / "figure-5" / "index.md").find("Not complete: `jet-orifice-30mm.fem`"), std::string::npos);
}

TEST(JetFigure, AnEarlierFilmIsReplacedAndNothingElse) {
  const Folder folder;
  make_run(folder, 4);
  EXPECT_EQ(turgor(folder, {"figure", "5", "--fem", ".", "-q"}).code, 0);
  test::write(folder / "figure-5" / "figure-5-film" / "mine.txt", "mine");
  make_run(folder, 2);
  EXPECT_EQ(turgor(folder, {"figure", "5", "--fem", ".", "-q", "--force"}).code, 0);
  EXPECT_TRUE(fs::exists(folder / "figure-5" / "figure-5-film" / "frame-0002.png"));
  EXPECT_FALSE(fs::exists(folder / "figure-5" / "figure-5-film" / "frame-0003.png"));
  EXPECT_EQ(turgor(folder, {"figure", "5", "--fem", ".", "-q", "--force", "--no-pictures"}).code, 0);
  EXPECT_FALSE(fs::exists(folder / "figure-5" / "figure-5-film" / "frame-0001.png"));
  EXPECT_FALSE(fs::exists(folder / "figure-5" / "figure-5-film.gif"));
  EXPECT_EQ(contents(folder / "figure-5" / "figure-5-film" / "mine.txt"), "mine");
}

TEST(JetFigure, SaysWhatItNeeds) {
  const Folder folder;
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--fem", "."}}) {
    std::vector<std::string> arguments{"figure", "5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("shows a run of finite elements, jet-orifice-30mm.fem"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("`turgor fem fsi " + test::shipped("jet-orifice-30mm") + "`"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("`turgor figure 5 --fem .`"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder / "figure-5"));
  }
}

TEST(JetFigure, NamesTheFileThatIsWrong) {
  const Folder folder;
  const auto refused = [&](const std::string& part) {
    const auto result = turgor(folder, {"figure", "5", "--fem", ".", "-q", "--force"});
    EXPECT_EQ(result.code, 2) << part;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
  };
  fs::create_directory(folder / run);
  refused("is no run directory of `turgor fem fsi`: it has no resolved.toml");
  make_run(folder, 3);
  fs::remove(folder / run / "fields.pvd");
  refused("has no fields.pvd");
  make_run(folder, 3);
  fs::remove(folder / run / "fields" / "flow-1.vtu");
  refused("fields/flow-1.vtu\": cannot be read");
  make_run(folder, 3);
  test::write(folder / run / "fields" / "flow-2.vtu", "<VTKFile type=\"PolyData\"/>");
  refused("fields/flow-2.vtu\": is no VTK file of type UnstructuredGrid");
  make_run(folder, 3);
  std::string other = contents(folder / run / "resolved.toml");
  other.replace(other.find("36000 Pa"), 8, "30000 Pa");
  test::write(folder / run / "resolved.toml", other);
  refused("belongs to another case");
}

}  // namespace
}  // namespace turgor
