// Members are the cases that --set would give, and chunks keep their results whatever happens to one of them.

#include <gtest/gtest.h>

#include <cmath>

#include "../support/program.hpp"
#include "sweep/chunk.hpp"
#include "sweep/journal.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/quantities.hpp"
#include "turgor/run/run_case.hpp"

namespace turgor {
namespace {

std::filesystem::path shipped(const std::string& name) {
  return std::filesystem::path(TURGOR_CASES) / (name + ".toml");
}

void expect_same(const Case& a, const Case& b) {
  const auto& p = a.parameters;
  const auto& q = b.parameters;
  for (const auto& [x, y] : {std::pair{p.radius, q.radius},
                             {p.thickness, q.thickness},
                             {p.solid_density, q.solid_density},
                             {p.fluid_density, q.fluid_density},
                             {p.fluid_viscosity, q.fluid_viscosity},
                             {p.orifice_radius, q.orifice_radius},
                             {p.channel_length, q.channel_length},
                             {strain_energy(p.material, 1.3).first, strain_energy(q.material, 1.3).first},
                             {a.stretch, b.stretch},
                             {a.stretch_rate, b.stretch_rate},
                             {a.max_stretch, b.max_stretch},
                             {a.auto_tolerance, b.auto_tolerance},
                             {a.scales.length, b.scales.length},
                             {a.scales.pressure, b.scales.pressure},
                             {a.scales.time, b.scales.time},
                             {a.solve.t_end, b.solve.t_end},
                             {a.solve.rtol, b.solve.rtol},
                             {a.solve.atol, b.solve.atol},
                             {a.solve.rest_tol, b.solve.rest_tol}}) {
    EXPECT_EQ(x, y);
  }
  EXPECT_EQ(p.closure, q.closure);
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(a.material_name, b.material_name);
  EXPECT_EQ(a.solve.max_events, b.solve.max_events);
  EXPECT_EQ(a.solve.max_steps, b.solve.max_steps);
  EXPECT_EQ(a.solve.samples, b.solve.samples);
  for (double t = 0; t < a.solve.t_end; t += a.solve.t_end / 41) EXPECT_EQ(a.pressure(t), b.pressure(t));
}

struct Change {
  std::string file;
  std::string key;
  Node value;
  std::string text;  ///< the same for --set
};

Node quantity(double value, const std::string& unit) { return {Node::Quantity{value, unit}, "", 0}; }

TEST(CaseTemplate, GivesTheCaseThatSetGives) {
  const double odd = 0.1 + 0.2;  // needs all its digits
  const std::vector<Change> changes{
      {"orifice-10mm", "inlet.orifice_radius", quantity(odd / 30, "m"), shortest(odd / 30) + " m"},
      {"orifice-10mm", "balloon.thickness", quantity(odd / 100, "m"), shortest(odd / 100) + " m"},
      {"orifice-10mm", "material.s1", quantity(odd * 1e6, "Pa"), shortest(odd * 1e6) + " Pa"},
      {"orifice-10mm", "pressure.segments[0].to", quantity(odd * 1e5, "Pa"), shortest(odd * 1e5) + " Pa"},
      {"orifice-10mm", "pressure.segments[1].hold", quantity(odd, "s"), shortest(odd) + " s"},
      {"orifice-10mm", "solve.rtol", {odd * 1e-6, "", 0}, shortest(odd * 1e-6)},
      {"orifice-10mm", "solve.max_events", {std::int64_t{3}, "", 0}, "3"},
      {"orifice-10mm", "model.name", {std::string("auto"), "", 0}, "auto"},
      {"orifice-10mm", "model.closure", {std::string("theoretical"), "", 0}, "theoretical"},
      {"orifice-10mm", "model.closure", {std::string("potential"), "", 0}, "potential"},
      {"orifice-10mm", "initial.stretch", {std::string("equilibrium"), "", 0}, "equilibrium"},
      {"orifice-10mm", "initial.stretch_rate", quantity(odd, "1/s"), shortest(odd) + " 1/s"},
      {"channel-30mm", "inlet.channel_length", quantity(odd, "m"), shortest(odd) + " m"},
      {"material-ogden", "material.mu[0]", quantity(odd * 1e6, "Pa"), shortest(odd * 1e6) + " Pa"},
      {"material-gent", "material.jm", {odd * 100, "", 0}, shortest(odd * 100)},
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.file + " " + change.key);
    CaseTemplate blank(read_case(shipped(change.file)), {change.key});
    const Case member = blank.with(std::vector<Node>{change.value});
    expect_same(member, read_case(shipped(change.file), {change.key + "=" + change.text}));
    EXPECT_TRUE(member.resolved.empty());
    EXPECT_TRUE(member.expectations.empty());
  }
}

TEST(CaseTemplate, ForgetsTheMemberBefore) {
  CaseTemplate blank(read_case(shipped("orifice-10mm")), {"model.name", "initial.stretch"});
  const Node full{std::string("full"), "", 0};
  const Node automatic{std::string("auto"), "", 0};
  EXPECT_EQ(blank.with(std::vector<Node>{full, {1.2, "", 0}}).model, Model::full);
  const Case second = blank.with(std::vector<Node>{automatic, {1.1, "", 0}});
  EXPECT_EQ(second.model, std::nullopt);
  EXPECT_EQ(second.stretch, 1.1);
}

TEST(CaseTemplate, SaysWhatDoesNotGoTogether) {
  CaseTemplate blank(read_case(shipped("orifice-10mm")), {"inlet.orifice_radius"});
  try {
    (void)blank.with(std::vector<Node>{quantity(0.31, "m")});
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().key, "inlet.orifice_radius");
    EXPECT_EQ(error.issues().front().value, "\"0.31 m\"");
  }
  EXPECT_THROW(CaseTemplate(read_case(shipped("orifice-10mm")), {"pressure.segments[9].to"}), InvalidInput);
}

Case with_sweep(const std::string& table, const std::string& end = "3 s") {
  return read_case(shipped("orifice-10mm"),
                   {"sweep=" + table, "solve.t_end=" + end, "solve.rtol=1e-11", "solve.atol=1e-11"});
}

TEST(Chunk, AnInvalidMemberStopsNoOther) {
  const Case c = with_sweep(
      R"({ event_times = 2, quantities = ["final_stretch", "end_time"], axes = { "inlet.orifice_radius" = { values = ["2 cm", "31 cm", "3 cm"] } } })");
  const ChunkResult chunk = ChunkRunner(c, SweepPlan(*c.sweep)).run(0);
  ASSERT_EQ(chunk.size(), 3U);
  EXPECT_EQ(chunk.row(1)[0], invalid_member);
  EXPECT_EQ(chunk.row(1)[2], 1);
  EXPECT_TRUE(std::isnan(chunk.row(1)[3]));
  EXPECT_EQ(chunk.messages, (std::vector<std::string>{"inlet.orifice_radius: the orifice is larger than the balloon"}));
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(chunk.row(i)[0], static_cast<double>(Outcome::reached_end));
    EXPECT_EQ(chunk.row(i)[2], 0);
    EXPECT_EQ(chunk.row(i)[4], 3.0);
  }
  const RunResult run = run_case(read_case(shipped("orifice-10mm"), {"inlet.orifice_radius=3 cm", "solve.t_end=3 s",
                                                                     "solve.rtol=1e-11", "solve.atol=1e-11"}));
  // A run steps one balloon at a time, a sweep several at once: they agree within some rtol.
  EXPECT_NEAR(chunk.row(2)[3], *run.quantity("final_stretch"), 1e-5);
  const double clock = run.oscillator->scales().time;
  ASSERT_GE(run.trajectory->events.size(), 1U);
  EXPECT_NEAR(chunk.row(2)[5], run.trajectory->events[0].time * clock, 1e-3);
  EXPECT_NEAR(chunk.row(2)[7], run.trajectory->events[0].stretch, 1e-5);
}

// Members with and without a table share a chunk, and fail by themselves. Axes go by name, the last one fastest.
// At 6 s the balloon falls.
TEST(Chunk, SweepsTheClosure) {
  const Case c = with_sweep(
      R"({ quantities = ["final_stretch"], axes = { "model.closure" = { values = ["corrected", "potential", "calibrated"] }, "inlet.orifice_radius" = { values = ["2 cm", "24 cm"] } } })",
      "6 s");
  const ChunkResult chunk = ChunkRunner(c, SweepPlan(*c.sweep)).run(0);
  ASSERT_EQ(chunk.size(), 6U);
  for (const std::size_t i : {0U, 1U, 2U, 3U}) EXPECT_EQ(chunk.row(i)[0], static_cast<double>(Outcome::reached_end));
  for (const std::size_t i : {4U, 5U}) EXPECT_EQ(chunk.row(i)[0], invalid_member);
  ASSERT_EQ(chunk.messages.size(), 2U);
  for (const auto& message : chunk.messages) {
    EXPECT_NE(message.find("beyond the range of model.closure"), std::string::npos);
  }
  const auto alone = [](const char* closure) {
    return *run_case(
                read_case(shipped("orifice-10mm"), {"inlet.orifice_radius=2 cm", "solve.t_end=6 s", "solve.rtol=1e-11",
                                                    "solve.atol=1e-11", std::string("model.closure=") + closure}))
                .quantity("final_stretch");
  };
  EXPECT_NEAR(chunk.row(0)[3], alone("corrected"), 1e-5);
  EXPECT_NEAR(chunk.row(1)[3], alone("potential"), 1e-5);
  EXPECT_NEAR(chunk.row(2)[3], alone("calibrated"), 1e-5);
  EXPECT_GT(std::abs(alone("calibrated") - alone("potential")), 1e-4);
  EXPECT_GT(std::abs(alone("corrected") - alone("potential")), 1e-4);
}

TEST(Chunk, SurvivesItsBytes) {
  const ChunkResult chunk{4, {1, 2, 3, -0.0, 5, 6, 7, 1e300}, {"one", "two words"}};
  const ChunkResult again = ChunkResult::decode(chunk.encode());
  EXPECT_EQ(again.width, 4U);
  EXPECT_EQ(again.rows, chunk.rows);
  EXPECT_EQ(again.messages, chunk.messages);
  EXPECT_THROW((void)ChunkResult::decode(chunk.encode().substr(0, 40)), ComputationFailed);
  EXPECT_THROW((void)ChunkResult::decode(""), ComputationFailed);
}

TEST(JournalOfASweep, KeepsChunksAndKnowsItsOwner) {
  const test::Folder folder;
  const Identity mine{{"case file", "a = 1\nb = 2\n"}};
  {
    Journal journal(folder / "o.part", mine);
    journal.store(2, "two");
    journal.store(0, std::string("\0zero", 5));
    // another sweep into the same file
    EXPECT_THROW(Journal(folder / "o.part", mine), InvalidInput);
  }
  {
    const Journal journal(folder / "o.part", mine);
    EXPECT_EQ(journal.finished(3), (std::vector<bool>{true, false, true}));
    std::vector<std::string> found;
    journal.read([&](const std::string& bytes) { found.push_back(bytes); });
    EXPECT_EQ(found, (std::vector<std::string>{std::string("\0zero", 5), "two"}));
  }
  try {
    const Journal journal(folder / "o.part", {{"case file", "a = 1\nb = 3\n"}});
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("the case file differs: it has \"b = 2\", now there is \"b = 3\""),
              std::string::npos)
        << error.what();
  }
  test::write(folder / "text.part", std::string(5000, 'x'));
  EXPECT_THROW(Journal(folder / "text.part", mine), InvalidInput);
}

}  // namespace
}  // namespace turgor
