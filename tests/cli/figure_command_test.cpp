// turgor figure, as a user meets it: what it leaves behind, and how it fails.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::turgor;

const std::vector<std::string> names{"2", "3", "4",     "5",      "6",           "7",
                                     "8", "9", "decay", "errors", "bistability", "design"};

TEST(FigureCommand, ListsWhatThereIs) {
  const Folder folder;
  const auto text = turgor(folder, {"figure"});
  EXPECT_EQ(text.code, 0) << text.err;
  const auto listed = json::parse(turgor(folder, {"figure", "--json"}).out).at("figures");
  ASSERT_EQ(listed.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(listed[i].at("name"), names[i]);
    EXPECT_NE(text.out.find("\n  " + names[i] + " "), i == 0 ? 0 : std::string::npos) << names[i];
    for (const std::string name : listed[i].at("cases")) EXPECT_TRUE(fs::exists(fs::path(TURGOR_CASES) / name)) << name;
  }
}

TEST(FigureCommand, MakesAllOfThem) {
  const Folder folder;
  const auto result = turgor(folder, {"figure", "all", "-o", "all", "--json"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  const json document = json::parse(result.out);
  EXPECT_EQ(document, json::parse(contents(folder / "all" / "figures.json")));
  EXPECT_EQ(document.at("status"), "complete");
  const std::string index = contents(folder / "all" / "index.md");
  ASSERT_EQ(document.at("figures").size(), names.size());
  std::size_t files = 0;
  for (const json& figure : document.at("figures")) {
    EXPECT_TRUE(figure.at("failure").is_null());
    const bool needs_fem = figure.at("name") == "5";
    EXPECT_EQ(figure.at("lacking").is_null(), !needs_fem);
    EXPECT_NE(index.find("`turgor figure " + figure.at("name").get<std::string>() + (needs_fem ? " --fem .`" : "`")),
              std::string::npos);
    if (needs_fem) continue;
    std::size_t pictures = 0;
    for (const std::string name : figure.at("files")) {
      ++files;
      const fs::path file = folder / "all" / name;
      EXPECT_GT(fs::file_size(file), 200U) << name;
      if (file.extension() == ".csv") {
        EXPECT_EQ(contents(file).find("nan"), std::string::npos) << name;
        EXPECT_NE(contents(file).find("]"), std::string::npos) << name << " has no units";
      }
      if (file.extension() == ".svg") {
        EXPECT_NE(contents(file).find("<svg"), std::string::npos);
      }
      if (file.extension() != ".png") continue;
      ++pictures;
      EXPECT_EQ(contents(file).substr(1, 3), "PNG");
      EXPECT_NE(index.find("](" + name + ")"), std::string::npos) << name;
    }
    EXPECT_GT(pictures, 0U) << figure.at("name");
  }
  std::size_t found = 0;
  for (const auto& entry : fs::directory_iterator(folder / "all")) {
    ++found;
    EXPECT_NE(entry.path().extension(), ".part");
    EXPECT_NE(entry.path().extension(), ".log");
  }
  EXPECT_EQ(found, files + 2);  // index.md and figures.json
  EXPECT_EQ(turgor(folder, {"figure", "all", "-o", "all", "--force", "--no-pictures", "-q"}).code, 0);
  for (const auto& entry : fs::directory_iterator(folder / "all")) {
    const std::string ending = entry.path().extension();  // earlier pictures are gone, all of them
    EXPECT_TRUE(ending == ".csv" || ending == ".json" || ending == ".md") << entry.path();
  }
}

TEST(FigureCommand, FoldersAreReplacedOnlyWhenAsked) {
  const Folder folder;
  const auto first = turgor(folder, {"figure", "7"});
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_NE(first.out.find("figure-7/figure-7.png"), std::string::npos) << first.out;
  test::write(folder / "figure-7" / "mine.txt", "mine");
  const auto again = turgor(folder, {"figure", "7"});
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("--force"), std::string::npos) << again.err;
  EXPECT_EQ(turgor(folder, {"figure", "7", "--force", "--no-pictures", "-q"}).out, "");
  EXPECT_FALSE(fs::exists(folder / "figure-7" / "figure-7.png"));
  EXPECT_TRUE(fs::exists(folder / "figure-7" / "figure-7.csv"));
  EXPECT_EQ(contents(folder / "figure-7" / "mine.txt"), "mine");
}

TEST(FigureCommand, RefusesWhatCannotBe) {
  const Folder folder;
  test::write(folder / "file", "");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 2) << part;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
  };
  refused({"figure", "1"}, "\"1\": there is no such figure");
  for (const std::string& name : names) refused({"figure", "ten"}, name + ", ");
  refused({"figure", "7", "-o", "file"}, "is a file");
  refused({"figure", "7", "-o", "file/below"}, "cannot be created");
  refused({"figure", "7", "--cases", "nowhere"}, "--cases = \"nowhere\": is not a folder");
  refused({"figure", "7", "--cases", "."}, "orifice-30mm.toml");
  EXPECT_EQ(turgor(folder, {"figure", "7", "--colour"}).code, 2);
}

TEST(FigureCommand, AProgramWithoutItsCasesSaysSo) {
  const Folder folder;
  const auto result =
      test::shell(folder, "mkdir bin && cp '" + std::string(TURGOR_PROGRAM) + "' bin/turgor && bin/turgor figure 7");
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("--cases"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("share/turgor/cases"), std::string::npos) << result.err;
  const auto with =
      test::shell(folder, "bin/turgor figure 7 --no-pictures --cases '" + std::string(TURGOR_CASES) + "'");
  EXPECT_EQ(with.code, 0) << with.err;
}

// The others are kept, and what failed is said in every place: screen, index, document, exit code.
TEST(FigureCommand, OneThatFailsDoesNotLoseTheOthers) {
  const Folder folder;
  fs::create_directory(folder / "cases");
  for (const auto& entry : fs::directory_iterator(TURGOR_CASES)) {
    if (entry.path().filename() != "orifice-30mm.toml") fs::copy(entry.path(), folder / "cases");
  }
  std::string straight = contents(fs::path(TURGOR_CASES) / "orifice-30mm.toml");  // S1/S2 = 4: no second state
  straight.replace(straight.find("1.5 MPa"), 7, "0.6 MPa");
  test::write(folder / "cases" / "orifice-30mm.toml", straight);
  const auto result = turgor(folder, {"figure", "all", "--cases", "cases", "--no-pictures", "-o", "all"});
  EXPECT_EQ(result.code, 4);
  const json document = json::parse(contents(folder / "all" / "figures.json"));
  EXPECT_EQ(document.at("status"), "failed");
  for (const json& figure : document.at("figures")) {
    const std::string name = figure.at("name");
    const bool needs = name == "7" || name == "8" || name == "9" || name == "decay" || name == "bistability";
    EXPECT_EQ(figure.at("failure").is_null(), !needs) << name;
    EXPECT_EQ(figure.at("files").empty(), needs || name == "5") << name;
    const std::string line = "error: figure " + name + " was not made: ";
    EXPECT_EQ(result.err.find(line) != std::string::npos, needs) << result.err;
  }
  EXPECT_NE(result.err.find("one maximum and one minimum"), std::string::npos) << result.err;
  EXPECT_NE(contents(folder / "all" / "index.md").find("Not made: "), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "all" / "figure-4.csv"));
}

TEST(FigureCommand, WithoutGnuplotTheNumbersStay) {
  const Folder folder;
  const auto result =
      test::shell(folder, "PATH=/nowhere '" + std::string(TURGOR_PROGRAM) + "' figure bistability -o out");
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("warning: no pictures: gnuplot was not found"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::exists(folder / "out" / "figure-bistability.csv"));
  EXPECT_EQ(contents(folder / "out" / "index.md").find(".png"), std::string::npos);
  const json figure = json::parse(contents(folder / "out" / "figures.json")).at("figures").at(0);
  EXPECT_EQ(figure.at("files"), json::parse("[\"figure-bistability.csv\"]"));
  EXPECT_FALSE(figure.at("picture_problem").is_null());
}

}  // namespace
}  // namespace turgor
