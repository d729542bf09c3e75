// Balloons whose wall is given by a table, next to those of the closed material it was made of.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "turgor/base/text.hpp"
#include "turgor/run/info.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {
namespace {

/// The paper's balloon with another wall, as an override of its [material].
Case paper_case(const std::string& material, std::vector<std::string> more = {}) {
  more.push_back("material=" + material);
  return read_case(std::filesystem::path(TURGOR_CASES) / "orifice-30mm.toml", more);
}

/// Points of the paper's wall from `least` to `greatest`, 1 among them.
std::string table_of_paper(double least, double greatest, int below, int above) {
  const Material<double> rubber = MooneyRivlin<double>{1.5e6, 1.5e5};
  std::string stretch;
  std::string stress;
  for (int i = -below; i <= above; ++i) {
    const double l = i < 0 ? 1 + (1 - least) * i / below : 1 + (greatest - 1) * i / above;
    stretch += (stretch.empty() ? "" : ", ") + shortest(l) + (i == 0 ? ".0" : "");
    stress += (stress.empty() ? "\"" : ", \"") + shortest(strain_energy(rubber, l).first / 2) + " Pa\"";
  }
  return "{ model = \"table\", table = { stretch = [" + stretch + "], stress = [" + stress + "] } }";
}

bool warns(const RunResult& result, const std::string& name, const std::string& words = "") {
  return std::ranges::any_of(
      result.warnings, [&](const Warning& w) { return w.name == name && w.text.find(words) != std::string::npos; });
}

/// Greatest difference in R over the filling and the first emptying from the paper's wall.
double distance(const Case& c, const RunResult& exact) {
  const RunResult found = run_case(c);
  double worst = 0;
  const double end = exact.trajectory->last.time;
  for (int i = 0; i <= 500; ++i) {
    const double T = end * i / 500 * exact.oscillator->scales().time / found.oscillator->scales().time;
    worst = std::max(worst, std::abs(found.trajectory->at(T).stretch - exact.trajectory->at(end * i / 500).stretch));
  }
  return worst;
}

// The spline's stress is off by h^4 s''''/384, at 16 points within the motion (R up to 1.18) 1e-6 of the stiffness at
// most; the slow balloon follows its equilibrium, whose dR/ds is the inverse of that stiffness. Half the distance of
// points leaves a sixteenth, down to the run's own error of some 1e-8.
TEST(TabulatedWall, MovesAsTheMaterialItWasTakenFrom) {
  const std::vector<std::string> settings{"pressure.segments[0].over=6 s", "solve.t_end=8 s", "solve.rtol=1e-10"};
  const RunResult exact =
      run_case(paper_case(R"({ model = "mooney-rivlin", s1 = "1.5 MPa", s2 = "0.15 MPa" })", settings));
  ASSERT_EQ(exact.status(), "complete");
  const double coarse = distance(paper_case(table_of_paper(0.8, 1.8, 4, 16), settings), exact);
  const double fine = distance(paper_case(table_of_paper(0.8, 1.8, 8, 32), settings), exact);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(coarse / fine, 10);
  EXPECT_LT(distance(paper_case(table_of_paper(0.8, 1.8, 40, 160), settings), exact), 5e-8);
}

// Energy has nothing to do with how often the force can be differentiated: as for the closed materials.
TEST(TabulatedWall, KeepsTheEnergyBalance) {
  const RunResult result = run_case(paper_case(table_of_paper(0.8, 1.8, 4, 16)));
  ASSERT_EQ(result.status(), "complete");
  EXPECT_LT(*result.quantity("energy_error"), 5e-8);
  EXPECT_GT(*result.quantity("dissipated"), 0);
}

// Two integrators that share nothing but the force; 1e-7: the adaptive one's error at rtol 1e-10 over a few strokes.
TEST(TabulatedWall, MovesTheSameByQuadrature) {
  const std::vector<std::string> settings{"pressure={ constant = \"20 kPa\" }", "solve.t_end=3 s", "solve.rtol=1e-10"};
  auto by_quadrature = settings;
  by_quadrature.emplace_back("solve.method=quadrature");
  const std::string table = table_of_paper(0.8, 1.8, 4, 16);
  EXPECT_LT(distance(paper_case(table, by_quadrature), run_case(paper_case(table, settings))), 1e-7);
}

TEST(TabulatedWall, WarnsWhenTheMotionLeavesTheTable) {
  const RunResult within = run_case(paper_case(table_of_paper(0.9, 1.3, 4, 16)));
  EXPECT_FALSE(warns(within, "table-range"));
  const RunResult above = run_case(paper_case(table_of_paper(0.9, 1.1, 4, 16)));
  EXPECT_TRUE(warns(above, "table-range", "from 0.9 to 1.1"));
  const RunResult below =
      run_case(paper_case(table_of_paper(1, 1.3, 0, 16), {"pressure={ constant = \"-5 kPa\" }", "solve.t_end=5 s"}));
  EXPECT_TRUE(warns(below, "table-range", "from 1 to 1.3"));
  EXPECT_EQ(below.status(), "complete");
}

// At 40 kPa the paper's balloon rests at R = 1.23, 2.22 and 4.39. A straight line that goes on for ever makes others.
TEST(TabulatedWall, InfoTellsOfRestBeyondTheTable) {
  const auto says = [](const std::string& table, const std::string& words) {
    const Case c = paper_case(table, {"pressure.segments[0].to=40 kPa"});
    return info_text(c, case_info(c)).find(words) != std::string::npos;
  };
  const std::string narrow = table_of_paper(0.9, 1.3, 4, 16);
  EXPECT_TRUE(says(narrow, "beyond material.table, which goes from 0.9 to 1.3"));
  EXPECT_TRUE(says(narrow, "the equilibrium at R = "));
  const std::string wide = table_of_paper(0.9, 12, 4, 200);
  for (const char* known : {"R = 1.23", "R = 2.22", "R = 4.389"}) {
    EXPECT_TRUE(says(wide, known));
    EXPECT_FALSE(says(wide, "the equilibrium at " + std::string(known)));
  }
}

// What the shipped table was computed from; its points are 5 % apart, its numbers have seven digits.
TEST(TabulatedWall, ShippedTableIsOgdensRubber) {
  const auto shipped = [](const char* name) {
    return read_case(std::filesystem::path(TURGOR_CASES) / (std::string(name) + ".toml"));
  };
  const Case table = shipped("material-table");
  const Case ogden = shipped("material-ogden");
  const double stiffness = strain_energy(ogden.parameters.material, 1.0).second;
  for (double l = 0.8; l < 6; l += 0.013) {
    const double expected = strain_energy(ogden.parameters.material, l).first;
    EXPECT_NEAR(strain_energy(table.parameters.material, l).first, expected, 2e-4 * stiffness) << l;
  }
  EXPECT_LT(distance(table, run_case(ogden)), 1e-3);
}

}  // namespace
}  // namespace turgor
