// Errors of the models against an elastic balloon whose motion is made up, so that every error is known.

#include "turgor/run/response_verification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../support/csv.hpp"
#include "../support/fem_run.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/rest_energy.hpp"

namespace turgor {
namespace {

using test::Csv;
using test::Folder;
using test::MadeUpRun;
using test::write_fsi_run;

/// The shipped balloon over 3 cm: 2 s rising, 2 s holding, 2 s falling, then held at 0 up to 10 s; 101 rows.
Case balloon(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), {"solve.t_end=10 s", "solve.samples=101"});
  return read_case(std::filesystem::path(TURGOR_CASES) / "orifice-30mm.toml", overrides);
}

/// r(t) of the case's own run [m].
std::function<double(double)> own_radius(const Case& c) {
  const auto run = std::make_shared<RunResult>(run_case(c));
  return [run](double t) {
    return physical_state(*run->oscillator, *run->trajectory, t / run->oscillator->scales().time).radius;
  };
}

std::function<double(double)> shifted(const std::function<double(double)>& radius,
                                      const std::function<double(double)>& shift) {
  return [=](double t) { return radius(t) + shift(t); };
}

ResponseVerification verified(const Case& c, const std::function<double(double)>& radius, const MadeUpRun& run = {}) {
  const Folder folder;
  write_fsi_run(folder / "run", c, radius, run);
  return verify_response(c, read_fem_response(c, folder / "run"));
}

std::size_t index_of(const ResponseVerification& v, const std::string& name) {
  const auto found = std::ranges::find(v.models, name, &ModelResponse::name);
  if (found == v.models.end()) throw std::out_of_range("no model " + name);
  return static_cast<std::size_t>(found - v.models.begin());
}

std::vector<std::string> names_of(const ResponseVerification& v) {
  std::vector<std::string> names;
  for (const ModelResponse& model : v.models) names.push_back(model.name());
  return names;
}

/// What the reader says about a run directory.
std::string complaint(const Case& c, const std::filesystem::path& folder) {
  try {
    (void)read_fem_response(c, folder);
  } catch (const InvalidInput& error) {
    return error.issues().front().text();
  }
  return "nothing";
}

// The run of `turgor run` is that of its own equation and closure to the last bit, and of no other.
TEST(ResponseVerification, AModelDoesNotDifferFromItself) {
  for (const auto& [overrides, own] :
       {std::pair{std::vector<std::string>{}, "(2.23) corrected"},
        {std::vector<std::string>{"model.closure=theoretical", "model.name=full"}, "(2.22) theoretical"},
        {std::vector<std::string>{"inlet.channel_length=50 cm", "model.name=long-channel"}, "(2.25) corrected"}}) {
    const Case c = balloon(overrides);
    const ResponseVerification v = verified(c, own_radius(c));
    EXPECT_TRUE(v.warnings.empty());
    ASSERT_EQ(v.parts.size(), 5U);
    for (std::size_t i = 0; i < v.models.size(); ++i) {
      const bool same = v.models[i].name() == own;
      const Deviation& whole = v.parts[0].models[i].value();
      EXPECT_EQ(whole.greatest == 0, same) << v.models[i].name();
      EXPECT_EQ(whole.rms == 0, same) << v.models[i].name();
    }
    const Landmarks& landmarks = v.models[index_of(v, own)].landmarks.value();
    EXPECT_EQ(landmarks.final, v.landmarks.final);
    EXPECT_EQ(landmarks.greatest, v.landmarks.greatest);
    EXPECT_EQ(landmarks.greatest_time, v.landmarks.greatest_time);
  }
}

// 1 mm more throughout: 1 mm less of the model in every number, times stay.
TEST(ResponseVerification, FindsAKnownShift) {
  const Case c = balloon();
  constexpr double mm = 1e-3;
  constexpr double rounding = 1e-15;  // of radii of 0.3 m
  const ResponseVerification v = verified(c, shifted(own_radius(c), [&](double) { return mm; }));
  const std::size_t own = index_of(v, "(2.23) corrected");
  for (const PhaseErrors& part : v.parts) {
    const Deviation& error = part.models[own].value();
    EXPECT_NEAR(error.mean, -mm, rounding);
    EXPECT_NEAR(error.rms, mm, rounding);
    EXPECT_NEAR(error.greatest, -mm, rounding);
  }
  const Landmarks& landmarks = v.models[own].landmarks.value();
  EXPECT_NEAR(v.landmarks.greatest - landmarks.greatest, mm, rounding);
  EXPECT_NEAR(v.landmarks.final - landmarks.final, mm, rounding);
  EXPECT_EQ(v.landmarks.greatest_time, landmarks.greatest_time);
}

// 2 mm less while the pressure falls, and 1 mm more of one row while it rises; (4, 6] s has 20 rows, (0, 2] s 21.
TEST(ResponseVerification, DividesErrorsByThePressure) {
  const Case c = balloon();
  const ResponseVerification v = verified(c, shifted(own_radius(c), [](double t) {
                                            if (std::abs(t - 1.1) < 1e-9) return 1e-3;
                                            return t > 4.05 && t < 6.05 ? -2e-3 : 0.0;
                                          }));
  const std::size_t own = index_of(v, "(2.23) corrected");
  const auto error = [&](std::size_t part) { return v.parts.at(part).models[own].value(); };
  constexpr double rounding = 1e-15;
  EXPECT_FALSE(v.parts[0].phase);
  EXPECT_EQ(v.parts[0].rows, 101U);
  EXPECT_NEAR(error(0).rms, std::sqrt((20 * 4e-6 + 1e-6) / 101), rounding);
  EXPECT_NEAR(error(0).mean, (20 * 2e-3 - 1e-3) / 101, rounding);
  EXPECT_NEAR(error(0).greatest_time, 4.1, 1e-12);
  const std::vector<std::pair<std::string, std::size_t>> expected{
      {"rising, 0 to 2 s", 21}, {"holding, 2 to 4 s", 20}, {"falling, 4 to 6 s", 20}, {"holding, 6 to 10 s", 40}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(v.parts[i + 1].phase->name(), expected[i].first);
    EXPECT_EQ(v.parts[i + 1].rows, expected[i].second);
  }
  EXPECT_NEAR(error(1).greatest, -1e-3, rounding);
  EXPECT_NEAR(error(1).greatest_time, 1.1, 1e-12);
  EXPECT_NEAR(error(1).rms, 1e-3 / std::sqrt(21), rounding);
  EXPECT_EQ(error(2).rms, 0);
  EXPECT_NEAR(error(3).mean, 2e-3, rounding);
  EXPECT_EQ(error(4).rms, 0);
}

// Against the first turning point of (2.23) with (2.15) as it was integrated in extended precision. Rows are 10 ms
// apart, so that the greatest is below it by up to d2r/dt2 (5 ms)^2/2, here 1e-6 m.
TEST(ResponseVerification, GreatestRadiusIsThatOfAnIndependentIntegration) {
  const Case c = balloon({"solve.samples=1001"});
  const ResponseVerification v = verified(c, [](double t) { return 0.3 + 1e-3 * t; });
  EXPECT_NEAR(v.models[index_of(v, "(2.23) corrected")].landmarks->greatest, 0.3 * 1.174653081369178, 1e-6);
  EXPECT_NEAR(v.stroke, 0.01, 1e-15);
  EXPECT_DOUBLE_EQ(v.landmarks.greatest_time, 10);
}

std::vector<std::string> phase_names(const std::string& pressure, double t_end) {
  const Case c = balloon({"pressure=" + pressure});
  std::vector<std::string> names;
  for (const PressurePhase& phase : pressure_phases(c.pressure, t_end)) names.push_back(phase.name());
  return names;
}

TEST(ResponseVerification, PhasesAreThoseOfTheProgram) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(phase_names("{ constant = \"1 kPa\" }", 3), Names{"holding, 0 to 3 s"});
  EXPECT_EQ(phase_names("{ harmonic = { mean = \"1 kPa\", amplitude = \"1 kPa\", frequency = \"1 Hz\" } }", 3),
            Names{"oscillating, 0 to 3 s"});
  // cut at t_end, and what lies beyond is not there
  EXPECT_EQ(phase_names("{ segments = [{ to = \"1 kPa\", over = \"2 s\" }, { to = \"0 kPa\", over = \"2 s\" }] }", 1.5),
            Names{"rising, 0 to 1.5 s"});
  // what goes on is one phase, what jumps is two
  EXPECT_EQ(phase_names("{ segments = [{ to = \"1 kPa\", over = \"1 s\" }, { to = \"3 kPa\", over = \"1 s\" }, "
                        "{ hold = \"1 s\" }, { step = \"1 kPa\" }, { hold = \"1 s\" }] }",
                        5),
            (Names{"rising, 0 to 2 s", "holding, 2 to 3 s", "holding, 3 to 5 s"}));
  EXPECT_EQ(phase_names("{ table = { t = [\"0 s\", \"1 s\", \"2 s\", \"3 s\"], "
                        "p = [\"0 kPa\", \"1 kPa\", \"3 kPa\", \"2 kPa\"] } }",
                        4),
            (Names{"rising, 0 to 2 s", "falling, 2 to 3 s", "holding, 3 to 4 s"}));
}

// Its equations by the channel, its closures by the range of the fit and the case's own choice.
TEST(ResponseVerification, TakesTheModelsThatApply) {
  const auto names = [](const std::vector<std::string>& overrides, double r) {
    return names_of(verified(balloon(overrides), [r](double) { return r; }, {.end = 0}));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({}, 0.3), (Names{"(2.22) theoretical", "(2.22) corrected", "(2.22) calibrated",  //
                                   "(2.23) theoretical", "(2.23) corrected", "(2.23) calibrated"}));
  EXPECT_EQ(names({}, 0.29),  // r_ch/r > 1/10
            (Names{"(2.22) theoretical", "(2.22) corrected", "(2.23) theoretical", "(2.23) corrected"}));
  EXPECT_EQ(names({}, 1.9),  // r_ch/r < 1/60
            (Names{"(2.22) theoretical", "(2.22) corrected", "(2.23) theoretical", "(2.23) corrected"}));
  EXPECT_EQ(names({"inlet.channel_length=10 cm", "model={closure=\"potential\", name=\"full\"}"}, 0.29),
            (Names{"(2.22) theoretical", "(2.22) corrected", "(2.22) potential",  //
                   "(2.25) theoretical", "(2.25) corrected", "(2.25) potential"}));
}

// A wall that bursts in the models and not in the finite elements.
TEST(ResponseVerification, ModelsThatEndEarlyHaveNoErrorAfter) {
  const Case c = balloon({"material.max_stretch=1.1"});
  const ResponseVerification v = verified(c, [](double) { return 0.3; });
  ASSERT_EQ(v.warnings.size(), v.models.size());
  EXPECT_NE(v.warnings[0].text.find("of 101 rows"), std::string::npos) << v.warnings[0].text;
  const ModelResponse& model = v.models.front();
  ASSERT_GT(model.radii.size(), 10U);
  ASSERT_LT(model.radii.size(), 21U);
  EXPECT_LE(model.radii.back(), 0.33);
  EXPECT_FALSE(model.landmarks);
  EXPECT_FALSE(v.parts[1].models[0]);
  const auto document = nlohmann::json::parse(verification_json(c, v));
  EXPECT_TRUE(document.at("parts").at(0).at("errors").at("full").at("theoretical").is_null());
  EXPECT_EQ(document.at("models").at("full").at("theoretical").at("outcome"), "burst");
  const Folder folder;
  test::write(folder / "verify.csv", verification_csv(c, v));
  const Csv table(folder / "verify.csv");
  EXPECT_FALSE(table.empty(model.radii.size() - 1, "r_full_theoretical [m]"));
  EXPECT_TRUE(table.empty(model.radii.size(), "r_full_theoretical [m]"));
  EXPECT_NE(verification_summary(c, v).find("(2.22) theoretical"), std::string::npos);
}

TEST(ResponseVerification, LimitsOfRunsDoNotEndTheModels) {
  const Case c = balloon({"solve.max_events=1"});
  const ResponseVerification v = verified(c, [](double) { return 0.3; });
  EXPECT_TRUE(v.warnings.empty());
  for (const ModelResponse& model : v.models) EXPECT_NE(model.radii.back(), model.radii[model.radii.size() - 20]);
}

TEST(ResponseVerification, ReadsAndWritesWhateverUnits) {
  const Case c = balloon({"output.length_unit=mm", "output.time_unit=ms", "output.pressure_unit=kPa"});
  const auto radius = own_radius(c);
  const ResponseVerification v = verified(c, radius, {"complete", 1e300, "min", 60, "inch", 0.0254});
  const std::size_t own = index_of(v, "(2.23) corrected");
  EXPECT_NEAR(v.parts[0].models[own]->greatest, 0, 1e-15);
  EXPECT_NEAR(v.fem.rows[3].rate, 0.5 * 0.0254 / 60, 1e-15);
  const Folder folder;
  test::write(folder / "verify.csv", verification_csv(c, v));
  const Csv table(folder / "verify.csv");
  ASSERT_EQ(table.size(), 101U);
  EXPECT_NEAR(table(15, "t [ms]"), 1500, 1e-9);
  EXPECT_NEAR(table(15, "p_gauge [kPa]"), c.pressure(1.5) / 1000, 1e-12);
  EXPECT_NEAR(table(15, "r_eff_fem [mm]"), 1000 * radius(1.5), 1e-9);
  EXPECT_NEAR(table(15, "r_orifice_corrected [mm]"), 1000 * radius(1.5), 1e-9);
  EXPECT_NE(verification_summary(c, v).find("greatest [mm]"), std::string::npos);
}

TEST(ResponseVerification, RunsThatEndedEarlyAreComparedAsFarAsTheyGo) {
  const Case c = balloon();
  for (const std::string status : {"interrupted", "failed", "running"}) {
    const ResponseVerification v = verified(c, own_radius(c), {.status = status, .end = 3.05});
    ASSERT_EQ(v.warnings.size(), 1U);
    EXPECT_NE(v.warnings[0].text.find(status), std::string::npos);
    EXPECT_NE(v.warnings[0].text.find("up to t = 3 of 10 s"), std::string::npos) << v.warnings[0].text;
    ASSERT_EQ(v.parts.size(), 3U);
    EXPECT_EQ(v.parts[2].rows, 10U);
    EXPECT_EQ(v.landmarks.final, own_radius(c)(3));
    EXPECT_NE(verification_summary(c, v).find("warning: "), std::string::npos);
  }
}

// One row has no stroke, so nothing is relative to it: null in JSON, a dash on the screen.
TEST(ResponseVerification, NothingIsNotANumber) {
  const Case c = balloon();
  const ResponseVerification v = verified(c, [](double) { return 0.301; }, {.end = 0});
  EXPECT_EQ(v.stroke, 0);
  const auto document = nlohmann::json::parse(verification_json(c, v));
  const auto& error = document.at("parts").at(0).at("errors").at("orifice").at("corrected");
  EXPECT_TRUE(error.at("rms").is_null());
  EXPECT_NEAR(error.at("rms_m").get<double>(), 1e-3, 1e-15);
  for (const std::string& text : {verification_summary(c, v), verification_csv(c, v), verification_json(c, v)}) {
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf "), std::string::npos);
  }
}

TEST(ResponseVerification, ReportsWhatItComputed) {
  const Case c = balloon();
  const ResponseVerification v = verified(c, shifted(own_radius(c), [](double) { return 1e-3; }));
  const auto document = nlohmann::json::parse(verification_json(c, v));
  EXPECT_EQ(document.at("finite_elements").at("rows"), 101);
  EXPECT_EQ(document.at("finite_elements").at("steps"), 7);
  EXPECT_EQ(document.at("finite_elements").at("stroke_m"), v.stroke);
  EXPECT_EQ(document.at("parts").at(0).at("part"), "whole");
  const auto& falling = document.at("parts").at(3);
  EXPECT_EQ(falling.at("part"), "falling");
  EXPECT_EQ(falling.at("from_s"), 4);
  EXPECT_EQ(falling.at("to_s"), 6);
  const auto& error = falling.at("errors").at("orifice").at("corrected");
  EXPECT_NEAR(error.at("mean_m").get<double>(), -1e-3, 1e-15);
  EXPECT_NEAR(error.at("rms").get<double>(), 1e-3 / v.stroke, 1e-12);
  const auto& model = document.at("models").at("orifice").at("corrected");
  EXPECT_EQ(model.at("outcome"), "reached-end");
  EXPECT_NEAR(model.at("final_m").get<double>(), v.landmarks.final - 1e-3, 1e-15);
}

TEST(ResponseVerification, RefusesAnotherCase) {
  const Case c = balloon();
  const Folder folder;
  write_fsi_run(folder / "run", c, own_radius(c));
  const auto differs = [&](const std::string& override) { return complaint(balloon({override}), folder / "run"); };
  EXPECT_NE(differs("inlet.orifice_radius=2 cm").find("it has inlet.orifice_radius = \"0.03 m\""), std::string::npos);
  EXPECT_NE(differs("wall.damping_time=1 ms").find("wall.damping_time"), std::string::npos);
  EXPECT_NE(differs("material.s1=1 MPa").find("material.s1"), std::string::npos);
  EXPECT_NE(differs("pressure.segments[1].hold=3 s").find("pressure.segments[1].hold = \"2 s\""), std::string::npos);
  EXPECT_NE(differs("initial.stretch=1.1").find("initial.stretch"), std::string::npos);
  EXPECT_NE(differs("solve.t_end=9 s").find("solve.t_end"), std::string::npos);
  for (const char* harmless : {"model.closure=potential", "model.name=full", "output.length_unit=mm", "solve.samples=7",
                               "fem.cfl=2", "scales={time=\"1 s\", pressure=\"1 Pa\"}"}) {
    EXPECT_EQ(differs(harmless), "nothing") << harmless;
  }
}

TEST(ResponseVerification, TellsTheTwoKindsOfRunsApart) {
  const Folder folder;
  const Case free = balloon();
  const Case dictated = read_case(std::filesystem::path(TURGOR_CASES) / "motion-orifice-30mm.toml");
  write_fsi_run(folder / "free", free, own_radius(free), {.end = 1});
  test::write_fem_run(folder / "dictated", dictated, [](double) { return test::MadeUpForces{0, 0}; }, {.end = 1});
  const std::string wrong = complaint(free, folder / "dictated");
  EXPECT_NE(wrong.find("is a run of dictated motion"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("`turgor fem fsi`"), std::string::npos) << wrong;
  try {
    (void)read_fem_history(dictated, folder / "free");
    FAIL();
  } catch (const InvalidInput& error) {
    const std::string text = error.issues().front().text();
    EXPECT_NE(text.find("is a run of an elastic balloon"), std::string::npos) << text;
    EXPECT_NE(text.find("`turgor fem flow`"), std::string::npos) << text;
  }
}

// A sphere of 0.33 m has the volume of the state of rest that `turgor fem statics` has there, so 7 J is less by the
// energy of (3.1), 4 pi r0^2 d0 W: the integral of the pressure of the model over the volume, by another rule.
TEST(ResponseVerification, MeasuresTheEnergyOfTheShape) {
  const Case c = balloon();
  const ResponseVerification v = verified(c, [](double t) { return t < 5 ? 0.33 : 0.3; });
  ASSERT_TRUE(v.shape.has_value());
  const double volume = balloon_volume(c.parameters, 1.1);
  double work = 0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double stretch = 1 + 0.1 * (i + 0.5) / steps;
    const double shell =
        balloon_volume(c.parameters, 1 + 0.1 * (i + 1.0) / steps) - balloon_volume(c.parameters, 1 + 0.1 * i / steps);
    work += static_pressure(c.parameters, stretch).value * shell;
  }
  EXPECT_NEAR(v.shape->rows.front(), 7 - work, 0.005 * work);  // the hole makes the membrane 0.3 % stiffer
  EXPECT_NEAR(v.shape->rows.back(), 7, 1e-3);                  // slack
  EXPECT_NEAR(RestEnergy(c, volume)(volume), 7 - v.shape->rows.front(), 1e-9 * work);
  EXPECT_EQ(v.shape->greatest, v.shape->rows.back());
  EXPECT_NEAR(v.shape->time, 5, 1e-9);
  EXPECT_EQ(v.shape->elastic, 7);
}

TEST(ResponseVerification, RefusesDamagedTables) {
  const Case c = balloon({"pressure={ segments = [{ hold = \"1 s\" }, { step = \"2 kPa\" }] }"});
  const Folder folder;
  const auto with = [&](const std::string& lines) {
    write_fsi_run(folder / "run", c, [](double) { return 0.3; });
    test::write(folder / "run" / "history.csv",
                "t [s],p_gauge [kPa],r_eff [cm],dr_effdt [m/s],volume [m^3],elastic [J]\n" + lines);
    return complaint(c, folder / "run");
  };
  EXPECT_EQ(with("0,0,30,0,0.11,1\n1.5,2,31,0,0.11,1\n"), "nothing");
  EXPECT_EQ(with("1,0,30,0,0.11,1\n"), "nothing");  // at the jump: before, after
  EXPECT_EQ(with("1,2,30,0,0.11,1\n"), "nothing");
  EXPECT_NE(with("0,0,30,0,0.11,1\n0.5,0.1,30,0,0.11,1\n")
                .find("row 3: at t = 0.5 s it has p_gauge = 100 Pa, where [pressure] has 0"),
            std::string::npos);
  EXPECT_NE(with("0.5,0,30,0,0.11,1\n0.5,0,30,0,0.11,1\n").find("row 3: t = 0.5 s does not come after"),
            std::string::npos);
  EXPECT_NE(with("11,2,30,0,0.11,1\n").find("not between 0 and solve.t_end"), std::string::npos);
  EXPECT_NE(with("0,0,0,0,0.11,1\n").find("row 2: r_eff = 0 m is not positive"), std::string::npos);
  EXPECT_NE(with("0,0,nan,0,0.11,1\n").find("row 2: \"nan\" is not a finite number"), std::string::npos);
  EXPECT_NE(with("").find("has no rows"), std::string::npos);
  test::write(folder / "run" / "history.csv", "t [s],r [m]\n0,0.3\n");
  EXPECT_NE(complaint(c, folder / "run").find("has no column p_gauge"), std::string::npos);
  std::filesystem::remove(folder / "run" / "history.csv");
  EXPECT_NE(complaint(c, folder / "run").find("no run directory of `turgor fem fsi`: it has no history.csv"),
            std::string::npos);
}

}  // namespace
}  // namespace turgor
