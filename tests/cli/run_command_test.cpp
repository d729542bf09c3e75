// The run command and its directory, as a user meets them.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::shipped;
using test::turgor;

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream stream(contents(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (std::string field; std::getline(stream, field, ',');) numbers.push_back(std::stod(field));
  return numbers;
}

json run_json(const Folder& folder, const std::string& directory) {
  return json::parse(contents(folder / directory / "run.json"));
}

// Both methods through the program, with the model left to it; 1e-8 is what rtol 1e-12 is good for here.
TEST(RunCommand, MethodsAgreeUnderSteps) {
  const Folder folder;
  const std::string steps = R"(pressure={segments=[{step="36 kPa"},{hold="1 s"},{step="41 kPa"},{hold="0.3 s"},)"
                            R"({step="20 kPa"},{hold="3 s"}]})";
  for (const std::string method : {"adaptive", "quadrature"}) {
    const auto result = turgor(folder, {"run", shipped("orifice-30mm"), "-o", method, "--no-pictures", "--set", steps,
                                        "--set", "model.name=auto", "--set", "solve.rtol=1e-12", "--set",
                                        "solve.method=" + method, "--set", "expect={}"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(contents(folder / method / "resolved.toml").find("method = \"" + method + "\""), std::string::npos);
  }
  const json adaptive = run_json(folder, "adaptive");
  const json quadrature = run_json(folder, "quadrature");
  EXPECT_EQ(quadrature.at("integrator").at("method"), "quadrature");
  EXPECT_NE(adaptive.at("integrator").at("method"), "quadrature");
  EXPECT_EQ(quadrature.at("model").at("name"), adaptive.at("model").at("name"));
  for (const char* name : {"peak_stretch", "peak_time", "rise_time", "inlet_work", "dissipated"}) {
    const double expected = adaptive.at("quantities").at(name);
    EXPECT_NEAR(quadrature.at("quantities").at(name).get<double>(), expected, 1e-8 * std::abs(expected)) << name;
  }
  EXPECT_LT(quadrature.at("quantities").at("energy_error").get<double>(), 1e-11);
}

TEST(RunCommand, WritesTheRunDirectory) {
  const Folder folder;
  const auto result = turgor(folder, {"run", shipped("orifice-30mm"), "-o", "result"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("peak_stretch"), std::string::npos);
  const fs::path directory = folder / "result";
  EXPECT_EQ(contents(directory / "case.toml"), contents(shipped("orifice-30mm")));

  const auto rows = lines_of(directory / "trajectory.csv");
  ASSERT_EQ(rows.size(), 2001U);
  EXPECT_EQ(rows[0],
            "t [s],R [1],dRdt [1/s],r [m],p_gauge [Pa],regime,volume [m^3],flow_rate [m^3/s],kinetic [J],elastic "
            "[J],inlet_work [J],"
            "dissipated [J]");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    for (const double value : numbers_of(rows[i])) ASSERT_TRUE(std::isfinite(value)) << rows[i];
  }
  EXPECT_EQ(numbers_of(rows[1])[0], 0);
  EXPECT_EQ(numbers_of(rows.back())[0], 60);

  const auto events = lines_of(directory / "events.csv");
  EXPECT_EQ(events[0], "index,t [s],R [1],old_regime,new_regime");
  const auto document = run_json(folder, "result");
  EXPECT_EQ(document.at("status"), "complete");
  EXPECT_EQ(document.at("quantities").at("events").get<std::size_t>(), events.size() - 1);
  for (const char* part : {"versions", "timings", "integrator", "quantities", "warnings"})
    EXPECT_TRUE(document.contains(part));
  EXPECT_TRUE(fs::exists(directory / "dimensionless.csv"));
  for (const char* picture : {"history", "portrait"}) {
    EXPECT_NE(contents(directory / (std::string(picture) + ".svg")).find("<svg"), std::string::npos);
    EXPECT_EQ(contents(directory / (std::string(picture) + ".png")).substr(1, 3), "PNG");
  }
  for (const auto& entry : fs::directory_iterator(directory)) EXPECT_NE(entry.path().extension(), ".part");
}

TEST(RunCommand, RunningTheResolvedCaseGivesIdenticalBits) {
  for (const char* name :
       {"orifice-10mm", "channel-30mm", "material-gent-gent", "material-fung", "material-yeoh", "material-table"}) {
    const Folder folder;
    ASSERT_EQ(turgor(folder, {"run", shipped(name), "-o", "first", "--no-pictures"}).code, 0);
    ASSERT_EQ(turgor(folder, {"run", "first/resolved.toml", "-o", "second", "--no-pictures"}).code, 0);
    for (const char* file : {"trajectory.csv", "dimensionless.csv", "events.csv", "resolved.toml"}) {
      EXPECT_EQ(contents(folder / "first" / file), contents(folder / "second" / file)) << name << " " << file;
    }
  }
}

class ShippedRun : public testing::TestWithParam<std::string> {};

TEST_P(ShippedRun, RunsFromEndToEnd) {
  const Folder folder;
  const auto result = turgor(folder, {"run", shipped(GetParam()), "-o", "result"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(fs::exists(folder / "result" / "history.png"));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(TURGOR_CASES)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".toml" && !name.starts_with("motion-")) all.push_back(name);
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, ShippedRun, testing::ValuesIn(names()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(RunCommand, DefaultDirectoryIsNamedAfterTheCase) {
  const Folder folder;
  EXPECT_EQ(turgor(folder, {"run", shipped("orifice-30mm"), "--no-pictures", "-q"}).code, 0);
  EXPECT_TRUE(fs::exists(folder / "orifice-30mm.run" / "run.json"));
}

TEST(RunCommand, RowsAreAtExactlyTheRequestedTimes) {
  const Folder folder;
  test::write(folder / "case.toml", [] {
    std::string text = contents(shipped("orifice-10mm"));
    text.replace(text.find("samples = 2000"), 14, "times = [\"0.5 s\", \"1.25 s\", \"3 s\", \"59.999 s\"]");
    return text;
  }());
  ASSERT_EQ(turgor(folder, {"run", "case.toml", "-o", "result", "--no-pictures", "-q"}).code, 0);
  const auto rows = lines_of(folder / "result" / "trajectory.csv");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_TRUE(rows[1].starts_with("0.5,"));
  EXPECT_TRUE(rows[2].starts_with("1.25,"));
  EXPECT_TRUE(rows[4].starts_with("59.999,"));
  // R_forced of the reference values at t = 0.5 s
  EXPECT_NEAR(numbers_of(rows[1])[1], 1.009813564557049, 1e-8);
}

TEST(RunCommand, OutputUnitsAreTheChosenOnes) {
  const Folder folder;
  ASSERT_EQ(turgor(folder, {"run", shipped("material-fung"), "-o", "result", "--no-pictures", "-q"}).code, 0);
  const auto rows = lines_of(folder / "result" / "trajectory.csv");
  EXPECT_NE(rows[0].find("r [cm],p_gauge [mmHg],regime,volume [mL],flow_rate [mL/s],kinetic [mJ]"), std::string::npos);
  const auto first = numbers_of(rows[1]);
  EXPECT_NEAR(first[4], 40, 1e-12);
  EXPECT_NEAR(first[3], 3 * first[1], 1e-9);                                // r0 = 3 cm
  EXPECT_NEAR(first[6], 4 * 3.14159265 / 3 * std::pow(first[3], 3), 1e-2);  // cm^3, but for the cap in the channel
}

TEST(RunCommand, JsonIsOneDocumentAndNothingElse) {
  const Folder folder;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"run", shipped("orifice-30mm"), "--json"},
                                             {"info", shipped("orifice-30mm"), "--json"},
                                             {"validate", shipped("orifice-30mm"), "--json"},
                                             {"doc", "--json"},
                                             {"materials", "--json"}}) {
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(json::accept(result.out)) << arguments[0];
  }
}

TEST(RunCommand, QuietPrintsNothing) {
  const Folder folder;
  const auto result = turgor(folder, {"run", shipped("orifice-30mm"), "-q"});
  EXPECT_EQ(result.out + result.err, "");
}

TEST(RunCommand, ChecksExpectations) {
  const Folder folder;
  const auto with = [&](const std::string& value) {
    return turgor(folder, {"run", shipped("orifice-30mm"), "-o", "result", "--force", "--no-pictures", "--set",
                           "expect.peak_stretch={ value = " + value + ", tolerance = 1e-6 }", "--set",
                           "expect.events={ value = 315, tolerance = 0 }"});
  };
  EXPECT_EQ(with("1.174653").code, 0);
  const auto missed = with("1.2");
  EXPECT_EQ(missed.code, 3);
  EXPECT_NE(missed.err.find("peak_stretch"), std::string::npos);
  const auto document = run_json(folder, "result");
  EXPECT_EQ(document.at("status"), "complete");
  EXPECT_FALSE(document.at("expectations").at(0).at("met").get<bool>());
  // a quantity that the run does not have is a missed one
  EXPECT_EQ(turgor(folder, {"run", shipped("orifice-30mm"), "-o", "other", "--no-pictures", "--set",
                            "pressure.segments=[{ hold = \"1 s\" }]", "--set",
                            "expect.rise_time={ value = \"1 s\", tolerance = \"1 s\" }"})
                .code,
            3);
}

TEST(RunCommand, ABurstKeepsTheTrajectoryUpToThere) {
  const Folder folder;
  const auto result =
      turgor(folder, {"run", shipped("orifice-30mm"), "-o", "result", "--set", "material.max_stretch=1.1"});
  EXPECT_EQ(result.code, 4);
  EXPECT_NE(result.err.find("bursts"), std::string::npos);
  EXPECT_NE(result.err.find("R = 1.1"), std::string::npos);
  EXPECT_NE(result.err.find(" s,"), std::string::npos);
  const auto document = run_json(folder, "result");
  EXPECT_EQ(document.at("status"), "failed");
  EXPECT_EQ(document.at("outcome"), "burst");
  const auto rows = lines_of(folder / "result" / "trajectory.csv");
  EXPECT_NEAR(numbers_of(rows.back())[1], 1.1, 1e-12);
  EXPECT_GT(rows.size(), 10U);
}

TEST(RunCommand, ARunawayIsAFailure) {
  const Folder folder;
  const auto result = turgor(folder, {"run", shipped("material-neo-hookean"), "-o", "result", "--no-pictures", "--set",
                                      "pressure.segments[1].hold=1000 s", "--set", "solve.t_end=900 s"});
  EXPECT_EQ(result.code, 4) << result.out;
  EXPECT_NE(result.err.find("runs away"), std::string::npos);
  EXPECT_EQ(run_json(folder, "result").at("outcome"), "runaway");
}

TEST(RunCommand, TooManyStepsAreAFailure) {
  const Folder folder;
  const auto result =
      turgor(folder, {"run", shipped("orifice-30mm"), "-o", "result", "--no-pictures", "--set", "solve.max_steps=100"});
  EXPECT_EQ(result.code, 4);
  EXPECT_NE(result.err.find("more than 100 steps"), std::string::npos);
  EXPECT_GT(lines_of(folder / "result" / "trajectory.csv").size(), 2U);
}

TEST(RunCommand, InterruptionKeepsWhatWasComputed) {
  const Folder folder;
  // A run of many seconds: a forced balloon for a long time at a tight tolerance.
  const std::string command = std::string("timeout --preserve-status -s INT 0.4 '") + TURGOR_PROGRAM + "' run '" +
                              shipped("material-yeoh") +
                              "' -o result --set 'solve.t_end=1e6 s' --set solve.rtol=1e-12 --set "
                              "solve.max_steps=100000000 --set model.name=full";
  const auto result = test::shell(folder, command);
  EXPECT_EQ(result.code, 130) << result.err;
  const auto document = run_json(folder, "result");
  EXPECT_EQ(document.at("status"), "interrupted");
  const double reached = document.at("quantities").at("end_time");
  EXPECT_GT(reached, 0);
  EXPECT_LT(reached, 1e6);
  const auto rows = lines_of(folder / "result" / "trajectory.csv");
  EXPECT_NEAR(numbers_of(rows.back())[0], reached, 1e-9 * reached);
}

TEST(RunCommand, AKilledRunDoesNotPassAsComplete) {
  const Folder folder;
  const std::string command = std::string("timeout -s KILL 0.4 '") + TURGOR_PROGRAM + "' run '" +
                              shipped("material-yeoh") +
                              "' -o result --set 'solve.t_end=1e6 s' --set solve.rtol=1e-12 --set "
                              "solve.max_steps=100000000 --set model.name=full";
  (void)test::shell(folder, command);
  EXPECT_EQ(run_json(folder, "result").at("status"), "running");
}

TEST(RunCommand, AMissingPlottingProgramIsAWarning) {
  const Folder folder;
  fs::create_directory(folder / "empty");
  const auto result = test::shell(folder, "PATH=\"$PWD/empty\" '" + std::string(TURGOR_PROGRAM) + "' run '" +
                                              shipped("orifice-30mm") + "' -o result");
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("warning: no pictures: gnuplot was not found"), std::string::npos) << result.err;
  EXPECT_EQ(run_json(folder, "result").at("status"), "complete");
}

TEST(RunCommand, ForceLeavesNothingOfAnEarlierRun) {
  const Folder folder;
  ASSERT_EQ(turgor(folder, {"run", shipped("orifice-30mm"), "-o", "result"}).code, 0);
  test::write(folder / "result" / "notes.txt", "mine");
  ASSERT_EQ(turgor(folder, {"run", shipped("channel-30mm"), "-o", "result", "--force", "--no-pictures"}).code, 0);
  EXPECT_FALSE(fs::exists(folder / "result" / "history.png"));
  EXPECT_EQ(contents(folder / "result" / "notes.txt"), "mine");
}

TEST(InfoCommand, TellsWhatTheReferenceTells) {
  const Folder folder;
  const auto document = json::parse(turgor(folder, {"info", shipped("channel-30mm"), "--json"}).out);
  const auto& groups = document.at("groups");
  EXPECT_NEAR(groups.at("C1").get<double>(), 0.0002504508343668993, 1e-16);
  EXPECT_NEAR(groups.at("C2").get<double>(), 2690.5829596412555, 1e-9);
  EXPECT_NEAR(groups.at("C3").get<double>(), 0.5555555555555556, 1e-14);
  EXPECT_NEAR(groups.at("C1_long").get<double>(), 1.6666666666666667e-05, 1e-17);
  EXPECT_NEAR(groups.at("C2_long").get<double>(), 179.04931097838227, 1e-10);
  ASSERT_EQ(document.at("limit_points").size(), 2U);
  EXPECT_NEAR(document.at("limit_points")[0].at("R").get<double>(), 1.476069847458515, 1e-11);
  EXPECT_NEAR(document.at("limit_points")[0].at("pressure_Pa").get<double>(), 6000 * 7.453087778397741, 1e-8);
  EXPECT_NE(turgor(folder, {"info", shipped("channel-30mm")}).out.find("limit points"), std::string::npos);
}

TEST(OtherCommands, Answer) {
  const Folder folder;
  EXPECT_EQ(turgor(folder, {"validate", shipped("orifice-30mm")}).code, 0);
  const auto doc = turgor(folder, {"doc", "inlet"});
  EXPECT_NE(doc.out.find("inlet.orifice_radius"), std::string::npos);
  EXPECT_EQ(doc.out.find("balloon.radius"), std::string::npos);
  EXPECT_NE(turgor(folder, {"materials"}).out.find("arruda-boyce"), std::string::npos);
  EXPECT_EQ(turgor(folder, {"--version"}).code, 0);
  EXPECT_NE(turgor(folder, {"run", "--help"}).out.find("--force"), std::string::npos);
}

}  // namespace
}  // namespace turgor
