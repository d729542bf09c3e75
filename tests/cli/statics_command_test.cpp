// turgor statics, as a user meets it.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::shipped;
using test::turgor;

/// The shipped case, at rest under another final pressure.
std::vector<std::string> paper_at(const std::string& pressure) {
  return {"statics", shipped("orifice-30mm"), "--set", "pressure.segments[2].to=" + pressure};
}

json statics(const Folder& folder, std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json::parse(result.out);
}

double number(const json& value) { return value.get<double>(); }

// S2 p_typ = 6 kPa.
TEST(StaticsCommand, ThePaperSBalloon) {
  const Folder folder;
  const json study = statics(folder, paper_at("41313.6008025 Pa"));
  constexpr double S2 = 6000;
  EXPECT_EQ(study.at("pressure_Pa"), 41313.6008025);
  ASSERT_EQ(study.at("limit_points").size(), 2U);
  EXPECT_EQ(study.at("limit_points")[0].at("kind"), "maximum");
  EXPECT_NEAR(number(study.at("limit_points")[0].at("R")), 1.47606984746, 1e-11);
  EXPECT_NEAR(number(study.at("limit_points")[0].at("pressure_Pa")), 7.45308777840 * S2, 1e-6);
  EXPECT_NEAR(number(study.at("limit_points")[1].at("R")), 3.14262133321, 1e-11);
  EXPECT_NEAR(number(study.at("bistable_window_Pa")[0]), 6.31811248909 * S2, 1e-6);
  EXPECT_NEAR(number(study.at("bistable_window_Pa")[1]), 7.45308777840 * S2, 1e-6);
  ASSERT_EQ(study.at("equilibria").size(), 3U);
  EXPECT_NEAR(number(study.at("equilibria")[0].at("R")), 1.25820103338, 1e-9);
  EXPECT_EQ(study.at("equilibria")[1].at("stable"), false);
  EXPECT_NEAR(number(study.at("equilibria")[2].at("R")), 4.80498978552, 1e-9);
  const double maxwell = number(study.at("maxwell_pressure_Pa"));
  const json at_maxwell = statics(folder, paper_at(std::to_string(maxwell) + " Pa"));
  const json& wells = at_maxwell.at("wells");
  ASSERT_EQ(wells.size(), 2U);
  EXPECT_NEAR(number(wells[0].at("energy_J")), number(wells[1].at("energy_J")), 0.01);  // pressure of six decimals
  EXPECT_NEAR(number(wells[0].at("barrier_above_J")), number(wells[1].at("barrier_below_J")), 0.01);
  EXPECT_TRUE(wells[0].at("barrier_below_J").is_null());
  ASSERT_EQ(study.at("jumps").size(), 2U);
  EXPECT_EQ(study.at("jumps")[0].at("direction"), "inflating");
  EXPECT_GT(number(study.at("jumps")[0].at("released_J")), 0);
  EXPECT_LT(number(study.at("jumps")[1].at("to_R")), 1.47);
}

TEST(StaticsCommand, OutsideOfTheWindowThereIsOneState) {
  const Folder folder;
  for (const char* pressure : {"30 kPa", "50 kPa", "-10 kPa", "0 Pa"}) {
    const json study = statics(folder, paper_at(pressure));
    ASSERT_EQ(study.at("equilibria").size(), 1U) << pressure;
    EXPECT_EQ(study.at("equilibria")[0].at("stable"), true);
    EXPECT_FALSE(study.at("bistable_window_Pa").is_null());
    EXPECT_TRUE(study.at("wells")[0].at("barrier_above_J").is_null());
  }
  const json compressed = statics(folder, paper_at("-10 kPa"));
  EXPECT_LT(number(compressed.at("equilibria")[0].at("R")), 1);
}

TEST(StaticsCommand, AMaterialWithoutASecondBranch) {
  const Folder folder;
  const json study = statics(folder, {"statics", shipped("material-neo-hookean")});
  ASSERT_EQ(study.at("limit_points").size(), 1U);
  EXPECT_TRUE(study.at("bistable_window_Pa").is_null());
  EXPECT_TRUE(study.at("maxwell_pressure_Pa").is_null());
  EXPECT_TRUE(study.at("jumps")[0].at("to_R").is_null());
  const auto burst = turgor(folder, {"statics", shipped("material-neo-hookean"), "--set",
                                     "pressure={constant=\"9 kPa\"}", "--set", "initial.stretch=1.0"});
  EXPECT_EQ(burst.code, 0) << burst.err;
  EXPECT_NE(burst.out.find("the wall cannot hold it"), std::string::npos) << burst.out;
  EXPECT_NE(burst.out.find("nothing holds the balloon beyond"), std::string::npos);
}

TEST(StaticsCommand, APressureThatOnlyRises) {
  const Folder folder;
  auto arguments = paper_at("30 kPa");
  arguments.insert(arguments.end(), {"--set", "material.s1=0.6 MPa", "--compliance", "1 m^3/Pa"});
  const json study = statics(folder, arguments);
  for (const char* key : {"limit_points", "jumps", "bistable_windows"}) EXPECT_TRUE(study.at(key).empty()) << key;
  for (const char* key : {"bistable_window_Pa", "maxwell_pressure_Pa", "critical_compliance_m3_per_Pa"}) {
    EXPECT_TRUE(study.at(key).is_null()) << key;
  }
  EXPECT_TRUE(study.at("supply").at("jumps").empty());
}

TEST(StaticsCommand, EveryShippedMaterialAndClosure) {
  const Folder folder;
  for (const char* name : {"gent", "gent-gent", "ogden", "fung", "yeoh", "arruda-boyce"}) {
    const json study = statics(folder, {"statics", shipped(std::string("material-") + name)});
    EXPECT_EQ(study.at("material"), name);
    EXPECT_FALSE(study.at("equilibria").empty()) << name;
    EXPECT_EQ(study.dump().find("nan"), std::string::npos);
  }
  auto arguments = paper_at("42 kPa");
  arguments.insert(arguments.end(), {"--set", "model.closure=potential", "--set", "inlet.orifice_radius=15 cm"});
  const json exact = statics(folder, arguments);
  const json fitted = statics(folder, paper_at("42 kPa"));
  // E/(R^2 h1) at the maximum, which hardly moves; h1 = (1 + sqrt(1 - kappa^2))/2
  const double ratio =
      number(exact.at("limit_points")[0].at("pressure_Pa")) / number(fitted.at("limit_points")[0].at("pressure_Pa"));
  const double kappa = 0.5 / number(fitted.at("limit_points")[0].at("R"));
  EXPECT_NEAR(ratio, 2 / (1 + std::sqrt(1 - kappa * kappa)), 1e-3);
}

TEST(StaticsCommand, ASupplyMakesItJump) {
  const Folder folder;
  const double critical = number(statics(folder, paper_at("42 kPa")).at("critical_compliance_m3_per_Pa"));
  auto arguments = paper_at("42 kPa");
  arguments.insert(arguments.end(), {"--compliance", std::to_string(0.9 * critical) + " m^3/Pa"});
  const json stiff = statics(folder, arguments);
  EXPECT_TRUE(stiff.at("supply").at("jumps").empty());
  for (const json& state : stiff.at("equilibria")) EXPECT_EQ(state.at("stable_with_supply"), true);
  arguments.back() = std::to_string(2e3 * critical) + " m^3/kPa";  // twice
  EXPECT_EQ(statics(folder, arguments).at("supply").at("jumps").size(), 2U);
}

TEST(StaticsCommand, OverTheRatioOfTheMaterialTheCuspIsWhereItIsKnownToBe) {
  const Folder folder;
  auto arguments = paper_at("42 kPa");
  arguments.insert(arguments.end(), {"--over", "material.s1=0.5 MPa:2 MPa"});
  const json over = statics(folder, arguments).at("over");
  EXPECT_EQ(over.at("key"), "material.s1");
  ASSERT_EQ(over.at("critical").size(), 1U);
  EXPECT_NEAR(number(over.at("critical")[0].at("value")) / 0.15e6, 4.662910048479262, 1e-10);
  ASSERT_EQ(over.at("limit_points").size(), 1U);
  const json& cusp = over.at("limit_points")[0].at("turning_points").at(0);
  EXPECT_NEAR(number(cusp.at("value")) / 0.15e6, 4.662910048479262, 1e-10);
  ASSERT_EQ(over.at("equilibria").size(), 1U);
  const json& folds = over.at("equilibria")[0].at("turning_points");
  ASSERT_EQ(folds.size(), 2U);
  for (const json& fold : folds) {  // the pressure is that of a limit point there
    auto there = paper_at("42 kPa");
    there.insert(there.end(), {"--set", "material.s1=" + fold.at("value").dump() + " Pa"});
    double nearest = 1e9;
    const json at = statics(folder, there);
    for (const json& point : at.at("limit_points")) {
      nearest = std::min(nearest, std::abs(number(point.at("pressure_Pa")) - 42e3));
    }
    EXPECT_LT(nearest, 42e3 * 1e-10);
  }
}

TEST(StaticsCommand, OverThePressureTheCurveTurnsAtTheLimitPoints) {
  const Folder folder;
  auto arguments = paper_at("0 Pa");
  arguments.insert(arguments.end(),
                   {"--over", "pressure.segments[2].to=30 kPa:50 kPa", "--set", "initial.stretch=equilibrium"});
  const json study = statics(folder, arguments);
  const json& folds = study.at("over").at("equilibria").at(0).at("turning_points");
  ASSERT_EQ(folds.size(), 2U);
  for (std::size_t i : {0U, 1U}) {
    EXPECT_NEAR(number(folds[i].at("value")) / number(study.at("limit_points")[i].at("pressure_Pa")), 1, 1e-12);
    EXPECT_NEAR(number(folds[i].at("R")), number(study.at("limit_points")[i].at("R")), 1e-10);
  }
}

TEST(StaticsCommand, Files) {
  const Folder folder;
  auto arguments = paper_at("42 kPa");
  arguments.insert(arguments.end(), {"--over", "pressure.segments[2].to=20 kPa:60 kPa", "--over",
                                     "material.s1=0.5 MPa:2 MPa", "-o", "out"});
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* name : {"statics", "over", "plane", "bistability"}) {
    EXPECT_EQ(contents(folder / "out" / (std::string(name) + ".png")).substr(1, 3), "PNG") << name;
    EXPECT_TRUE(fs::exists(folder / "out" / (std::string(name) + ".svg"))) << name;
  }
  EXPECT_TRUE(contents(folder / "out" / "statics.csv")
                  .starts_with("R [1],volume [m^3],p_gauge [Pa],strain_energy [J],potential_energy [J],stable\n1,"));
  const std::string branches = contents(folder / "out" / "branches.csv");
  EXPECT_TRUE(
      branches.starts_with("curve,number,pressure.segments[2].to [Pa],material.s1 [Pa],R [1],p_gauge "
                           "[Pa],stable,turns\nequilibria,1,20000,,"));
  EXPECT_NE(branches.find("\nplane,1,"), std::string::npos);
  EXPECT_EQ(json::parse(contents(folder / "out" / "statics.json")).at("pressure_Pa"), 42e3);
  EXPECT_EQ(turgor(folder, arguments).code, 2);
  arguments.insert(arguments.end(), {"--force", "--no-pictures"});
  EXPECT_EQ(turgor(folder, arguments).code, 0);
  EXPECT_FALSE(fs::exists(folder / "out" / "statics.png"));
}

// A folder of pictures whatever the balloon: none of these has everything that can be drawn.
TEST(StaticsCommand, PicturesOfWhatThereIs) {
  const Folder folder;
  int number = 0;
  const auto draws = [&](std::vector<std::string> arguments) {
    const std::string out = "out" + std::to_string(number++);
    arguments.insert(arguments.end(), {"-o", out});
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(contents(folder / out / "statics.png").substr(1, 3), "PNG");
  };
  draws({"statics", shipped("material-neo-hookean"), "--over", "material.mu=0.1 MPa:1 MPa"});
  draws({"statics", shipped("material-neo-hookean"), "--set", "pressure={constant=\"9 kPa\"}", "--set",
         "initial.stretch=1.0", "--over", "balloon.thickness=1 mm:1.1 mm"});
  draws({"statics", shipped("material-gent"), "--set", "material.jm=0.5", "--set", "initial.stretch=1.0"});
  auto compressed = paper_at("-10 kPa");
  compressed.insert(compressed.end(), {"--set", "material.s1=0.5 MPa"});
  draws(compressed);
}

TEST(StaticsCommand, Mistakes) {
  const Folder folder;
  const auto message = [&](const std::vector<std::string>& more, const std::string& name = "orifice-30mm") {
    std::vector<std::string> arguments{"statics", shipped(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  const auto over = [&](const std::string& text) { return message({"--over", text}); };
  for (const char* text : {"material.s1", "material.s1=1 MPa", "material.s1=1 MPa:2 MPa:3 MPa", ""}) {
    EXPECT_NE(over(text).find("--over"), std::string::npos) << text;
  }
  EXPECT_NE(over("material.s3=1 MPa:2 MPa").find("did you mean \"material.s"), std::string::npos);
  EXPECT_NE(over("material.s1=1:2").find("material.s1"), std::string::npos);
  EXPECT_NE(over("material.s1=1 m:2 m").find("dimension"), std::string::npos);
  EXPECT_NE(over("material.s1=2 MPa:1 MPa").find("FROM must be less than TO"), std::string::npos);
  EXPECT_NE(over("balloon.radius=-1 cm:10 cm").find("> 0 m"), std::string::npos);
  EXPECT_NE(over("material.model=a:b").find("does not take a number"), std::string::npos);
  EXPECT_NE(over("solve.t_end=1 s:2 s").find("no influence"), std::string::npos);
  EXPECT_NE(over("inlet.orifice_radius=1 cm:90 cm").find("orifice"), std::string::npos);
  EXPECT_NE(over("pressure.segments[7].to=1 kPa:2 kPa").find("no element [7]"), std::string::npos);
  EXPECT_NE(over("material.s1=-1 MPa:1 MPa").find("material"), std::string::npos);
  const std::string one = "material.s1=1 MPa:2 MPa";
  EXPECT_NE(message({"--over", one, "--over", one}).find("given twice"), std::string::npos);
  EXPECT_NE(message({"--over", one, "--over", "material.s2=0.1 MPa:0.2 MPa", "--over", "balloon.radius=1 cm:2 cm"})
                .find("too many"),
            std::string::npos);
  EXPECT_NE(message({"--compliance", "3"}).find("--compliance"), std::string::npos);
  EXPECT_NE(message({"--compliance", "3 Pa"}).find("dimension"), std::string::npos);
  EXPECT_NE(message({"--compliance", "-1 m^3/Pa"}).find("allowed is >= 0"), std::string::npos);
  EXPECT_NE(message({}, "motion-orifice-30mm").find("motion"), std::string::npos);
  EXPECT_EQ(turgor(folder, {"statics"}).code, 2);
  EXPECT_NE(turgor(folder, {"statik"}).err.find("statics"), std::string::npos);
}

}  // namespace
}  // namespace turgor
