// Liquid and elastic wall together, on coarse meshes.

#include "turgor/fem/coupled_flow.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../support/fem.hpp"
#include "coupled_balloon.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/fem/run_flow.hpp"

namespace turgor {
namespace {

TEST(CoupledFlow, StaysAtRestWithoutPressure) {
  const auto flow = make_coupled_flow(case_of(balloon(R"([{ hold = "1 s" }])")));
  for (int i = 0; i < 5; ++i) (void)flow->step(1);
  EXPECT_LT(flow->row().kinetic, 1e-20);
  EXPECT_NEAR(flow->row().elastic, 0, 1e-15);
}

// Ring-down after a push of 0.05 Pa, which moves the liquid in the orifice by 0.01 r_ch. The eigenproblem is of the
// membrane's tangent and of the mass of a potential flow by a Laplacian of its own; the frequencies of another program
// at R = 1.1 were 1.054 and 1.870 Hz, rim hinged.
TEST(CoupledFlow, OscillatesWithTheModesOfWallAndAddedMass) {
  const HeldBalloon held(stretched("1.1", "time_step = \"5 ms\"\n"));
  const auto modes = held.modes(2);
  const std::array<double, 2> frequency{hertz(modes[0]), hertz(modes[1])};
  EXPECT_NEAR(frequency[0], 1.054, 0.01 * 1.054);
  EXPECT_NEAR(frequency[1], 1.870, 0.01 * 1.870);
  const FittedModes found = fitted_modes(ring_down(held.pushed(0.05), 2), frequency);
  EXPECT_LT(found.left, 0.05);
  EXPECT_NEAR(found.ratio[0], 1, 0.01);
  EXPECT_NEAR(found.ratio[1], 1, 0.01);
}

constexpr const char* push = R"([{ to = "300 Pa", over = "0.3 s", shape = "smooth" }, { hold = "1 s" }])";

/// Of energy and volume at 0.6 s: relative to the work of the inlet, and to the volume that has entered.
std::array<double, 2> imbalance(const char* step) {
  const auto flow = make_coupled_flow(case_of(balloon(
      push, std::string("tolerance = 1e-8\ntime_step = \"") + step + "\"\n[wall]\ndamping_time = \"10 ms\"\n")));
  const double start = flow->row().volume;
  SolverRow last{};
  while (flow->time() < 0.6) last = flow->step(flow->time() < 0.3 ? 0.3 : 0.6);
  const FlowRow row = flow->row();
  EXPECT_GT(row.damping_work, 0);
  const double energy = row.kinetic + row.wall_kinetic + row.elastic;
  const double losses = row.viscous_work + row.stabilisation_work + row.damping_work;
  return {std::abs(energy + losses - row.inlet_work) / row.inlet_work,
          std::abs(last.volume_error) * start / (row.volume - start)};
}

TEST(CoupledFlow, EnergyAndVolumeBalanceToSecondOrder) {
  const auto coarse = imbalance("10 ms");
  const auto fine = imbalance("5 ms");
  EXPECT_LT(fine[0], 0.35 * coarse[0]);
  EXPECT_LT(fine[0], 2e-2);  // twice what it is
  EXPECT_LT(fine[1], 0.35 * coarse[1]);
  EXPECT_LT(fine[1], 1e-3);  // of what has entered
}

TEST(CoupledFlow, GoesOnFromACheckpointToTheSameBits) {
  const Case c = case_of(balloon(push));
  const auto through = make_coupled_flow(c);
  for (int i = 0; i < 4; ++i) (void)through->step(0.3);
  Checkpoint checkpoint;
  through->save(checkpoint);
  checkpoint.step = 4;
  const auto resumed = make_coupled_flow(c);
  resumed->load(checkpoint);
  for (int i = 0; i < 4; ++i) {
    (void)through->step(0.3);
    (void)resumed->step(0.3);
  }
  EXPECT_EQ(through->time(), resumed->time());
  const FlowRow a = through->row();
  const FlowRow b = resumed->row();
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.kinetic, b.kinetic);
  EXPECT_EQ(a.inlet_work, b.inlet_work);
}

// Begins with the volume of a stretched sphere, at rest; the pressure that holds it there keeps it there.
TEST(CoupledFlow, StartsStretchedAndStaysInEquilibrium) {
  const auto flow = make_coupled_flow(HeldBalloon(stretched("1.3")).pushed(0));
  const double radius = flow->row().radius;
  EXPECT_NEAR(radius, 0.39, 1e-3);
  for (int i = 0; i < 5; ++i) (void)flow->step(1);
  EXPECT_NEAR(flow->row().radius / radius, 1, 1e-9);
}

// Forty steps a period at least, however long the run.
TEST(CoupledFlow, StepsFollowAPressureThatOscillates) {
  std::string text = balloon("[]");
  const std::string segments = "segments = []";
  text.replace(text.find(segments), segments.size(), R"(harmonic = { amplitude = "1 Pa", frequency = "10 Hz" })");
  const auto flow = make_coupled_flow(case_of(text));
  for (int i = 0; i < 20; ++i) EXPECT_LE(flow->step(10).dt, 1.0 / 400 * (1 + 1e-9));
}

TEST(CoupledFlow, RefusesWhatItCannotStartFrom) {
  std::string text = balloon(push);
  text.replace(text.find("stretch = 1"), 11, "stretch = 1\nstretch_rate = \"0.1 1/s\"");
  EXPECT_THROW((void)make_coupled_flow(case_of(text)), InvalidInput);
}

/// What a balloon ends with that does not reach half a second.
std::string failure_under(const std::string& segments, const std::string& more) {
  const auto flow = make_coupled_flow(case_of(balloon(segments, more)));
  try {
    while (flow->time() < 0.5) (void)flow->step(0.5);
  } catch (const ComputationFailed& failure) {
    return failure.what();
  }
  return "reached its end";
}

// A blow of 5 MPa within half a step, which is not to be halved.
TEST(CoupledFlow, SaysThatAFixedStepIsTooLong) {
  const std::string text = failure_under(R"([{ to = "5 MPa", over = "10 ms", shape = "smooth" }, { hold = "1 s" }])",
                                         "time_step = \"20 ms\"\n");
  EXPECT_NE(text.find("with a step of 0.02 s from t = "), std::string::npos) << text;
  EXPECT_NE(text.find("[pressure]"), std::string::npos) << text;
  EXPECT_NE(text.find("shorter fem.time_step"), std::string::npos) << text;
}

// A jump of 5 MPa, a hundred times what the wall can hold: the jet shoots ahead, and no step is short enough for long.
TEST(CoupledFlow, SaysThatAPressureRisesTooFastForTheMesh) {
  const std::string text =
      failure_under(R"([{ step = "5 MPa" }, { hold = "1 s" }])", "cfl = 0.5\nerror_tolerance = 1e-2\n");
  EXPECT_NE(text.find("[pressure] may change faster there than mesh and steps can follow"), std::string::npos) << text;
  EXPECT_NE(text.find("fem.h_rim"), std::string::npos) << text;
  EXPECT_NE(text.find("fem.error_tolerance"), std::string::npos) << text;
  EXPECT_NE(text.find("the last longer one failed: Newton's method did not converge"), std::string::npos) << text;
}

}  // namespace
}  // namespace turgor
