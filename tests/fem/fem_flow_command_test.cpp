// turgor fem flow, with a flow that is none behind it.

#include "cli/fem_flow_command.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/guarded.hpp"
#include "fake_flow.hpp"

namespace turgor {
namespace {

using test::FakeFlow;
using test::Folder;

/// What a command leaves behind.
struct Finished {
  int code;
  std::string out;
  std::string err;
};

/// Runs the command on a shipped motion with the fake flow's settings.
/// @param before, warnings  as for FakeFlow
Finished fem_flow(std::vector<std::string> words, const std::function<void(long)>& before = {},
                  const std::vector<Warning>& warnings = {}) {
  const std::string file = std::string(TURGOR_CASES) + "/motion-orifice-30mm.toml";
  words.insert(words.begin(),
               {"flow", file, "--no-pictures", "--set", "solve.samples=11", "--set", "fem.time_step=0.1 s"});
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  CLI::App app;
  cli::FemFlowArguments arguments;
  cli::add_fem_flow(app, arguments);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  int code = cli::exit_bad_input;
  try {
    app.parse(words);
    code = cli::guarded(arguments.input.json, [&] {
      const auto make = [&](const Case& c) { return std::make_unique<FakeFlow>(c, before, warnings); };
      return cli::compute_fem_flow(arguments, make, {{"deal.II", "9.4.1"}});
    });
  } catch (const CLI::ParseError& error) {
    app.exit(error);
  }
  const std::string out = testing::internal::GetCapturedStdout();
  return {code, out, testing::internal::GetCapturedStderr()};
}

TEST(FemFlowCommand, WritesARunDirectory) {
  const Folder folder;
  const auto run = fem_flow({"-o", (folder / "run").string()});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("1 cells, 2 unknowns"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("written to "), std::string::npos) << run.out;
  for (const std::string file : {"case.toml", "resolved.toml", "history.csv", "solver.csv", "fields.pvd", "run.json"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "run" / file)) << file;
  }
  EXPECT_EQ(fem_flow({"-o", (folder / "quiet").string(), "-q"}).out, "");
  const auto again = fem_flow({"-o", (folder / "run").string()});
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("--resume"), std::string::npos) << again.err;
  EXPECT_EQ(fem_flow({"-o", (folder / "run").string(), "--force"}).code, 0);
}

TEST(FemFlowCommand, PrintsTheReport) {
  const Folder folder;
  const auto run = fem_flow({"-o", (folder / "run").string(), "--json"});
  EXPECT_EQ(run.out, test::contents(folder / "run" / "run.json"));
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report.at("versions").at("deal.II"), "9.4.1");
  EXPECT_EQ(report.at("discretisation").at("unknowns"), 2);
}

// What is known before the run is said before it, while there is time to stop.
TEST(FemFlowCommand, WarnsBeforeItBegins) {
  const Folder folder;
  const auto run = fem_flow({"-o", (folder / "run").string()}, [](long taken) {
    if (taken == 0) std::cerr << "first step\n";
  });
  EXPECT_EQ(run.err, "first step\n");
  const auto warned = fem_flow({"-o", (folder / "warned").string()},
                               [](long taken) {
                                 if (taken == 0) std::cerr << "first step\n";
                               },
                               {{"made-up", "a made-up reason"}});
  EXPECT_EQ(warned.err, "warning: a made-up reason\nfirst step\n");
  EXPECT_NE(test::contents(folder / "warned" / "run.json").find("a made-up reason"), std::string::npos);
  EXPECT_EQ(fem_flow({"-o", (folder / "quiet").string(), "-q"}, {}, {{"made-up", "a made-up reason"}}).err, "");
}

TEST(FemFlowCommand, NeedsADictatedMotion) {
  const Folder folder;
  const auto run = fem_flow({"-o", (folder / "run").string(), "--set", "motion.radius=-1 m"});
  EXPECT_EQ(run.code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
  EXPECT_EQ(fem_flow({"--resume", "--force"}).code, 2);
  EXPECT_EQ(fem_flow({"--max-wall-time", "-3"}).code, 2);
  EXPECT_EQ(fem_flow({"--resume", "-o", (folder / "none").string()}).code, 2);
}

TEST(FemFlowCommand, FailedStepIsExitCodeFour) {
  const Folder folder;
  const auto run = fem_flow({"-o", (folder / "run").string(), "-q"}, [](long taken) {
    if (taken == 9) throw ComputationFailed("no convergence");
  });
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("error: stopped at t = "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("no convergence"), std::string::npos) << run.err;
}

// In a process of its own: a signal that was caught stays so. The signal comes during a step, which is finished.
TEST(FemFlowCommand, SignalsStopItWithACheckpoint) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Folder folder;
    const std::string path = (folder / "run").string();
    const pid_t child = fork();
    if (child == 0) {
      const auto run = fem_flow({"-o", path}, [&](long taken) {
        if (taken == 20) (void)raise(signal);
      });
      _exit(run.err.find("go on with --resume") == std::string::npos ? 1 : run.code);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_EQ(CheckpointFiles(folder / "run").load().checkpoint.step, 21);
    EXPECT_EQ(fem_flow({"-o", path, "--resume"}).code, 0);
  }
}

TEST(FemFlowCommand, StopsWhenItsTimeIsOver) {
  const Folder folder;
  const auto run = fem_flow({"-o", (folder / "run").string(), "--max-wall-time", "1e-9"});
  EXPECT_EQ(run.code, 130);
  EXPECT_NE(run.err.find("--max-wall-time is over"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace turgor
