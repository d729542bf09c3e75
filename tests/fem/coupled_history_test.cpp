// What `turgor verify` reads of an elastic balloon is what `turgor fem fsi` writes.

#include <gtest/gtest.h>

#include "../support/program.hpp"
#include "turgor/fem/flow_tables.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {
namespace {

TEST(CoupledHistory, IsReadBack) {
  const Case c =
      read_case(test::shipped("orifice-30mm"),
                {"output={time_unit=\"ms\", length_unit=\"mm\", pressure_unit=\"kPa\", energy_unit=\"kJ\"}"});
  FlowRow row{};
  row.time = 1.25;
  row.gauge_pressure = c.pressure(row.time);
  row.radius = 0.3125;
  row.rate = -0.02;
  row.top = 7;  // other columns may hold anything
  const test::Folder folder;
  test::write(folder / "resolved.toml", c.resolved);
  test::write(folder / "run.json", R"({"status": "complete"})");
  test::write(folder / "history.csv",
              history_header(c.output, history_kind(c)) + "\n" + history_line(c.output, history_kind(c), row) + "\n");
  const FemResponse run = read_fem_response(c, folder.path());
  ASSERT_EQ(run.rows.size(), 1U);
  EXPECT_DOUBLE_EQ(run.rows[0].time, row.time);
  EXPECT_DOUBLE_EQ(run.rows[0].gauge_pressure, row.gauge_pressure);
  EXPECT_DOUBLE_EQ(run.rows[0].radius, row.radius);
  EXPECT_DOUBLE_EQ(run.rows[0].rate, row.rate);
  EXPECT_TRUE(run.warnings.empty());
}

}  // namespace
}  // namespace turgor
