// Tables of a wall's stress as a person writes them: files and lists, resolved cases, sweeps, and every mistake.

#include <gtest/gtest.h>

#include "../support/program.hpp"

namespace turgor {
namespace {

using test::contents;
using test::Folder;
using test::turgor;

const std::string good_table =
    "{ stretch = [0.9, 1.0, 1.2, 1.5, 2.0], stress = [\"-1 MPa\", \"0 Pa\", \"1.2 MPa\", \"2200 kPa\", \"3.1 MPa\"] }";

std::string case_with(const std::string& material) {
  return R"(title = "A wall from the laboratory"
[balloon]
radius = "30 cm"
thickness = "3 mm"
density = "1000 kg/m^3"
[material]
)" + material +
         R"(
[fluid]
density = "1000 kg/m^3"
viscosity = "8.94e-4 Pa s"
[inlet]
orifice_radius = "3 cm"
[pressure]
constant = "8 kPa"
[solve]
t_end = "2 s"
samples = 20
)";
}

std::string case_of_table(const std::string& table) { return case_with("model = \"table\"\ntable = " + table); }

std::string refusal(const std::string& text, const std::string& csv = "") {
  const Folder folder;
  test::write(folder / "case.toml", text);
  if (!csv.empty()) test::write(folder / "wall.csv", csv);
  const auto result = turgor(folder, {"validate", "case.toml"});
  EXPECT_EQ(result.code, 2) << result.out;
  return result.err;
}

void expect_all(const std::string& text, const std::vector<std::string>& words) {
  for (const auto& word : words) EXPECT_NE(text.find(word), std::string::npos) << "no \"" << word << "\" in:\n" << text;
}

/// The good table with a change.
std::string with(const std::string& from, const std::string& to) {
  std::string text = good_table;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return case_of_table(text.replace(at, from.size(), to));
}

// The table stands in line 8 of the case.
TEST(MaterialTable, MistakesInListsAreExplained) {
  expect_all(refusal(with("0.9, 1.0", "1.0")), {"case.toml:8", "material.table.stress", "5 values", "has 4"});
  expect_all(refusal(with("1.5, 2.0", "1.5, 1.5")),
             {"case.toml:8", "material.table.stretch[4]", "material.table.stretch[4] = 1.5: is not above 1.5", "sort"});
  expect_all(refusal(with("0 Pa", "1 kPa")), {"case.toml:8", "material.table.stress[1]", "must be 0", "subtract"});
  expect_all(refusal(with("1.0,", "1.01,")), {"case.toml:8", "material.table.stretch", "no point at stretch 1"});
  expect_all(refusal(with("1.5,", "nan,")), {"case.toml:8", "material.table.stretch[3]", "finite"});
  expect_all(refusal(with("0.9,", "-0.9,")), {"case.toml:8", "material.table.stretch[0]", "> 0"});
  expect_all(refusal(with("2200 kPa", "2200")), {"case.toml:8", "material.table.stress[3]", "missing unit"});
  expect_all(refusal(with("\"2200 kPa\"", "2200.0")), {"case.toml:8", "material.table.stress[3]", "missing unit"});
  expect_all(refusal(with("2200 kPa", "2200 kN")), {"case.toml:8", "material.table.stress[3]", "wrong dimension"});
  expect_all(refusal(with("2200 kPa", "inf kPa")), {"case.toml:8", "material.table.stress[3]"});
  expect_all(refusal(with("stretch = [", "strain = [")), {"material.table.strain", "unknown key", "has no list"});
  expect_all(refusal(with("stress =", "stretch2 =")), {"has no list material.table.stress"});
  expect_all(refusal(with("-1 MPa", "1 MPa")), {"unstable", "must rise"});
  expect_all(refusal(case_of_table("{ stretch = [1.0, 2.0, 3.0], stress = [\"0 Pa\", \"1 Pa\", \"2 Pa\"] }")),
             {"case.toml:8", "material.table.stretch", "3 points", "four"});
  expect_all(refusal(case_of_table("{ stretch = [], stress = [] }")), {"material.table.stretch", "is empty"});
}

TEST(MaterialTable, MistakesInTheirWayOfBeingGivenAreExplained) {
  expect_all(refusal(case_of_table("\"wall.csv\"")), {"case.toml:8", "material.table", "a string, not a table"});
  expect_all(refusal(case_of_table("{}")), {"case.toml:8", "material.table", "has no points", "wall.csv"});
  expect_all(refusal(with("{ stretch", "{ file = \"wall.csv\", stretch")), {"both a file and inline points"});
  expect_all(refusal(case_of_table("{ file = 3 }")), {"material.table.file", "not a string"});
  expect_all(refusal(case_with("model = \"table\"")), {"material.table: missing", "stretch = [1.0"});
  expect_all(refusal(case_with("model = \"table\"\nmu = \"1 MPa\"\ntable = " + good_table)),
             {"case.toml:8", "material.mu", "not a key of this material", "neo-hookean"});
  expect_all(refusal(case_with("model = \"neo-hookean\"\nmu = \"1 MPa\"\ntable = " + good_table)),
             {"case.toml:9", "material.table.stretch", "not a key of this material", "table"});
}

TEST(MaterialTable, MistakesInFilesAreExplained) {
  const std::string text = case_of_table("{ file = \"wall.csv\" }");
  const auto says = [&](const std::string& csv, const std::vector<std::string>& words) {
    const std::string message = refusal(text, csv);
    expect_all(message, {"case.toml:8", "material.table.file"});
    expect_all(message, words);
  };
  const std::string head = "stretch [1],stress [kPa]\n";
  says("", {"wall.csv", "cannot be read"});
  says(head, {"wall.csv", "no rows"});
  says("stretch,stress [kPa]\n1,0\n", {"wall.csv", "has no unit"});
  says("stretch [1],stress [kN]\n1,0\n", {"wall.csv", "\"kN\" has the wrong dimension"});
  says("stress [kPa],stretch [1]\n1,0\n", {"wall.csv", "wrong dimension"});
  says(head + "1,0,0\n", {"wall.csv, row 2", "3 columns"});
  says(head + "1,0\n1.1,nan\n", {"wall.csv, row 3", "not a finite number"});
  says(head + "1,0\n1.1,\n", {"wall.csv, row 3", "not a finite number"});
  says(head + "1,0\n1.2,1\n1.1,2\n1.4,4\n", {"row 4: 1.1: is not above 1.2", "increase strictly"});
  says(head + "0.9,-1\n1,0.5\n1.1,2\n1.4,4\n", {"row 3: 500 Pa", "must be 0"});
  says(head + "1,0\n1.1,1\n", {"2 points", "four"});
}

TEST(MaterialTable, FileListsAndResolvedCaseMoveTheSameToTheBit) {
  const Folder folder;
  test::write(folder / "wall.csv", "stretch [1],stress [MPa]\n0.9,-1\n1,0\n1.2,1.2\n1.5,2.2\n2,3.1\n");
  test::write(folder / "file.toml", case_of_table("{ file = \"wall.csv\" }"));
  test::write(folder / "lists.toml", case_of_table(good_table));
  const auto run = [&](const std::string& file, const std::string& result) {
    const auto done = turgor(folder, {"run", file, "-o", result, "--no-pictures"});
    EXPECT_EQ(done.code, 0) << done.err;
    return contents(folder / result / "trajectory.csv");
  };
  const std::string expected = run("file.toml", "first");
  EXPECT_EQ(run("first/resolved.toml", "second"), expected);
  EXPECT_EQ(run("lists.toml", "third"), expected);
  const std::string resolved = contents(folder / "first" / "resolved.toml");
  EXPECT_EQ(contents(folder / "second" / "resolved.toml"), resolved);
  expect_all(resolved, {"table = { stretch = [0.9, 1.0, 1.2, 1.5, 2.0], stress = [\"-1e+06 Pa\", \"0 Pa\""});
  EXPECT_EQ(resolved.find("wall.csv"), std::string::npos);
}

TEST(MaterialTable, CanBeReplacedAsAWhole) {
  const Folder folder;
  test::write(folder / "case.toml", case_of_table("{ file = \"none.csv\" }"));
  const auto result =
      turgor(folder, {"run", "case.toml", "-o", "result", "--no-pictures", "--set", "material.table=" + good_table});
  EXPECT_EQ(result.code, 0) << result.err;
}

TEST(MaterialTable, IsListedAndDocumented) {
  const Folder folder;
  expect_all(turgor(folder, {"materials"}).out, {"\ntable\n", "table.stretch [1] list > 0", "table.stress [Pa] list"});
  expect_all(turgor(folder, {"doc"}).out, {"table.file", "table.stretch", "table.stress"});
}

}  // namespace
}  // namespace turgor
