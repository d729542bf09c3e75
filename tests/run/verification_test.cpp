// Errors of the closures against forces that are made up, so that every error is known.

#include "turgor/run/verification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../support/csv.hpp"
#include "../support/fem_run.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/force_history.hpp"

namespace turgor {
namespace {

using test::Csv;
using test::Folder;
using test::MadeUpForces;
using test::MadeUpRun;
using test::write_fem_run;

constexpr std::size_t corrected = 1;

/// The shipped motion over 3 cm, a row each 0.1 s: 6 rows, 10 and 5 inflate, 10 rest, 5, 10 and 5 deflate.
Case motion_case(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "solve.samples=51");
  return read_case(std::filesystem::path(TURGOR_CASES) / "motion-orifice-30mm.toml", overrides);
}

double force(const Case& c, Closure closure, double t) {
  return forces_at(c, {closure}, t, dictated_motion(c).at(t)).all.front();
}

/// The corrected closure times 1.25, and in the mode 1.1.
std::function<MadeUpForces(double)> scaled(const Case& c) {
  return [&c](double t) {
    const double f = force(c, Closure::corrected, t);
    return MadeUpForces{1.25 * f, 1.1 * f};
  };
}

Verification verified(const Case& c, const std::function<MadeUpForces(double)>& forces, const MadeUpRun& run = {}) {
  const Folder folder;
  write_fem_run(folder / "run", c, forces, run);
  return verify(c, read_fem_history(c, folder / "run"));
}

const PartErrors& part(const ForceComparison& comparison, const std::string& name) {
  const auto found = std::ranges::find(comparison.parts, name, [](const PartErrors& of) { return of.part.name(); });
  if (found == comparison.parts.end()) throw std::out_of_range("no part " + name);
  return *found;
}

/// What the reader says about a run directory.
std::string complaint(const Case& c, const std::filesystem::path& folder) {
  try {
    (void)read_fem_history(c, folder);
  } catch (const InvalidInput& error) {
    return error.issues().front().text();
  }
  return "nothing";
}

// A force that is 1.1 times the closure's: -1/11. 1e-12 for sums of 10 rows.
TEST(Verification, FindsAKnownFactor) {
  const Case c = motion_case();
  const Verification v = verified(c, scaled(c));
  EXPECT_TRUE(v.warnings.empty());
  ASSERT_EQ(v.closures, compared_closures(c));
  ASSERT_EQ(v.mode.even_deflation.size(), v.closures.size());
  for (const auto& [comparison, expected] : {std::pair{&v.mode, -1.0 / 11}, {&v.whole, -0.2}}) {
    const ForceRatio& ratio = comparison->even_deflation.at(corrected);
    for (const double value : {ratio.mean, ratio.least, ratio.greatest}) EXPECT_NEAR(value, expected, 1e-12);
    for (const char* name : {"deflating", "deflating, accelerating", "deflating, constant velocity"}) {
      const PartErrors& errors = part(*comparison, name);
      EXPECT_FALSE(errors.relative_to_deflation);
      EXPECT_NEAR(errors.closures.at(corrected).rms / errors.reference, -expected, 1e-12) << name;
      EXPECT_LT(errors.closures.at(corrected).mean, 0);
    }
  }
  // (2.12) over (2.15) at constant velocity: 3/2 over 75/32
  EXPECT_NEAR(v.mode.even_deflation.at(0).mean, 0.64 / 1.1 - 1, 1e-12);
}

TEST(Verification, DividesTheMotionIntoParts) {
  const Case c = motion_case();
  const Verification v = verified(c, scaled(c));
  const std::vector<std::pair<std::string, std::size_t>> expected{{"inflating", 21},
                                                                  {"inflating, accelerating", 6},
                                                                  {"inflating, constant velocity", 10},
                                                                  {"inflating, decelerating", 5},
                                                                  {"at rest", 10},
                                                                  {"deflating", 20},
                                                                  {"deflating, accelerating", 5},
                                                                  {"deflating, constant velocity", 10},
                                                                  {"deflating, decelerating", 5}};
  ASSERT_EQ(v.mode.parts.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(v.mode.parts[i].part.name(), expected[i].first);
    EXPECT_EQ(v.mode.parts[i].rows, expected[i].second) << expected[i].first;
  }
}

// Against errors that were put in: 7 N everywhere, and one row of 50 N more while inflating, where the model has none.
TEST(Verification, FindsKnownErrors) {
  const Case c = motion_case();
  const Verification v = verified(c, [&](double t) {
    const double f = force(c, Closure::corrected, t) - 7 - (std::abs(t - 1.1) < 1e-9 ? 50 : 0);
    return MadeUpForces{2 * f, f};
  });
  const PartErrors& even = part(v.mode, "inflating, constant velocity");
  const Deviation& e = even.closures.at(corrected);
  EXPECT_NEAR(e.mean, 12, 1e-10);
  EXPECT_NEAR(e.rms, std::sqrt((9 * 49.0 + 57 * 57.0) / 10), 1e-10);
  EXPECT_NEAR(e.greatest, 57, 1e-10);
  EXPECT_NEAR(e.greatest_time, 1.1, 1e-12);
  EXPECT_TRUE(even.relative_to_deflation);
  EXPECT_EQ(even.reference, part(v.mode, "deflating").rms);
  EXPECT_NEAR(even.rms, e.rms, 1e-10);
  EXPECT_NEAR(part(v.whole, "at rest").closures.at(corrected).mean, 14, 1e-10);
  EXPECT_NEAR(part(v.mode, "deflating").closures.at(corrected).mean, 7, 1e-8);  // of forces of 1e5 N
}

// From 2 cm/s to -4 cm/s within 1.5 s: the turn at 0.5 s, where the acceleration goes on and the force jumps.
TEST(Verification, ATurnBelongsToTheMotionBefore) {
  const Case c = motion_case({"motion.start=2 cm/s", "motion.velocity=[{ to = \"-4 cm/s\", over = \"1.5 s\" }]",
                              "solve.samples=16", "inlet.channel_length=10 cm"});
  const Verification v = verified(c, scaled(c));
  EXPECT_EQ(part(v.mode, "inflating, decelerating").rows, 6U);
  EXPECT_EQ(part(v.mode, "deflating, accelerating").rows, 10U);
  EXPECT_EQ(v.mode.parts.size(), 4U);
  EXPECT_TRUE(v.mode.even_deflation.empty());
  const FlowState<double> turn{0.305, 0, -0.04, 0, 0.03, 0.1, 1000};
  EXPECT_NEAR(v.rows[5].models.at(corrected), generalized_force(Closure::corrected, Regime::inflating, turn), 1e-9);
}

TEST(Verification, ReadsWhateverUnits) {
  const Case c = motion_case({"output.length_unit=mm", "output.time_unit=ms"});
  const Verification si = verified(c, scaled(c));
  const Verification v = verified(c, scaled(c), {"complete", 1e300, "min", 60, "inch", 0.0254});
  for (std::size_t i = 0; i < si.mode.parts.size(); ++i) {
    EXPECT_EQ(v.mode.parts[i].rows, si.mode.parts[i].rows);
    EXPECT_NEAR(v.mode.parts[i].closures[corrected].rms, si.mode.parts[i].closures[corrected].rms, 1e-6);
  }
  const Folder folder;
  test::write(folder / "verify.csv", verification_csv(c, v));
  const Csv table(folder / "verify.csv");
  ASSERT_EQ(table.size(), 51U);
  EXPECT_NEAR(table(35, "t [ms]"), 3500, 1e-9);
  EXPECT_NEAR(table(35, "r [mm]"), 315, 1e-9);
  EXPECT_NEAR(table(35, "drdt [mm/ms]"), -0.02, 1e-14);
  EXPECT_NEAR(table(35, "d2rdt2 [mm/ms^2]"), 0, 1e-14);
  const double f = force(c, Closure::corrected, 3.5);
  EXPECT_NEAR(table(35, "force_fem [N]"), 1.25 * f, 1e-6);
  EXPECT_NEAR(table(35, "force_mode_fem [N]"), 1.1 * f, 1e-6);
  for (const Closure closure : compared_closures(c)) {
    EXPECT_NEAR(table(35, "force_" + std::string(name_of(closure)) + " [N]"), force(c, closure, 3.5), 1e-6);
  }
}

TEST(Verification, RunsThatEndedEarlyAreComparedAsFarAsTheyGo) {
  const Case c = motion_case();
  for (const std::string status : {"interrupted", "failed", "running"}) {
    const Verification v = verified(c, scaled(c), {.status = status, .end = 3.05});
    ASSERT_EQ(v.warnings.size(), 1U);
    EXPECT_NE(v.warnings[0].text.find(status), std::string::npos);
    EXPECT_NE(v.warnings[0].text.find("up to t = 3 of 5 s"), std::string::npos) << v.warnings[0].text;
    EXPECT_EQ(v.rows.size(), 31U);
    EXPECT_TRUE(v.mode.even_deflation.empty());
    EXPECT_EQ(part(v.mode, "deflating").rows, 5U);
    EXPECT_NE(verification_summary(c, v).find("warning: "), std::string::npos);
  }
}

// Zero forces have no relative errors: null in JSON, a dash on the screen.
TEST(Verification, NothingIsNotANumber) {
  const Case c = motion_case();
  const Verification v = verified(c, [](double) { return MadeUpForces{0, 0}; }, {.end = 1});
  const auto document = nlohmann::json::parse(verification_json(c, v));
  const auto& first = document.at("force_mode").at("parts").at(0);
  EXPECT_EQ(first.at("part"), "inflating");
  EXPECT_TRUE(first.at("errors").at("corrected").at("rms").is_null());
  EXPECT_EQ(first.at("errors").at("corrected").at("rms_N"), 0);
  EXPECT_TRUE(document.at("force").at("even_deflation_ratio_minus_1").is_null());
  for (const std::string& text : {verification_summary(c, v), verification_csv(c, v), verification_json(c, v)}) {
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf "), std::string::npos);
  }
}

TEST(Verification, ReportsWhatItComputed) {
  const Case c = motion_case();
  const Verification v = verified(c, scaled(c));
  const auto document = nlohmann::json::parse(verification_json(c, v));
  EXPECT_EQ(document.at("finite_elements").at("rows"), 51);
  EXPECT_EQ(document.at("finite_elements").at("steps"), 7);
  EXPECT_EQ(document.at("closures").size(), v.closures.size());
  EXPECT_NEAR(document.at("force_mode").at("even_deflation_ratio_minus_1").at("corrected").at("mean").get<double>(),
              -1.0 / 11, 1e-12);
  EXPECT_EQ(document.at("force").at("parts").at(1).at("relative_to"), "deflation");
  const std::string summary = verification_summary(c, v);
  EXPECT_NE(summary.find("force_mode -9.09 (-9.09 to -9.09)"), std::string::npos) << summary;
  EXPECT_NE(summary.find("force -20 (-20 to -20)"), std::string::npos) << summary;
}

TEST(Verification, RefusesAnotherCase) {
  const Case c = motion_case();
  const Folder folder;
  write_fem_run(folder / "run", c, scaled(c));
  const auto differs = [&](const std::string& override) { return complaint(motion_case({override}), folder / "run"); };
  EXPECT_NE(differs("inlet.orifice_radius=2 cm").find("it has inlet.orifice_radius = \"0.03 m\""), std::string::npos);
  EXPECT_NE(differs("fluid.viscosity=1 Pa s").find("fluid.viscosity"), std::string::npos);
  EXPECT_NE(differs("motion.velocity[1].hold=1.5 s").find("motion.velocity[1].hold = \"1 s\""), std::string::npos);
  EXPECT_NE(differs("motion.velocity=[{ hold = \"5 s\" }]").find("motion.velocity = "), std::string::npos);
  EXPECT_NE(differs("solve.t_end=4 s").find("solve.t_end"), std::string::npos);
  for (const char* harmless : {"model.closure=potential", "output.length_unit=mm", "solve.samples=7", "fem.cfl=2",
                               "solve={times=[\"1 s\"]}"}) {
    EXPECT_EQ(differs(harmless), "nothing") << harmless;
  }
}

TEST(Verification, RefusesAnotherMotion) {
  const Case c = motion_case();
  const Folder folder;
  const auto with = [&](const std::string& lines) {
    write_fem_run(folder / "run", c, scaled(c));
    test::write(folder / "run" / "history.csv", "t [s],r [cm],force [N],force_mode [N]\n" + lines);
    return complaint(c, folder / "run");
  };
  EXPECT_EQ(with("0,30,0,0\n3.5,31.5,1,1\n"), "nothing");
  EXPECT_NE(with("0,30,0,0\n3.501,31.5,1,1\n").find("row 3: at t = 3.501 s it has r = 0.315 m"), std::string::npos);
  EXPECT_NE(with("3.5,31.5,1,1\n3.5,31.5,1,1\n").find("row 3: t = 3.5 s does not come after"), std::string::npos);
  EXPECT_NE(with("-1,30,0,0\n").find("not between 0 and solve.t_end"), std::string::npos);
  EXPECT_NE(with("9,30,0,0\n").find("not between 0 and solve.t_end"), std::string::npos);
}

TEST(Verification, RefusesDamagedTables) {
  const Case c = motion_case();
  const Folder folder;
  const auto with = [&](const std::string& table) {
    write_fem_run(folder / "run", c, scaled(c));
    test::write(folder / "run" / "history.csv", table);
    return complaint(c, folder / "run");
  };
  const std::string header = "t [s],r [m],force [N],force_mode [N]\n";
  EXPECT_NE(with(header + "0,0.3,0,0\n0.1,nan,0,0\n").find("row 3: \"nan\" is not a finite number"), std::string::npos);
  EXPECT_NE(with(header + "0,0.3,0,\n").find("row 2: \"\" is not a finite number"), std::string::npos);
  EXPECT_NE(with(header + "0,0.3,0\n").find("row 2: has 3 columns; the first row names 4"), std::string::npos);
  EXPECT_NE(with("t [s],r [m],force [N]\n0,0.3,0\n").find("has no column force_mode; it has t, r, force"),
            std::string::npos);
  EXPECT_NE(with("t,r [m],force [N],force_mode [N]\n0,0.3,0,0\n").find("\"t\" has no unit"), std::string::npos);
  EXPECT_NE(with("t [m],r [m],force [N],force_mode [N]\n0,0.3,0,0\n").find("\"t [m]\""), std::string::npos);
  EXPECT_NE(with(header).find("has no rows"), std::string::npos);
  EXPECT_NE(with("t [s],r [").find("has no line of column names"), std::string::npos);
  EXPECT_NE(with("").find("has no line of column names"), std::string::npos);
  std::filesystem::remove(folder / "run" / "history.csv");
  EXPECT_NE(complaint(c, folder / "run").find("it has no history.csv"), std::string::npos);
  EXPECT_NE(complaint(c, folder / "none").find("it has no resolved.toml"), std::string::npos);
}

// 0.2 s and 0.2... cut from 0.25 s look alike: a line without its end is never a row.
TEST(Verification, LeavesOutALineThatIsCutOff) {
  const Case c = motion_case();
  const Folder folder;
  write_fem_run(folder / "run", c, scaled(c));
  const std::string whole = test::contents(folder / "run" / "history.csv");
  for (const std::size_t missing : {1U, 5U}) {
    test::write(folder / "run" / "history.csv", whole.substr(0, whole.size() - missing));
    const FemHistory history = read_fem_history(c, folder / "run");
    EXPECT_EQ(history.rows.size(), 50U);
    ASSERT_EQ(history.warnings.size(), 1U);
    EXPECT_EQ(history.warnings[0].name, "fem-cut");
  }
  std::filesystem::remove(folder / "run" / "run.json");
  EXPECT_EQ(read_fem_history(c, folder / "run").status, "unknown");
}

// The case's own closure is among them, whatever it is.
TEST(Verification, ComparesEveryClosureThatThereIs) {
  const Case c = motion_case({"model.closure=profile", "model.profile=profile-orifice.csv"});
  const Verification v = verified(c, scaled(c));
  EXPECT_EQ(v.closures, compared_closures(c));
  for (const Closure closure : {Closure::profile, Closure::calibrated}) {
    const auto at = std::ranges::find(v.closures, closure) - v.closures.begin();
    ASSERT_LT(static_cast<std::size_t>(at), v.closures.size());
    EXPECT_EQ(v.rows[35].models[static_cast<std::size_t>(at)], force(c, closure, v.rows[35].fem.time));
  }
}

}  // namespace
}  // namespace turgor
