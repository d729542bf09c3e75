// turgor fem statics, and what it knows before turgor fem fsi begins.

#include "cli/fem_statics_command.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../membrane/shooting.hpp"
#include "../support/csv.hpp"
#include "../support/program.hpp"
#include "cli/guarded.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/membrane_study.hpp"

namespace turgor {
namespace {

using nlohmann::json;
using test::contents;
using test::Csv;
using test::Folder;
using test::shipped;

struct Finished {
  int code;
  std::string out;
  std::string err;
};

Finished fem_statics(std::vector<std::string> words) {
  words.insert(words.begin(), "statics");
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  CLI::App app;
  cli::FemStaticsArguments arguments;
  cli::add_fem_statics(app, arguments);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  int code = cli::exit_bad_input;
  try {
    app.parse(words);
    code = cli::guarded(arguments.input.json, [&] { return cli::print_fem_statics(arguments); });
  } catch (const CLI::ParseError& error) {
    app.exit(error);
  }
  const std::string out = testing::internal::GetCapturedStdout();
  return {code, out, testing::internal::GetCapturedStderr()};
}

/// Of the paper's balloon with a 3 cm orifice up to R = 2.2, where `more` does not say otherwise.
Finished paper(std::vector<std::string> more, const std::string& up_to = "2.2") {
  more.insert(more.begin(), {shipped("orifice-30mm"), "--up-to", up_to});
  return fem_statics(more);
}

json parsed(const Finished& run) {
  EXPECT_EQ(run.code, 0) << run.err;
  return json::parse(run.out);
}

double number(const json& value) { return value.get<double>(); }

// By shooting from the pole, without elements. The chain is within 2e-6 at R = 1.1 (docs/membrane.md).
TEST(FemStatics, AgreesWithShooting) {
  const Case c = read_case(shipped("orifice-30mm"), {"wall.bending_stiffness=0 N m"});
  const Shooting shooting({c.parameters.material, c.parameters.thickness, c.parameters.solid_density},
                          c.parameters.radius, c.parameters.orifice_radius);
  for (const double pole : {1.1, 1.5, 2.2}) {
    const ShotState expected = shooting.at(pole);
    const MembraneStudy study = study_membrane(c, {.up_to = 1.5, .volume = expected.volume});
    EXPECT_NEAR(study.at_volume->state.pressure / expected.pressure, 1, 1e-5);
    EXPECT_NEAR(study.at_volume->state.radius / expected.radius, 1, 1e-5);
  }
}

// The area under the curve of pressure over volume is the energy in the wall: trapezoids of 60 states are within 2e-3.
TEST(FemStatics, CurveOfThePaperSBalloon) {
  const Folder folder;
  const auto run = paper({"-o", (folder / "out").string()});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("maximum of 44812.0"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("(3.1): 44718.527 Pa at R = 1.47607; the membrane is +0.209 % in pressure"), std::string::npos)
      << run.out;
  const Csv table(folder / "out" / "statics.csv");
  double work = 0;
  int limits = 0;
  for (std::size_t i = 1; i < table.size(); ++i) {
    work += (table(i, "p_gauge [Pa]") + table(i - 1, "p_gauge [Pa]")) / 2 *
            (table(i, "volume [m^3]") - table(i - 1, "volume [m^3]"));
    const double R = table(i, "R [1]");
    EXPECT_NEAR(table(i, "r_eff [m]"), 0.3 * R, 1e-12);
    EXPECT_NEAR(table(i, "p_sphere [Pa]"), 6e3 * (1 / R - std::pow(R, -7)) * (10 + R * R), 1e-6);
    EXPECT_NEAR(table(i, "z_top [m]") / (2 * table(i, "r_max [m]")), 1, 0.01);  // a sphere but for the hole
    limits += table.text(i, "limit_point") == "1" ? 1 : 0;
    const bool beyond = R > 1.47612 + 1e-4;
    EXPECT_EQ(table.text(i, "unstable_at_pressure"), beyond ? "1" : "0") << R;
    EXPECT_EQ(table.text(i, "unstable_at_volume"), "0") << R;
  }
  const std::size_t last = table.size() - 1;
  EXPECT_EQ(limits, 1);
  EXPECT_NEAR(table(last, "R [1]"), 2.2, 1e-4);
  EXPECT_NEAR(work / table(last, "elastic_energy [J]"), 1, 2e-3);
}

TEST(FemStatics, Files) {
  const Folder folder;
  const std::string out = (folder / "out").string();
  const auto run = paper({"-o", out, "--json"}, "2");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, contents(folder / "out" / "statics.json"));
  EXPECT_EQ(contents(folder / "out" / "statics.png").substr(1, 3), "PNG");
  const Csv shapes(folder / "out" / "shapes.csv");
  EXPECT_EQ(shapes.size(), 7U * 97U);  // slack, five more, the limit point; 48 elements
  EXPECT_NEAR(shapes(0, "r [m]"), 0.03, 1e-15);
  EXPECT_EQ(shapes.text(96, "r [m]"), "0");
  EXPECT_NEAR(shapes(96, "z [m]"), 0.3 + std::sqrt(0.09 - 0.0009), 1e-12);
  EXPECT_EQ(shapes.text(shapes.size() - 1, "shape"), "7");
  const auto again = paper({"-o", out}, "2");
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("--force"), std::string::npos) << again.err;
  EXPECT_EQ(paper({"-o", out, "--force", "--no-pictures"}, "2").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "statics.png"));
}

// By itself the curve goes beyond the second stable branch, to where the limit point's pressure is held again.
TEST(FemStatics, EquilibriaOfABistablePressure) {
  const json study = parsed(fem_statics({shipped("orifice-30mm"), "--pressure", "42 kPa", "--json"}));
  ASSERT_EQ(study.at("limit_points").size(), 2U);
  EXPECT_EQ(study.at("limit_points")[1].at("kind"), "minimum");
  EXPECT_NEAR(number(study.at("limit_points")[1].at("sphere").at("R_difference_percent")), -0.067, 2e-3);
  ASSERT_EQ(study.at("equilibria").size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const json& state = study.at("equilibria")[i];
    EXPECT_NEAR(number(state.at("pressure_Pa")), 42e3, 1e-5);
    EXPECT_EQ(state.at("stable"), i != 1);
    EXPECT_NEAR(number(state.at("R")) / number(study.at("sphere_equilibria")[i].at("R")), 1, 0.02);
  }
  EXPECT_GT(number(study.at("end").at("R")), 5.69);
  EXPECT_TRUE(study.at("why_no_equilibrium").is_null());
}

// 7^(1/6) and the pressure there are the sphere's; the hole of r0/10 moves both by its square.
TEST(FemStatics, ABalloonThatBursts) {
  const json study = parsed(fem_statics({shipped("material-neo-hookean"), "--json"}));
  ASSERT_EQ(study.at("limit_points").size(), 1U);
  EXPECT_NEAR(number(study.at("limit_points")[0].at("R")), std::pow(7, 1.0 / 6), 0.01);
  EXPECT_NEAR(number(study.at("limit_points")[0].at("pressure_Pa")) / 4958, 1, 0.01);
  const auto burst = fem_statics({shipped("material-neo-hookean"), "--pressure", "9 kPa"});
  EXPECT_EQ(burst.code, 2);
  EXPECT_NE(burst.err.find("--pressure = 9000 Pa: no state of rest up to R = "), std::string::npos) << burst.err;
  EXPECT_NE(burst.err.find("bursts, nothing holds it beyond its limit point, 4968."), std::string::npos) << burst.err;
  EXPECT_NE(burst.err.find("(R = 1.38"), std::string::npos) << burst.err;
  EXPECT_NE(burst.err.find("--volume"), std::string::npos) << burst.err;
  const auto result = fem_statics(
      {shipped("material-neo-hookean"), "--set", "pressure={constant=\"9 kPa\"}", "--set", "initial.stretch=1.0"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("bursts"), std::string::npos) << result.out;
}

TEST(FemStatics, AMaterialWithoutALimitPoint) {
  const auto run = fem_statics({shipped("material-fung"), "--up-to", "2.2"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("none up to R = 2.2"), std::string::npos) << run.out;
  const auto asked = fem_statics({shipped("material-fung"), "--limit-point"});
  EXPECT_EQ(asked.code, 2);
  EXPECT_NE(asked.err.find("--limit-point: there is none up to R = "), std::string::npos) << asked.err;
  EXPECT_NE(asked.err.find("try a larger --up-to"), std::string::npos) << asked.err;
  EXPECT_EQ(paper({"--limit-point"}, "1.6").code, 0);
}

// The slack balloon holds Zoelly's 1320 Pa of suction, and a volume a little less than its own.
TEST(FemStatics, Buckling) {
  const json sucked = parsed(paper({"--pressure", "-1.2 kPa", "--volume", "112.5 L", "--json"}, "1.2"));
  EXPECT_EQ(sucked.at("equilibria").at(0).at("stable"), true);
  EXPECT_LT(number(sucked.at("equilibria").at(0).at("R")), 1);
  EXPECT_EQ(sucked.at("at_volume").at("unstable_modes_at_pressure"), 0);
  const auto buckled = paper({"--pressure", "-1.4 kPa"}, "1.2");
  EXPECT_EQ(buckled.code, 2);
  EXPECT_NE(buckled.err.find("--pressure = -1400 Pa"), std::string::npos) << buckled.err;
  EXPECT_NE(buckled.err.find("the last one is at a gauge pressure of -131"), std::string::npos) << buckled.err;
  EXPECT_NE(buckled.err.find("Under suction the membrane buckles"), std::string::npos) << buckled.err;
  const auto small = paper({"--volume", "100 L"}, "1.2");
  EXPECT_EQ(small.code, 2);
  EXPECT_NE(small.err.find("--volume = 0.1 m^3"), std::string::npos) << small.err;
  EXPECT_NE(small.err.find("slack it has 0.113095 m^3, with less it buckles"), std::string::npos) << small.err;
}

TEST(FemStatics, Mistakes) {
  const auto message = [](const Finished& run) {
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_NE(message(paper({}, "1")).find("--up-to = 1: out of range; allowed is > 1"), std::string::npos);
  EXPECT_NE(message(paper({}, "wide")).find("--up-to = wide: is not a number"), std::string::npos);
  EXPECT_NE(message(fem_statics({shipped("material-gent"), "--up-to", "9"})).find("where the material locks"),
            std::string::npos);
  EXPECT_NE(message(paper({"--pressure", "60 kPa"})).find("(3.1) has one at R = 8.87301; try --up-to 9.76"),
            std::string::npos);
  EXPECT_NE(message(paper({"--pressure", "60"})).find("--pressure"), std::string::npos);
  EXPECT_NE(message(paper({"--volume", "3 Pa"})).find("dimension"), std::string::npos);
  EXPECT_NE(message(paper({"--volume", "-3 L"})).find("allowed is > 0"), std::string::npos);
  EXPECT_NE(message(fem_statics({shipped("motion-orifice-30mm")})).find("motion"), std::string::npos);
  EXPECT_NE(message(fem_statics({shipped("material-table")})).find("material.model = table: a table of equal biaxial"),
            std::string::npos);
}

/// Warnings of the shipped case of `turgor fem fsi` under another pressure and start.
std::vector<Warning> warnings(const std::string& segments, const std::string& stretch = "1.0",
                              const std::string& name = "coupled-orifice-30mm") {
  return membrane_warnings(read_case(shipped(name), {"pressure.segments=" + segments, "initial.stretch=" + stretch}));
}

TEST(MembraneWarnings, NoneBelowTheLimitPoint) {
  EXPECT_TRUE(warnings(R"([{ to = "38 kPa", over = "1 s" }])").empty());
  EXPECT_TRUE(warnings(R"([{ to = "44.8 kPa", over = "1 s" }])").empty());  // above (3.1)'s 44.72, below 44.81
  EXPECT_TRUE(warnings(R"([{ to = "-1 kPa", over = "1 s" }])").empty());
  EXPECT_TRUE(warnings(R"([{ to = "500 Pa", over = "1 s" }])", "1.0", "material-fung").empty());
  EXPECT_TRUE(warnings(R"([{ step = "46 kPa" }, { hold = "1 s" }])", "6.0").empty());  // on the second branch already
}

TEST(MembraneWarnings, SnapsOrBurstsAboveIt) {
  const auto snaps = warnings(R"([{ to = "44.9 kPa", over = "1 s" }, { to = "0 Pa", over = "1 s" }])");
  ASSERT_EQ(snaps.size(), 1U);
  EXPECT_EQ(snaps[0].name, "membrane-limit");
  for (const char* part : {"reaches 44900 Pa", "44812 Pa at r_eff = 0.44284 m (R = 1.4761)", "snaps", "(R = 5.7"}) {
    EXPECT_NE(snaps[0].text.find(part), std::string::npos) << snaps[0].text;
  }
  const auto bursts = warnings(R"([{ to = "5 kPa", over = "1 s" }])", "1.0", "material-neo-hookean");
  ASSERT_EQ(bursts.size(), 1U);
  EXPECT_NE(bursts[0].text.find("bursts"), std::string::npos) << bursts[0].text;
}

// What `turgor fem fsi` asks before anything else.
TEST(MembraneWarnings, RefuseATableOfEqualBiaxialStretch) {
  try {
    (void)membrane_warnings(read_case(shipped("material-table")));
    FAIL() << "expected InvalidInput";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().key, "material.model");
  }
}

TEST(MembraneWarnings, Buckles) {
  const auto sucked = warnings(R"([{ to = "-2 kPa", over = "1 s" }])");
  ASSERT_EQ(sucked.size(), 1U);
  EXPECT_EQ(sucked[0].name, "membrane-buckling");
  EXPECT_NE(sucked[0].text.find("falls to -2000 Pa"), std::string::npos) << sucked[0].text;
  try {
    (void)warnings(R"([{ hold = "1 s" }])", "0.9");
    FAIL() << "expected InvalidInput";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().key, "initial.stretch");
  }
  EXPECT_TRUE(warnings(R"([{ hold = "1 s" }])", "0.999").empty());
}

}  // namespace
}  // namespace turgor
