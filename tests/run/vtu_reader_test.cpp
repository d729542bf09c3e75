// What is read back is what was written, and nothing else is read.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "../support/program.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor {
namespace {

using test::Folder;

/// Nine points, one cell of each kind, numbers that text would lose.
VtuGrid sample() {
  VtuGrid grid;
  for (int i = 0; i < 9; ++i) grid.points.insert(grid.points.end(), {0.1 * i, 1.0 / (i + 3), 0.0});
  grid.quadrilaterals = {{0, 1, 4, 3}};
  grid.biquadratic = {{0, 2, 8, 6, 1, 5, 7, 3, 4}};
  const std::vector<double> odd{-0.0,
                                std::numeric_limits<double>::denorm_min(),
                                std::numeric_limits<double>::max(),
                                std::nextafter(1.0, 2.0),
                                0,
                                -1e-300,
                                3,
                                4,
                                5};
  grid.data = {{"pressure & <more>", 1, odd}, {"velocity", 3, std::vector<double>(27, 1.0 / 3)}};
  return grid;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The complaint about a file of this text.
template <class Read>
Issue complaint(const Read& read, const std::string& text) {
  const Folder folder;
  test::write(folder / "file", text);
  try {
    (void)read(folder / "file");
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().value, (folder / "file").string());
    return error.issues().front();
  }
  ADD_FAILURE() << "was read";
  return {};
}
void expect_refused(const std::string& text, const std::string& part) {
  const Issue issue = complaint(read_vtu, text);
  EXPECT_NE(issue.problem.find(part), std::string::npos) << issue.problem;
}

TEST(VtuReader, ReadsBackTheSameBits) {
  const Folder folder;
  const VtuGrid grid = sample();
  test::write(folder / "file", vtu_text(grid));
  const VtuGrid read = read_vtu(folder / "file");
  EXPECT_EQ(read.points, grid.points);
  EXPECT_EQ(read.quadrilaterals, grid.quadrilaterals);
  EXPECT_EQ(read.biquadratic, grid.biquadratic);
  ASSERT_EQ(read.data.size(), grid.data.size());
  for (std::size_t i = 0; i < grid.data.size(); ++i) {
    EXPECT_EQ(read.data[i].name, grid.data[i].name);
    EXPECT_EQ(read.data[i].components, grid.data[i].components);
    ASSERT_EQ(read.data[i].values.size(), grid.data[i].values.size());
    for (std::size_t k = 0; k < grid.data[i].values.size(); ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read.data[i].values[k]),
                std::bit_cast<std::uint64_t>(grid.data[i].values[k]));
    }
  }
}

// Lengths of base64 go by threes.
TEST(VtuReader, ReadsArraysOfAnyLength) {
  const Folder folder;
  for (int cells = 1; cells < 8; ++cells) {
    VtuGrid grid = sample();
    grid.quadrilaterals.resize(static_cast<std::size_t>(cells), {0, 1, 4, 3});
    test::write(folder / "file", vtu_text(grid));
    EXPECT_EQ(read_vtu(folder / "file").quadrilaterals, grid.quadrilaterals);
  }
}

TEST(VtuReader, ReadsSeries) {
  const Folder folder;
  test::write(folder / "file", pvd_text({{0, "fields/a & b.vtu"}, {0.1, "c.vtu"}}));
  const auto series = read_pvd(folder / "file");
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].file, "fields/a & b.vtu");
  EXPECT_EQ(series[1].time, 0.1);
  test::write(folder / "file", pvd_text({}));
  EXPECT_TRUE(read_pvd(folder / "file").empty());
}

TEST(VtuReader, RefusesWhatIsNoSeries) {
  const auto says = [](const std::string& text) { return complaint(read_pvd, text).problem; };
  EXPECT_NE(says(vtu_text(sample())).find("no VTK file of type Collection"), std::string::npos);
  const std::string good = pvd_text({{0.25, "a.vtu"}});
  EXPECT_NE(says(replaced(good, "0.25", "soon")).find("the time \"soon\", which is no number"), std::string::npos);
  EXPECT_NE(says(replaced(good, "0.25", "inf")).find("no number"), std::string::npos);
  EXPECT_NE(says(good.substr(0, good.size() / 2)).find("no whole XML document"), std::string::npos);
}

TEST(VtuReader, RefusesFilesThatAreNone) {
  EXPECT_THROW((void)read_vtu("/nowhere/at/all.vtu"), InvalidInput);
  expect_refused("", "no whole XML document");
  expect_refused("<html><body>moved</body></html>", "is no VTK file of type UnstructuredGrid");
  const std::string good = vtu_text(sample());
  for (const double share : {0.1, 0.5, 0.9, 0.999}) {
    expect_refused(good.substr(0, static_cast<std::size_t>(share * static_cast<double>(good.size()))), "XML");
  }
}

TEST(VtuReader, RefusesOtherLayouts) {
  const std::string good = vtu_text(sample());
  expect_refused(replaced(good, "UInt64", "UInt32"), "header_type = \"UInt32\", where turgor writes \"UInt64\"");
  expect_refused(replaced(good, "LittleEndian", "BigEndian"), "byte_order");
  expect_refused(replaced(good, " header_type", " compressor=\"vtkZLibDataCompressor\" header_type"), "compressor");
  expect_refused(replaced(good, "format=\"binary\"", "format=\"appended\""), "format = \"appended\"");
  expect_refused(replaced(good, "Float64", "Float32"), "type = \"Float32\"");
  expect_refused(replaced(good, "NumberOfComponents=\"3\" format=\"binary\">", "NumberOfComponents=\"0\">"), "");
}

TEST(VtuReader, RefusesBrokenNumbers) {
  const std::string good = vtu_text(sample());
  const std::size_t first = good.find("format=\"binary\">") + 16;
  expect_refused(std::string(good).replace(first, 4, "????"), "is no base64");
  expect_refused(std::string(good).erase(first + 16, 4), "is cut off");
  expect_refused(std::string(good).erase(first, 5), "is no base64");
  VtuGrid grid = sample();
  grid.data[0].values[4] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(vtu_text(grid), "\"pressure & <more>\" has a number that is not finite");
  grid = sample();
  grid.data[1].values.pop_back();
  expect_refused(vtu_text(grid), "\"velocity\" has 26 numbers, where there should be 27");
  grid = sample();
  grid.points.pop_back();
  expect_refused(vtu_text(grid), "no points of three coordinates");
}

TEST(VtuReader, RefusesBrokenCells) {
  VtuGrid grid = sample();
  grid.biquadratic[0][3] = 9;
  expect_refused(vtu_text(grid), "cells of points that there are not");
  grid.biquadratic[0][3] = -1;
  expect_refused(vtu_text(grid), "cells of points that there are not");
  const std::string good = vtu_text(sample());
  const std::size_t types = good.find("format=\"binary\">", good.find("Name=\"types\"")) + 16;
  // bytes 9 and 28 after a length of 2: the last four of "AgAAAAAAAAAJHA=="
  ASSERT_EQ(good.substr(types, 16), "AgAAAAAAAAAJHA==");
  expect_refused(std::string(good).replace(types, 16, "AgAAAAAAAAAJBQ=="), "cells of VTK's type 5");
  expect_refused(std::string(good).replace(types, 16, "AgAAAAAAAAAJCQ=="), "cells of a wrong number of points");
}

}  // namespace
}  // namespace turgor
