// turgor portrait, as a user meets it.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../support/program.hpp"
#include "turgor/base/text.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::shipped;
using test::turgor;

const std::string balloon = shipped("orifice-30mm.toml");
const std::string bistable = "41.3136008025 kPa";

json portrait_json(const Folder& folder, std::vector<std::string> arguments, const std::string& file = balloon) {
  arguments.insert(arguments.begin(), {"portrait", file, "--json", "--no-pictures", "--force"});
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json::parse(result.out);
}

TEST(PortraitCommand, WritesItsDirectory) {
  const Folder folder;
  const auto result = turgor(folder, {"portrait", balloon, "--pressure", bistable});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("R = 1.258201033 stable, 2.004385229 unstable, 4.804989786 stable"), std::string::npos)
      << result.out;
  const fs::path directory = folder / "orifice-30mm.portrait";
  EXPECT_EQ(contents(directory / "case.toml"), contents(balloon));
  EXPECT_NE(contents(directory / "portrait.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(contents(directory / "portrait.png").substr(1, 3), "PNG");
  EXPECT_GT(fs::file_size(directory / "portrait.gp"), 0U);
  for (const auto& entry : fs::directory_iterator(directory)) {
    EXPECT_NE(entry.path().extension(), ".part");
    EXPECT_NE(entry.path().extension(), ".log");
  }
  EXPECT_EQ(turgor(folder, {"portrait", balloon, "--pressure", bistable}).code, 2);
  EXPECT_EQ(turgor(folder, {"portrait", balloon, "--force", "--no-pictures", "-q"}).out, "");
  EXPECT_FALSE(fs::exists(directory / "portrait.png"));
}

// What the document says about balloons at rest is what runs do: both wells, and both sides of the lower boundary.
TEST(PortraitCommand, SaysWhereRunsEnd) {
  for (const char* name : {"orifice-30mm.toml", "channel-30mm.toml"}) {
    const Folder folder;
    const json document = portrait_json(folder, {"--pressure", bistable}, shipped(name));
    EXPECT_EQ(document,
              json::parse(contents(folder / (std::string(name).substr(0, 12) + ".portrait") / "portrait.json")));
    const json& rests = document.at("at_rest");
    ASSERT_EQ(rests.size(), 3U);
    for (std::size_t i = 0; i + 1 < rests.size(); ++i) EXPECT_EQ(rests[i].at("to"), rests[i + 1].at("from"));
    const double edge = rests[1].at("from").get<double>();
    for (const double off : {-1e-7, 1e-7}) {
      const auto run = turgor(
          folder, {"run", shipped(name), "--json", "--no-pictures", "--force", "--set",
                   "pressure={constant=\"" + bistable + "\"}", "--set", "initial.stretch=" + shortest(edge + off),
                   "--set", "solve.t_end=1e4 s", "--set", "solve.rest_tol=0.05", "--set", "expect={}"});
      ASSERT_EQ(run.code, 0) << run.err;
      const double end = json::parse(run.out).at("quantities").at("final_stretch").get<double>();
      EXPECT_NEAR(end, (off < 0 ? rests[0] : rests[1]).at("R").get<double>(), 0.06);
    }
  }
}

TEST(PortraitCommand, WritesEveryPointOfEveryCurve) {
  const Folder folder;
  const json document =
      portrait_json(folder, {"--pressure", bistable, "--rate-range", "-0.02:500", "--stretch-range", "0.8:5.5"});
  EXPECT_EQ(document.at("stretch_range"), json::parse("[0.8, 5.5]"));
  EXPECT_NEAR(document.at("rate_range_1_per_s")[0].get<double>(), -0.02, 1e-15);
  EXPECT_NEAR(document.at("rate_range_1_per_s")[1].get<double>(), 500, 1e-11);
  EXPECT_EQ(document.at("slow_deflation_forbidden").size(), 2U);
  std::istringstream stream(contents(folder / "orifice-30mm.portrait" / "portrait.csv"));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "curve,kind,R [1],dR/dt [1/s]");
  std::map<std::string, std::size_t> points;
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string id, kind, R, rate;
    std::getline(fields, id, ',');
    std::getline(fields, kind, ',');
    std::getline(fields, R, ',');
    std::getline(fields, rate, ',');
    ++points[id + kind];
    EXPECT_TRUE(std::isfinite(std::stod(R)) && std::isfinite(std::stod(rate))) << line;
    EXPECT_TRUE(kind == "separatrix" || std::stod(rate) * (kind == "inflation" ? 1 : -1) >= 0) << line;
  }
  std::map<std::string, int> kinds;
  for (const json& curve : document.at("curves")) {
    const std::string kind = curve.at("kind");
    ++kinds[kind];
    EXPECT_EQ(points[std::to_string(curve.at("curve").get<int>()) + kind], curve.at("points").get<std::size_t>());
  }
  EXPECT_EQ(kinds.at("slow-manifold"), 2);
  EXPECT_EQ(kinds.at("corrected-slow-manifold"), 2);
  EXPECT_EQ(kinds.at("separatrix"), 2);
  EXPECT_EQ(points.size(), document.at("curves").size());
}

// The pressure at the end of the case, an automatic model, and pressures with one, two and no equilibria.
TEST(PortraitCommand, AnswersAtEveryPressure) {
  const Folder folder;
  const json last = portrait_json(folder, {});
  EXPECT_EQ(last.at("pressure_Pa"), 0);
  ASSERT_EQ(last.at("equilibria").size(), 1U);
  EXPECT_NEAR(last.at("equilibria")[0].at("R").get<double>(), 1, 1e-15);
  EXPECT_FALSE(last.at("model_chosen_automatically"));
  const json automatic = portrait_json(folder, {"--set", "model.name=auto"});
  EXPECT_TRUE(automatic.at("model_chosen_automatically"));
  EXPECT_EQ(automatic.at("model"), "orifice");

  const json above = portrait_json(folder, {"--pressure", "48 kPa"});  // the maximum is 44.7 kPa
  ASSERT_EQ(above.at("equilibria").size(), 1U);
  EXPECT_GT(above.at("equilibria")[0].at("R").get<double>(), 6);
  const json suction = portrait_json(folder, {"--pressure", "-20 kPa"});
  EXPECT_LT(suction.at("equilibria").at(0).at("R").get<double>(), 1);

  for (const char* pressure : {"-10 kPa", "20 kPa", "60 kPa"}) {  // S1/S2 = 4: there is never a second state
    const json single = portrait_json(folder, {"--pressure", pressure, "--set", "material.s1=0.6 MPa"});
    EXPECT_EQ(single.at("equilibria").size(), 1U) << pressure;
    ASSERT_EQ(single.at("at_rest").size(), 1U) << pressure;
    EXPECT_EQ(single.at("at_rest")[0].at("R"), single.at("equilibria")[0].at("R"));
  }

  const std::string soft = shipped("material-neo-hookean.toml");
  const json two = portrait_json(folder, {"--pressure", "4.5 kPa"}, soft);
  ASSERT_EQ(two.at("equilibria").size(), 2U);
  EXPECT_EQ(two.at("at_rest").back().at("outcome"), "runaway");
  const json none = portrait_json(folder, {"--pressure", "6 kPa"}, soft);
  EXPECT_TRUE(none.at("equilibria").empty());
  ASSERT_EQ(none.at("at_rest").size(), 1U);
  EXPECT_EQ(none.at("at_rest")[0].at("outcome"), "runaway");
  EXPECT_EQ(turgor(folder, {"portrait", soft, "--pressure", "6 kPa", "-o", "away"}).err, "");
  const json locked = portrait_json(folder, {"--pressure", "500 GPa"}, shipped("material-gent.toml"));
  EXPECT_EQ(locked.at("at_rest").back().at("outcome"), "at-rest");
  const json bursts = portrait_json(folder, {"--pressure", bistable, "--set", "material.max_stretch=5.5"});
  EXPECT_EQ(bursts.at("at_rest")[0].at("outcome"), "burst");
  const json closed = portrait_json(
      folder, {"--pressure", bistable, "--set", "model.closure=potential", "--set", "inlet.orifice_radius=20 cm"});
  EXPECT_EQ(closed.at("equilibria").size(), 3U);
}

TEST(PortraitCommand, RefusesWhatCannotBe) {
  const std::string gent = shipped("material-gent.toml");
  struct Refusal {
    std::vector<std::string> arguments;
    std::string part;
  };
  const std::vector<Refusal> refusals{
      {{balloon, "--pressure", "41"}, "--pressure = \"41\": missing unit"},
      {{balloon, "--pressure", "41 cm"}, "--pressure"},
      {{balloon, "--pressure", "-1e20 kPa"}, "no equilibrium: it squeezes the balloon below R = 0.05"},
      {{gent, "--pressure", "1e20 kPa"}, "no equilibrium: more than the wall holds before it locks at R = "},
      {{balloon, "--rate-range", "1:2"}, "must have 0 inside"},
      {{balloon, "--rate-range", "-1e200:1"}, "allowed are -1e9 to 1e9"},
      {{balloon, "--rate-range", "5"}, "not of the form FROM:TO"},
      {{balloon, "--rate-range", "-1:x"}, "\"x\" is not a number"},
      {{balloon, "--stretch-range", "3:2"}, "FROM must be less than TO"},
      {{balloon, "--stretch-range", "0:2"}, "stretches are positive"},
      {{balloon, "--stretch-range", "0.01:2"}, "allowed are 0.05 to 100"},
      {{balloon, "--stretch-range", "150:200"}, "allowed are 0.05 to 100"},
      {{balloon, "--stretch-range", "50:"}, "is empty"},
      {{shipped("motion-orifice-30mm.toml")}, "motion"}};
  for (const Refusal& refusal : refusals) {
    const Folder folder;
    std::vector<std::string> arguments = refusal.arguments;
    arguments.insert(arguments.begin(), "portrait");
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 2) << refusal.part;
    EXPECT_NE(result.err.find(refusal.part), std::string::npos) << result.err;
    EXPECT_EQ(result.err.substr(0, 7), "error: ");
    for (const auto& entry : fs::directory_iterator(folder.path())) EXPECT_FALSE(entry.is_directory());
  }
}

}  // namespace
}  // namespace turgor
