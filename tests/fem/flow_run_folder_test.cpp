#include "turgor/fem/flow_run_folder.hpp"

#include <gtest/gtest.h>

#include "fake_flow.hpp"

namespace turgor {
namespace {

using test::fake_case;
using test::FakeFlow;
using test::Folder;

/// Why a folder is refused; empty when it is not.
std::string refusal(const std::filesystem::path& path, const Case& c, EarlierRun earlier) {
  try {
    const FlowRunFolder folder(path, c, earlier);
    return "";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

void interrupt_in(const std::filesystem::path& path, const Case& c) {
  FakeFlow flow(c);
  FlowRunFolder folder(path, c, EarlierRun::refuse);
  (void)run_flow(c, flow, folder, {.progress = [](double time) { return time < 1; }});
}

void expect_says(const std::string& text, const std::vector<std::string>& words) {
  for (const auto& word : words) EXPECT_NE(text.find(word), std::string::npos) << "no \"" << word << "\" in: " << text;
}

TEST(FlowRunFolder, EarlierRunsAreNotTouched) {
  const Folder folder;
  const Case c = fake_case();
  interrupt_in(folder / "run", c);
  const std::string before = test::contents(folder / "run" / "history.csv");
  expect_says(refusal(folder / "run", c, EarlierRun::refuse), {"exists already", "--resume", "--force", "-o DIR"});
  EXPECT_EQ(test::contents(folder / "run" / "history.csv"), before);
}

TEST(FlowRunFolder, ReplacesOnlyWhatItWrites) {
  const Folder folder;
  const Case c = fake_case();
  interrupt_in(folder / "run", c);
  test::write(folder / "run" / "notes.txt", "mine");
  test::write(folder / "run" / "fields" / "flow-mine.vtu", "mine");
  EXPECT_EQ(refusal(folder / "run", c, EarlierRun::replace), "");
  EXPECT_EQ(test::contents(folder / "run" / "notes.txt"), "mine");
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "fields" / "flow-mine.vtu"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run" / "fields" / "flow-00000.vtu"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run" / "checkpoint.bin"));
  EXPECT_EQ(test::lines_of(test::contents(folder / "run" / "history.csv")).size(), 1U);
}

TEST(FlowRunFolder, OtherCasesAreRefused) {
  const Folder folder;
  const Case c = fake_case();
  interrupt_in(folder / "run", c);
  const Case other = fake_case({"fem.h_rim=0.4 mm"});
  expect_says(refusal(folder / "run", other, EarlierRun::resume),
              {"belongs to another case", "h_rim = \"5e-04 m\"", "h_rim = \"4e-04 m\"", "--force"});
  EXPECT_EQ(refusal(folder / "run", c, EarlierRun::resume), "");
}

TEST(FlowRunFolder, NothingToGoOnWithIsSaid) {
  const Folder folder;
  const Case c = fake_case();
  expect_says(refusal(folder / "none", c, EarlierRun::resume), {"does not exist"});
  std::filesystem::create_directory(folder / "empty");
  expect_says(refusal(folder / "empty", c, EarlierRun::resume), {"no checkpoint", "--force"});
  FakeFlow flow(c);
  {
    FlowRunFolder files(folder / "whole", c, EarlierRun::refuse);
    (void)run_flow(c, flow, files);
  }
  expect_says(refusal(folder / "whole", c, EarlierRun::resume), {"complete"});
}

TEST(FlowRunFolder, OneRunAtATime) {
  const Folder folder;
  const Case c = fake_case();
  interrupt_in(folder / "run", c);
  const FlowRunFolder first(folder / "run", c, EarlierRun::resume);
  expect_says(refusal(folder / "run", c, EarlierRun::resume), {"another run is writing"});
}

// A row that was half written when the machine stopped is cut off; a table that lost rows is not the checkpoint's.
TEST(FlowRunFolder, TablesMustReachTheCheckpoint) {
  const Folder folder;
  const Case c = fake_case();
  interrupt_in(folder / "run", c);
  const auto table = folder / "run" / "history.csv";
  const std::string whole = test::contents(table);
  test::write(table, whole + "1.5,0,3");
  EXPECT_EQ(refusal(folder / "run", c, EarlierRun::resume), "");
  EXPECT_EQ(test::contents(table), whole);
  test::write(table, whole.substr(0, whole.size() - 1));
  expect_says(refusal(folder / "run", c, EarlierRun::resume), {"history.csv", "not the table"});
}

TEST(FlowRunFolder, FieldsAreASeriesForParaView) {
  const Folder folder;
  const Case c = fake_case();
  const FakeFlow flow(c);
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  files.add_field(0.25, flow.fields());
  files.add_field(0.5, flow.fields());
  const std::string series = test::contents(files.path() / "fields.pvd");
  expect_says(series, {"type=\"Collection\"", "<DataSet timestep=\"0.25\" file=\"fields/flow-00000.vtu\"",
                       "<DataSet timestep=\"0.5\" file=\"fields/flow-00001.vtu\""});
  EXPECT_TRUE(std::filesystem::exists(files.path() / "fields" / "flow-00001.vtu"));
}

// Read by meshio, which knows the order of nodes in VTK's cells: edges' middles lie between their corners.
TEST(FlowRunFolder, CurvedCellsAreReadByMeshio) {
  const Folder folder;
  const Case c = fake_case();
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  files.add_field(0.25, FakeFlow(c).fields());
  test::write(folder / "read.py",
              "import meshio, numpy\n"
              "grid = meshio.read('run/fields/flow-00000.vtu')\n"
              "cells = grid.cells_dict['quad9']\n"
              "corners = grid.points[cells[0, :4]]\n"
              "middles = (corners + numpy.roll(corners, -1, axis=0)) / 2\n"
              "assert numpy.array_equal(grid.points[cells[0, 4:8]], middles)\n"
              "assert numpy.array_equal(grid.points[cells[0, 8]], corners.mean(axis=0))\n"
              "assert (grid.point_data['pressure'] == 0.4).all()\n"
              "assert grid.point_data['velocity'].shape == (9, 3)\n");
  const auto read = test::shell(folder, "/usr/bin/python3 read.py");
  EXPECT_EQ(read.code, 0) << read.err;
}

}  // namespace
}  // namespace turgor
