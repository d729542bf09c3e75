#include "turgor/fem/run_flow.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "fake_flow.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {
namespace {

using test::fake_case;
using test::FakeFlow;
using test::Folder;

nlohmann::json report_in(const std::filesystem::path& folder) {
  return nlohmann::json::parse(test::contents(folder / "run.json"));
}

/// Everything but times by the clock on the wall.
void expect_same_results(const std::filesystem::path& a, const std::filesystem::path& b) {
  EXPECT_EQ(test::contents(a / "history.csv"), test::contents(b / "history.csv"));
  EXPECT_EQ(test::timeless(a / "solver.csv"), test::timeless(b / "solver.csv"));
  EXPECT_EQ(test::contents(a / "fields.pvd"), test::contents(b / "fields.pvd"));
  for (const std::string name : {"flow-00000.vtu", "flow-00001.vtu", "flow-00002.vtu"}) {
    EXPECT_EQ(test::contents(a / "fields" / name), test::contents(b / "fields" / name)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(a / "fields" / "flow-00003.vtu"));
}

/// A run from start to end.
void run_whole(const Case& c, const std::filesystem::path& path) {
  FakeFlow flow(c);
  FlowRunFolder folder(path, c, EarlierRun::refuse);
  ASSERT_EQ(run_flow(c, flow, folder).status, "complete");
}

/// Goes on with a run to its end.
void run_rest(const Case& c, const std::filesystem::path& path) {
  FakeFlow flow(c);
  FlowRunFolder folder(path, c, EarlierRun::resume);
  ASSERT_EQ(run_flow(c, flow, folder).status, "complete");
}

// What `turgor verify` reads is what was written here.
TEST(RunFlow, ForcesAreReadBack) {
  const Folder folder;
  const Case c = fake_case({"output.time_unit=ms", "output.length_unit=mm"});
  FakeFlow flow(c);
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  ASSERT_EQ(run_flow(c, flow, files, {.progress = [](double t) { return t < 3; }}).status, "interrupted");
  const FemHistory history = read_fem_history(c, folder / "run");
  EXPECT_EQ(history.status, "interrupted");
  ASSERT_EQ(history.rows.size(), 7U);
  EXPECT_EQ(history.warnings.size(), 1U);
  EXPECT_DOUBLE_EQ(history.rows.back().time, 3);
  EXPECT_EQ(history.rows.back().force, flow.row().force);
  EXPECT_EQ(history.rows.back().force_mode, flow.row().force_mode);
}

TEST(RunFlow, StepsOntoRowsFieldsAndKnots) {
  const Folder folder;
  const Case c = fake_case({"solve.samples=8", "fem.fields=4"});  // neither falls on a knot
  FakeFlow flow(c);
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  const FlowRunResult result = run_flow(c, flow, files);
  EXPECT_EQ(result.status, "complete");
  EXPECT_EQ(result.time, 5);
  EXPECT_EQ(result.steps, static_cast<long>(flow.stops().size()));
  for (const FlowStop& stop : flow_stops(c)) {
    EXPECT_EQ(std::ranges::count(flow.stops(), stop.time), stop.time > 0 ? 1 : 0) << stop.time;
  }
  for (const auto& interval : c.motion->intervals(5)) {
    EXPECT_TRUE(std::ranges::any_of(flow.stops(), [&](double t) { return std::abs(t - interval.end) < 5e-12; }));
  }
  const auto history = test::lines_of(test::contents(files.path() / "history.csv"));
  ASSERT_EQ(history.size(), 9U);
  EXPECT_TRUE(history[0].starts_with("t [s],p_gauge [Pa],r [cm],drdt [cm/s],d2rdt2 [cm/s^2],force [N]")) << history[0];
  EXPECT_TRUE(history[1].starts_with("0,0,30,0,0,0.4,")) << history[1];
  EXPECT_TRUE(history[8].starts_with("5,")) << history[8];
  EXPECT_EQ(test::lines_of(test::contents(files.path() / "solver.csv")).size(), flow.stops().size() + 1);
  const auto report = report_in(files.path());
  EXPECT_EQ(report.at("status"), "complete");
  EXPECT_EQ(report.at("steps"), result.steps);
  EXPECT_EQ(report.at("work").at("nonlinear_iterations"), 3 * result.steps);
  EXPECT_FALSE(std::filesystem::exists(files.path() / "checkpoint.bin"));
}

// 0.1 + 0.2 s is not 0.3 s: the row is where it was asked for, and no step is 1e-17 s long.
TEST(RunFlow, TimesThatDifferByRoundingAreOne) {
  Case c = fake_case();
  c.solve.samples = 0;
  c.solve.times = {0.3, 0.5};
  c.fem.fields = 0;
  c.fem.field_times = {0.1 + 0.2};
  const auto stops = flow_stops(c);
  ASSERT_GE(stops.size(), 3U);
  EXPECT_EQ(stops[0].time, 0.3);
  EXPECT_TRUE(stops[0].row);
  EXPECT_TRUE(stops[0].field);
  for (std::size_t i = 1; i < stops.size(); ++i) EXPECT_GT(stops[i].time - stops[i - 1].time, 1e-3);
}

// SIGKILL in the middle of a step, as an abrupt end has it: nothing is flushed, no destructor runs.
TEST(RunFlow, KilledRunGoesOnToTheSameBits) {
  const Folder folder;
  const Case c = fake_case();
  run_whole(c, folder / "whole");
  for (const long last : {0L, 1L, 5L, 6L, 17L, 45L}) {
    const auto path = folder / ("killed" + std::to_string(last));
    const pid_t child = fork();
    if (child == 0) {
      FakeFlow flow(c, [&](long taken) {
        if (taken == last) (void)raise(SIGKILL);
      });
      FlowRunFolder files(path, c, EarlierRun::refuse);
      (void)run_flow(c, flow, files);
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(report_in(path).at("status"), "running");
    EXPECT_EQ(test::lines_of(test::contents(path / "solver.csv")).size(), static_cast<std::size_t>(last) + 1);
    run_rest(c, path);
    expect_same_results(path, folder / "whole");
  }
}

// A checkpoint only at the start: everything after it is cut off and computed again.
TEST(RunFlow, RowsAfterTheCheckpointAreCutOff) {
  const Folder folder;
  const Case c = fake_case({"fem.checkpoint_every=1000 s"});
  run_whole(c, folder / "whole");
  const pid_t child = fork();
  if (child == 0) {
    FakeFlow flow(c, [&](long taken) {
      if (taken == 40) (void)raise(SIGKILL);
    });
    FlowRunFolder files(folder / "killed", c, EarlierRun::refuse);
    (void)run_flow(c, flow, files);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(std::filesystem::exists(folder / "killed" / "fields" / "flow-00001.vtu"));
  {
    FlowRunFolder files(folder / "killed", c, EarlierRun::resume);
    EXPECT_EQ(test::lines_of(test::contents(folder / "killed" / "solver.csv")).size(), 1U);
    EXPECT_EQ(test::lines_of(test::contents(folder / "killed" / "history.csv")).size(), 2U);
    EXPECT_FALSE(std::filesystem::exists(folder / "killed" / "fields" / "flow-00001.vtu"));
  }
  run_rest(c, folder / "killed");
  expect_same_results(folder / "killed", folder / "whole");
}

TEST(RunFlow, InterruptedRunGoesOn) {
  const Folder folder;
  const Case c = fake_case({"fem.checkpoint_every=1000 s"});
  run_whole(c, folder / "whole");
  {
    FakeFlow flow(c);
    FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
    const FlowRunResult result = run_flow(c, flow, files, {.progress = [](double time) { return time < 2; }});
    EXPECT_EQ(result.status, "interrupted");
    EXPECT_EQ(result.time, 2);
    EXPECT_NE(result.message.find("t = 2 s"), std::string::npos) << result.message;
    EXPECT_EQ(report_in(files.path()).at("status"), "interrupted");
  }
  {
    FakeFlow flow(c);
    FlowRunFolder files(folder / "run", c, EarlierRun::resume);
    const FlowRunResult result = run_flow(c, flow, files, {.max_wall_seconds = 1e-9});
    EXPECT_EQ(result.status, "interrupted");
    EXPECT_EQ(flow.stops().size(), 1U);
    EXPECT_NE(result.message.find("--max-wall-time"), std::string::npos) << result.message;
  }
  run_rest(c, folder / "run");
  expect_same_results(folder / "run", folder / "whole");
  for (const std::string key : {"steps", "work"}) {
    EXPECT_EQ(report_in(folder / "run").at(key), report_in(folder / "whole").at(key)) << key;
  }
}

TEST(RunFlow, FailedStepKeepsWhatWasDone) {
  const Folder folder;
  const Case c = fake_case();
  FakeFlow flow(c, [](long taken) {
    if (taken == 13) throw ComputationFailed("no convergence");
  });
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  const FlowRunResult result = run_flow(c, flow, files);
  EXPECT_EQ(result.status, "failed");
  EXPECT_EQ(result.steps, 13);
  for (const std::string words : {"t = 1.2 s", "r = 0.3", "dr/dt = 0.02 m/s", "after 13 steps", "no convergence"}) {
    EXPECT_NE(result.message.find(words), std::string::npos) << result.message;
  }
  const auto report = report_in(files.path());
  EXPECT_EQ(report.at("status"), "failed");
  EXPECT_EQ(report.at("message"), result.message);
  EXPECT_EQ(CheckpointFiles(files.path()).load().checkpoint.step, 13);
  EXPECT_TRUE(std::filesystem::exists(files.path() / "fields" / "flow-00001.vtu"));  // the last state
}

TEST(RunFlow, GivesUpAfterMaxSteps) {
  const Folder folder;
  const Case c = fake_case({"fem.max_steps=5"});
  FakeFlow flow(c);
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  const FlowRunResult result = run_flow(c, flow, files);
  EXPECT_EQ(result.status, "failed");
  EXPECT_EQ(result.steps, 5);
  EXPECT_NE(result.message.find("fem.max_steps = 5"), std::string::npos) << result.message;
}

// A state that is not finite reaches no file: the run fails at its first row, and the checkpoint is the one before.
TEST(RunFlow, NotANumberEndsTheRun) {
  const Folder folder;
  const Case c = fake_case({"fem.checkpoint_every=1000 s"});
  FakeFlow* self = nullptr;
  FakeFlow flow(c, [&](long taken) {
    if (taken == 12) self->spoil();
  });
  self = &flow;
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  const FlowRunResult result = run_flow(c, flow, files);
  EXPECT_EQ(result.status, "failed");
  EXPECT_NE(result.message.find("force is not a finite number"), std::string::npos) << result.message;
  EXPECT_EQ(test::contents(files.path() / "history.csv").find("nan"), std::string::npos);
  EXPECT_EQ(CheckpointFiles(files.path()).load().checkpoint.step, 0);
}

class Stuck : public FakeFlow {
 public:
  using FakeFlow::FakeFlow;
  SolverRow step(double /*t_stop*/) override { return {}; }
};

TEST(RunFlow, StepThatLeadsNowhereFails) {
  const Folder folder;
  const Case c = fake_case();
  Stuck flow(c);
  FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
  const FlowRunResult result = run_flow(c, flow, files);
  EXPECT_EQ(result.status, "failed");
  EXPECT_NE(result.message.find("led to 0 s"), std::string::npos) << result.message;
}

TEST(RunFlow, CorruptCheckpointFallsBackWithAWarning) {
  const Folder folder;
  const Case c = fake_case();
  run_whole(c, folder / "whole");
  {
    FakeFlow flow(c);
    FlowRunFolder files(folder / "run", c, EarlierRun::refuse);
    (void)run_flow(c, flow, files, {.progress = [](double time) { return time < 3.1; }});
  }
  std::string bytes = test::contents(folder / "run" / "checkpoint.bin");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  test::write(folder / "run" / "checkpoint.bin", bytes);
  FakeFlow flow(c);
  FlowRunFolder files(folder / "run", c, EarlierRun::resume);
  const FlowRunResult result = run_flow(c, flow, files);
  EXPECT_EQ(result.status, "complete");
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings[0].text.find("checksum"), std::string::npos) << result.warnings[0].text;
  expect_same_results(folder / "run", folder / "whole");
}

}  // namespace
}  // namespace turgor
