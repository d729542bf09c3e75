// `turgor asymptotics`, as a user calls it.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor::test {
namespace {

using Json = nlohmann::json;

std::vector<std::string> call(const std::string& name, std::vector<std::string> more) {
  more.insert(more.begin(), {"asymptotics", std::string(TURGOR_CASES) + "/" + name});
  return more;
}

Json document(const Folder& folder, const std::string& name, std::vector<std::string> more) {
  more.emplace_back("--json");
  const Finished done = turgor(folder, call(name, more));
  EXPECT_EQ(done.code, 0) << done.err;
  return Json::parse(done.out);
}

const std::vector<std::string> middle{"--set", "pressure={constant=\"41313.600802474764 Pa\"}"};

// The balloon of figure 8; expected values are those of the reference file (3.17 from R_i = 5 on the clock of C1
// there).
TEST(AsymptoticsCommand, DescribesBothStableEquilibria) {
  const Folder folder;
  auto arguments = middle;
  arguments.insert(arguments.end(), {"--from", "5"});
  const Json found = document(folder, "orifice-30mm.toml", arguments);
  EXPECT_EQ(found["model"], "orifice");
  ASSERT_EQ(found["equilibria"].size(), 3U);
  ASSERT_EQ(found["motions"].size(), 2U);
  const Json& large = found["motions"][1];
  EXPECT_EQ(large["R_i"], 5.0);
  EXPECT_NEAR(found["motions"][0]["R_i"].get<double>(), 1.05 * 1.2582010333829832, 1e-12);
  const double clock = large["time_scales"]["deflation_s"];
  EXPECT_NEAR(clock, 5.203107399920502, 1e-12);
  EXPECT_NEAR(large["T_deflation_3_17_s"]["value"].get<double>(), 215.65936008133252 * clock, 1e-9);
  EXPECT_NEAR(large["T_deflation_uniform_s"]["value"].get<double>(), 225.02442718391413 * clock, 1e-5);
  EXPECT_NEAR(large["R_turning_uniform"]["value"].get<double>(), 4.804981736619559, 1e-9);
  EXPECT_NEAR(large["undershoot"]["value"].get<double>(), 4.804989785515669 - 4.804981736619559, 1e-14);
  EXPECT_EQ(large["decay"].size(), 4U);
  EXPECT_NEAR(found["closed_equilibria"][0]["value"].get<double>(), 1.2877, 1e-4);
  EXPECT_EQ(found["closed_equilibria"][1]["equation"], "(3.5)");
}

TEST(AsymptoticsCommand, PrintsForPeople) {
  const Folder folder;
  const Finished done = turgor(folder, call("channel-30mm.toml", middle));
  ASSERT_EQ(done.code, 0) << done.err;
  for (const char* text :
       {"long-channel", "(3.3)", "(3.5)", "(3.7)", "(3.17)", "beta", "100 cycles", "estimated error"}) {
    EXPECT_NE(done.out.find(text), std::string::npos) << text << "\n" << done.out;
  }
}

// Approximations that have no value say why; the others stay.
TEST(AsymptoticsCommand, KeepsWhatHoldsForOtherModelsAndMaterials) {
  const Folder folder;
  const Json found = document(folder, "material-gent.toml", {"--set", "model.name=\"full\"", "--from", "1.4"});
  EXPECT_EQ(found["model"], "full");
  EXPECT_TRUE(found["closed_equilibria"][0].contains("refused"));
  const Json& motion = found["motions"][0];
  EXPECT_TRUE(motion["deflation_constants"].is_null());
  EXPECT_TRUE(motion["T_deflation_uniform_s"].contains("refused"));
  EXPECT_GT(motion["undershoot"]["value"].get<double>(), 0);
}

std::vector<std::string> held_at(const std::string& pressure) {
  return {"--set", "pressure={constant=\"" + pressure + "\"}"};
}

// The limit pressures are 37.909 and 44.719 kPa; (3.5) is real from 37.947 kPa on.
TEST(AsymptoticsCommand, AnswersAtEveryPressure) {
  const Folder folder;
  struct Answer {
    const char* pressure;
    std::size_t equilibria, motions;
    bool small, large;  ///< whether (3.3) and (3.5) have values
  };
  for (const Answer& answer : {Answer{"-5 kPa", 1, 1, true, false}, Answer{"0 Pa", 1, 1, true, false},
                               Answer{"30 kPa", 1, 1, true, false}, Answer{"37.92 kPa", 3, 2, true, false},
                               Answer{"37.96 kPa", 3, 2, true, true}, Answer{"44.8 kPa", 1, 1, false, true}}) {
    const Json found = document(folder, "orifice-30mm.toml", held_at(answer.pressure));
    EXPECT_EQ(found["equilibria"].size(), answer.equilibria) << answer.pressure;
    EXPECT_EQ(found["motions"].size(), answer.motions) << answer.pressure;
    EXPECT_EQ(found["closed_equilibria"][0].contains("value"), answer.small) << answer.pressure;
    EXPECT_EQ(found["closed_equilibria"][1].contains("value"), answer.large) << answer.pressure;
    EXPECT_EQ(found.dump().find("NaN"), std::string::npos);
    for (const Json& motion : found["motions"]) EXPECT_GT(motion["undershoot"]["value"].get<double>(), 0);
  }
  const Json complex = document(folder, "orifice-30mm.toml", held_at("37.92 kPa"));
  EXPECT_NE(complex["closed_equilibria"][1]["refused"].get<std::string>().find("(3.5) is complex"), std::string::npos);
  EXPECT_LT(document(folder, "orifice-30mm.toml", held_at("-5 kPa"))["equilibria"][0]["R"].get<double>(), 1);
}

// S1/S2 = 4: the static pressure only rises.
TEST(AsymptoticsCommand, AnswersWithoutASecondState) {
  const Folder folder;
  for (const char* pressure : {"10 kPa", "26 kPa", "60 kPa"}) {
    auto arguments = held_at(pressure);
    arguments.insert(arguments.end(), {"--set", "material.s1=0.6 MPa"});
    const Json found = document(folder, "orifice-30mm.toml", arguments);
    EXPECT_EQ(found["equilibria"].size(), 1U) << pressure;
    EXPECT_EQ(found["motions"].size(), 1U) << pressure;
  }
}

TEST(AsymptoticsCommand, RefusesWhatHasNoFreeMotion) {
  const Folder folder;
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    const Finished done = turgor(folder, call("orifice-30mm.toml", std::move(arguments)));
    EXPECT_EQ(done.code, 2) << why;
    EXPECT_NE(done.err.find(why), std::string::npos) << done.err;
  };
  refused({"--from", "0.5"}, "--from");
  refused({"--from", "nan"}, "--from");
  for (const char* rest : {"1.2582010333829834", "2.0043852292044617", "4.804989785515669"}) {
    auto arguments = middle;  // at rest there is no deflation, whether the rest is stable or not
    arguments.insert(arguments.end(), {"--from", rest});
    refused(arguments, "is not above a stable equilibrium, in its well");
  }
  refused({"--set", "pressure={harmonic={mean=\"1 kPa\",amplitude=\"1 kPa\",frequency=\"1 Hz\"}}"},
          "never becomes constant");
  refused({"--set", "material={model=\"neo-hookean\",mu=\"1 MPa\"}", "--set", "pressure={constant=\"1 MPa\"}"},
          "no stable equilibrium");
  refused({"--set", "model.closure=potential", "--set", "pressure={constant=\"30 kPa\"}"}, "no closed approximations");
}

}  // namespace
}  // namespace turgor::test
