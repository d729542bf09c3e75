// Fields of a run directory: what is read, and what is refused.

#include "turgor/run/fem_fields.hpp"

#include <gtest/gtest.h>

#include "../support/balloon_fields.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::Folder;
using test::Jar;

TEST(FemFields, HaveTheMembraneFromThePoleToTheRim) {
  const Folder folder;
  test::write_fields(folder.path(), 3);
  const FemFields fields(folder.path());
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields.time(2), 0.2);
  const FemField field = fields.read(2);
  EXPECT_EQ(field.time, 0.2);
  EXPECT_EQ(field.velocity, Jar::field(1.2, 0.2).data[0].values);
  ASSERT_EQ(field.membrane.size(), 2U * Jar::nodes - 1);
  ASSERT_EQ(field.membrane_at_start.size(), field.membrane.size());
  for (std::size_t i = 0; i < field.membrane.size(); ++i) {
    const double share = i < Jar::nodes ? 1 : 2 - static_cast<double>(i) / (Jar::nodes - 1);
    const double r = i < Jar::nodes ? Jar::lid * static_cast<double>(i) / (Jar::nodes - 1) : Jar::radius(share);
    EXPECT_NEAR(field.membrane[i][0], r, 1e-12);
    EXPECT_NEAR(field.membrane[i][1], 1.2 * Jar::height * share, 1e-12);
    EXPECT_NEAR(field.membrane_at_start[i][0], r, 1e-12);
    EXPECT_NEAR(field.membrane_at_start[i][1], Jar::height * share, 1e-12);
  }
}

// A channel lies below the orifice, and its wall is no membrane.
TEST(FemFields, LeaveTheChannelOut) {
  const Folder folder;
  test::write_fields(folder.path(), 1);
  VtuGrid grid = Jar::field(1.1, 0);
  for (std::size_t i = 0; i < grid.points.size(); i += 3) grid.points[i + 1] -= Jar::height / 4;  // two rows
  test::write(folder / "fields/flow-0.vtu", vtu_text(grid));
  const FemField field = FemFields(folder.path()).read(0);
  ASSERT_EQ(field.membrane.size(), 2U * Jar::nodes - 3);
  EXPECT_NEAR(field.membrane_at_start.back()[1], 0, 1e-12);
}

void expect_refused(const Folder& folder, const std::string& file, const std::string& problem) {
  try {
    (void)FemFields(folder.path()).read(0);
    ADD_FAILURE() << "not refused: " << problem;
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().key, "--fem");
    EXPECT_EQ(error.issues().front().value, "\"" + (folder / file).string() + "\"");
    EXPECT_NE(error.issues().front().problem.find(problem), std::string::npos) << error.what();
  }
}

TEST(FemFields, RefuseRunsWithoutFields) {
  const Folder folder;
  try {
    (void)FemFields(folder.path());
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_NE(error.issues().front().problem.find("has no fields.pvd"), std::string::npos);
  }
  test::write(folder / "fields.pvd", pvd_text({}));
  expect_refused(folder, "fields.pvd", "lists no fields");
  test::write(folder / "fields.pvd", pvd_text({{0, "a"}, {1, "b"}, {1, "c"}}));
  expect_refused(folder, "fields.pvd", "t = 1 s does not come after the field before");
  test::write(folder / "fields.pvd", "half a f");
  expect_refused(folder, "fields.pvd", "no whole XML document");
  test::write(folder / "fields.pvd", pvd_text({{0, "fields/flow-0.vtu"}}));
  expect_refused(folder, "fields/flow-0.vtu", "cannot be read");
}

TEST(FemFields, RefuseFieldsOfSomethingElse) {
  const Folder folder;
  test::write_fields(folder.path(), 1);
  const std::string file = "fields/flow-0.vtu";
  const auto refuse = [&](const VtuGrid& grid, const std::string& problem) {
    test::write(folder / file, vtu_text(grid));
    expect_refused(folder, file, problem);
  };
  const VtuGrid good = Jar::field(1, 0);
  VtuGrid grid = good;
  grid.data[0].name = "speed";
  refuse(grid, "has no vectors \"velocity\"");
  grid = good;
  grid.data[1] = {"displacement", 1, std::vector<double>(grid.points.size() / 3, 0.0)};
  refuse(grid, "has no vectors \"displacement\"");
  grid = good;
  grid.points[0] = -0.1;
  refuse(grid, "far side of the axis");
  grid = good;
  grid.quadrilaterals = {{0, 1, 10, 9}};
  refuse(grid, "has not cells of nine points alone");
  grid = good;
  grid.biquadratic.clear();
  refuse(grid, "has not cells of nine points alone");
  grid = good;
  for (std::size_t i = 0; i < grid.points.size(); i += 3) grid.points[i] += 0.2;  // nothing on the axis
  refuse(grid, "not one line from the axis to the orifice");
  grid = good;
  for (std::size_t i = 0; i < grid.points.size(); i += 3) grid.points[i + 1] -= 1;  // a channel alone
  refuse(grid, "has no wall");
  const std::string whole = vtu_text(good);
  test::write(folder / file, whole.substr(0, whole.size() - 20));
  expect_refused(folder, file, "no whole XML document");
}

}  // namespace
}  // namespace turgor
