// The numbers behind the figures, each against something that its figure does not use.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "../support/csv.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Csv;
using test::Folder;
using test::shipped;
using test::turgor;

/// A folder with one figure's tables.
class Figures : public testing::Test {
 protected:
  void make(const std::string& name) const {
    const auto result = turgor(folder_, {"figure", name, "-o", "out", "--no-pictures", "-q"});
    ASSERT_EQ(result.code, 0) << result.err;
  }
  [[nodiscard]] Csv table(const std::string& name) const { return Csv(folder_ / "out" / ("figure-" + name + ".csv")); }
  [[nodiscard]] json run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--json", "--force", "--no-pictures"});
    const auto result = turgor(folder_, arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    return json::parse(result.out);
  }

  Folder folder_;
};

constexpr double S2 = 6000;                      // 4 d0 s2/r0 of the shipped balloon [Pa]
constexpr double mean_pressure = 6.88560013375;  // of its limit pressures, in S2
constexpr double large = 4.80498978552;          // its equilibria there
constexpr double middle = 2.00438522920;

/// (3.1) for S1 = 10 and another ratio, in units of S2.
double static_pressure(double R, double ratio = 10) { return ratio * (1 / R - std::pow(R, -7)) + R - std::pow(R, -5); }

/// The potential of (3.22).
double potential(double R) {
  return (30 * (2 * R * R + std::pow(R, -4)) + 3 * (std::pow(R, 4) + 2 / (R * R)) - 4 * R * R * R * mean_pressure) / 6;
}

// Deflation by the command for snapshots; inflation by (2.3) with the acceleration from a difference of rates.
TEST_F(Figures, FlowIsThatOfTheRun) {
  make("2");
  const Csv wall = table("2-wall");
  const std::string c = shipped("channel-30mm");
  (void)run({"run", c, "-o", "run", "--set",
             "solve={t_end=\"120 s\", rtol=1e-9, times=[\"4.999 s\", \"5 s\", \"5.001 s\", \"35 s\"]}"});
  const Csv states(folder_ / "run" / "trajectory.csv");
  (void)run({"flow", c, "-o", "flow", "--resolution", "20", "--at",
             "time=35 s, stretch=" + states.text(3, "R [1]") + ", rate=" + states.text(3, "dRdt [1/s]")});
  const Csv snapshot(folder_ / "flow" / "wall.csv");
  ASSERT_EQ(wall.size(), snapshot.size() + 2);
  for (std::size_t i = 0; i < snapshot.size(); i += 50) {
    EXPECT_NEAR(wall(i, "p_gauge [Pa]"), snapshot(i, "p_gauge [Pa]"), 1e-6 * 18e3);
    EXPECT_NEAR(wall(i, "theta from the orifice [rad]") + snapshot(i, "theta [rad]"), std::numbers::pi, 1e-12);
  }
  const double r0 = 0.3;
  const double r = r0 * states(1, "R [1]");
  const double rate = r0 * states(1, "dRdt [1/s]");
  const double acceleration = r0 * (states(2, "dRdt [1/s]") - states(0, "dRdt [1/s]")) / 2e-3;
  const double kappa = 0.03 / r;
  const double speed = 4 / (kappa * kappa);  // of the channel by that of the wall, to O(kappa^2)
  const double expected = -1000 * 0.5 * speed * (acceleration + 2 * rate * rate / r);
  const std::size_t last = wall.size() - 1;
  const double jet = wall(last, "p_gauge [Pa]") - wall(last, "p_gauge at the inlet [Pa]");
  EXPECT_NEAR(jet / expected, 1, 2 * kappa * kappa);
  EXPECT_EQ(wall(last, "p_gauge [Pa]"), wall(last - 1, "p_gauge [Pa]"));
  EXPECT_EQ(table("2-streamlines")(0, "share of the outflow [1]"), 1.0 / 16);
}

TEST_F(Figures, ForcesAreThoseOfTheCommand) {
  make("3");
  const Csv peaks = table("3-peaks");
  ASSERT_EQ(peaks.size(), 16U);
  const Csv rows = table("3");
  std::map<std::pair<double, double>, std::map<std::string, double>> greatest;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double theory = rows(i, "force by (2.12) [N]");
    const double corrected = rows(i, "force by (2.15) [N]");
    const double rate = rows(i, "drdt [m/s]");
    auto& of = greatest[{rows(i, "r_ch [m]"), rows(i, "L_ch [m]")}];
    of["theoretical"] = std::max(of["theoretical"], theory);
    of["corrected"] = std::max(of["corrected"], corrected);
    if (rows(i, "L_ch [m]") > 0) continue;
    if (rate > 0) {
      EXPECT_EQ(corrected, 0);
    }
    const bool steady = rate < -0.0199 && std::abs(rows(i, "d2rdt2 [m/s^2]")) < 1e-12;
    if (steady) {
      EXPECT_NEAR(corrected / theory, 1.5625, 1e-12);
    }
  }
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const double r_ch = peaks(i, "r_ch [m]");
    const double length = peaks(i, "L_ch [m]");
    const std::string closure = peaks.text(i, "closure");
    const std::string name = std::string(length > 0 ? "motion-channel-" : "motion-orifice-") +
                             std::to_string(std::lround(1000 * r_ch)) + "mm";
    const json force = run({"force", shipped(name), "-o", "force"}).at("forces").at(closure);
    EXPECT_EQ(peaks(i, "deflating peak [N]"), force.at("peak_deflating").at("force_N").get<double>());
    EXPECT_EQ(peaks(i, "inflating peak [N]"), force.at("peak_inflating").at("force_N").get<double>());
    // rows are 1/500 of the motion apart; a peak's top is flat
    EXPECT_NEAR(greatest.at({r_ch, length}).at(closure) / peaks(i, "deflating peak [N]"), 1, 2e-3) << name;
  }
}

/// Of one response: where it ends and how high it came.
struct Ends {
  double last = 0, greatest = 0, at_half = 0;
};
std::map<std::pair<std::string, std::string>, Ends> ends_of(const Csv& rows) {
  std::map<std::pair<std::string, std::string>, Ends> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Ends& ends = all[{rows.text(i, "r_ch [m]"), rows.text(i, "model")}];
    ends.last = rows(i, "R [1]");
    ends.greatest = std::max(ends.greatest, ends.last);
    if (i % 1201 == 400) ends.at_half = ends.last;  // while the pressure is gone or falling
  }
  return all;
}

// Without pressure the equilibrium is R = 1, and the oscillation about it has all but died out.
TEST_F(Figures, ResponsesWithoutAChannel) {
  make("4");
  const auto all = ends_of(table("4"));
  ASSERT_EQ(all.size(), 8U);
  for (const char* r_ch : {"0.01", "0.015", "0.02", "0.03"}) {
    const Ends& own = all.at({r_ch, "orifice"});
    const Ends& full = all.at({r_ch, "full"});
    EXPECT_NEAR(own.last, 1, 3e-6);
    EXPECT_NEAR(own.greatest, 1.174653081369178, 1e-4);  // [expect] of the cases; rows are 0.05 s apart
    EXPECT_NEAR(full.at_half, own.at_half, 1e-4);        // the wall's inertia hardly matters
  }
  EXPECT_GT(all.at({"0.01", "orifice"}).at_half, all.at({"0.015", "orifice"}).at_half + 0.01);
}

TEST_F(Figures, ResponsesWithAChannel) {
  make("6");
  const auto all = ends_of(table("6"));
  ASSERT_EQ(all.size(), 6U);
  const Ends& widest = all.at({"0.03", "long-channel"});
  EXPECT_NEAR(widest.greatest, 1.199508756528874, 1e-4);
  EXPECT_NEAR(widest.last, 1, 1e-3);
  EXPECT_GT(all.at({"0.01", "long-channel"}).greatest, widest.greatest);
}

TEST_F(Figures, StaticsHaveTheKnownLimitPoints) {
  make("7");
  const Csv rows = table("7");
  std::vector<std::size_t> limits;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows(i, "P0/S2 [1]"), static_pressure(rows(i, "R [1]")), 1e-13);
    if (rows(i, "limit point") == 1) limits.push_back(i);
  }
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_NEAR(rows(limits[0], "R [1]"), 1.47606984746, 1e-11);
  EXPECT_NEAR(rows(limits[0], "P0/S2 [1]"), 7.45308777840, 1e-11);
  EXPECT_NEAR(rows(limits[1], "R [1]"), 3.14262133321, 1e-11);
  EXPECT_NEAR(rows(limits[1], "P0/S2 [1]"), 6.31811248909, 1e-11);
  EXPECT_NEAR(rows(limits[1], "p_gauge [Pa]"), 6.31811248909 * S2, 1e-6);

  const Csv closed = table("7-approximations");
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const double P = closed(i, "P0/S2 [1]");
    const bool real = P * P >= 40;  // (3.5)
    EXPECT_EQ(closed.empty(i, "R by (3.5) [1]"), !real) << P;
    EXPECT_EQ(closed.empty(i, "R by (3.3) [1]"), P > 7.45308777840) << P;
    if (real) {
      EXPECT_NEAR(closed(i, "R by (3.5) [1]"), (P + std::sqrt(P * P - 40)) / 2, 1e-12);
    }
    if (P < 1) {
      EXPECT_NEAR(closed(i, "R by (3.3) [1]"), closed(i, "least exact R [1]"), 1e-4 * P * P * P);
    }
  }
}

// Inflation from rest ends where the potential of (3.22) is what it was at the start, with and without a channel.
TEST_F(Figures, ApproachesKeepTheFirstIntegral) {
  make("8");
  const Csv rows = table("8");
  std::map<std::string, double> farthest;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double start = rows(i, "R_i [1]");
    if (start > large) continue;
    const std::string key = rows.text(i, "opening") + rows.text(i, "solution") + rows.text(i, "R_i [1]");
    farthest[key] = std::max(farthest[key], rows(i, "R [1]"));
  }
  ASSERT_EQ(farthest.size(), 16U);
  for (const char* opening : {"orifice", "channel"}) {
    for (const char* start : {"4.4", "4.5", "4.6", "4.7"}) {
      const double from = std::stod(start);
      const double to = farthest.at(opening + std::string("exact") + start);
      // dense output is within 1e-10, and the potential's slope there is about 10
      EXPECT_NEAR(potential(to), potential(from), 1e-8) << opening << start;
      const double closed = farthest.at(opening + std::string("closed") + start);
      const double away = large - from;
      EXPECT_NEAR(closed, to, (std::string(opening) == "channel" ? 0.2 * away : 0.4) * away * away) << opening << start;
    }
  }
}

TEST_F(Figures, PortraitsAreThoseOfTheCommand) {
  make("9");
  for (const char* name : {"orifice", "channel"}) {
    (void)run(
        {"portrait", shipped(std::string(name) + "-30mm"), "--pressure", "41313.60080247476 Pa", "-o", "portrait"});
    const Csv rows = table(std::string("9-") + name);
    const Csv expected(folder_ / "portrait" / "portrait.csv");
    ASSERT_NEAR(static_cast<double>(rows.size()), static_cast<double>(expected.size()), 5);  // pressures of 16 digits
    double nearest = 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows.text(i, "kind") != "separatrix") continue;
      nearest = std::min(nearest, std::hypot(rows(i, "R [1]") - middle, rows(i, "dR/dt [1/s]")));
    }
    EXPECT_LT(nearest, 1e-9);  // the separatrix runs into the unstable equilibrium
  }
}

TEST_F(Figures, DecayTendsToItsLaw) {
  make("decay");
  const Csv rows = table("decay");
  ASSERT_EQ(rows.size(), 2002U);
  for (const std::size_t first : {0U, 1001U}) {
    const double beta = rows(first, "beta [1]");
    EXPECT_NEAR(rows(first, "amplitude [1]") * beta, 10, 1e-9);
    // From far above, the balloon comes down to 1/(2 beta) below its equilibrium, and rises as far above it.
    EXPECT_NEAR(2 * beta * rows(first + 1, "amplitude [1]"), 1, 1e-3);
    for (const std::size_t n : {10U, 100U, 1000U}) {
      const double amplitude = rows(first + n, "amplitude [1]");
      const double law = 3 / (4 * beta * static_cast<double>(n));
      EXPECT_NEAR(amplitude / law, 1, 1.2 / static_cast<double>(n) + 1e-6 * static_cast<double>(n)) << n;
      EXPECT_NEAR(rows(first + n, "3/(4 beta n) [1]") / law, 1, 1e-14);
      EXPECT_NEAR(rows(first + n, "by half-cycles of Lambert's function [1]") / amplitude, 1, 1e-3);
    }
  }
  // (2.23): beta = C2 R^2 + 2/R, C2 = (600/223) (r0/r_ch)^3
  EXPECT_NEAR(rows(0, "beta [1]"), 600.0 / 223 * 1000 * large * large + 2 / large, 1e-5);
}

/// Slope of a logarithm between two rows.
double order(const Csv& rows, std::size_t i, std::size_t j, const std::string& x, const std::string& y) {
  return std::log(rows(j, y) / rows(i, y)) / std::log(rows(j, x) / rows(i, x));
}

TEST_F(Figures, ErrorsHaveTheirOrders) {
  make("errors");
  const Csv inflation = table("errors-inflation");
  const std::string e = "R_eq - R_i [1]";
  EXPECT_NEAR(order(inflation, 0, 10, e, "error of (3.18) [1]"), 2, 0.01);
  EXPECT_NEAR(order(inflation, 0, 10, e, "error of (3.19) [1]"), 3, 0.05);
  EXPECT_NEAR(order(inflation, 5, 15, e, "error of third order [1]"), 4, 0.1);
  const Csv times = table("errors-times");
  EXPECT_NEAR(order(times, 0, 10, "size of R_i - R_eq [1]", "error of pi/alpha [1]"), 2, 0.05);
  EXPECT_NEAR(order(times, 5, 15, "size of R_i - R_eq [1]", "error of corrected pi/alpha [1]"), 3, 0.1);
  const Csv rests = table("errors-equilibria");
  EXPECT_NEAR(order(rests, 1, 3, "P0/S2 [1]", "error of (3.3) [1]"), 3, 0.2);
  for (std::size_t i = 0; i < rests.size(); ++i) {
    const double P = rests(i, "P0/S2 [1]");
    EXPECT_EQ(rests.empty(i, "error of (3.3) [1]"), P > 7.45308777840) << P;
    EXPECT_EQ(rests.empty(i, "error of (3.5) [1]"), P * P < 40) << P;
  }
  const Csv deflation = table("errors-deflation");
  const std::size_t last = deflation.size() - 1;
  EXPECT_GT(std::abs(deflation(last, "error of (3.16) [1]")), 1e-4);  // of order 1 for T ~ sqrt(C2)
  EXPECT_LT(std::abs(deflation(last, "error of uniform [1]")), 1e-6);
  EXPECT_LT(std::abs(deflation(last, "error of refined uniform [1]")), 1e-9);
  EXPECT_LT(std::abs(deflation(0, "error of (3.12) [1]")), 1e-4 * std::abs(deflation(0, "error of (3.9) [1]")));
}

TEST_F(Figures, TheBistableWindowOpensAtTheCusp) {
  make("bistability");
  const Csv rows = table("bistability");
  EXPECT_NEAR(rows(0, "S1/S2 [1]"), 4.662910048479262, 1e-9);
  EXPECT_EQ(rows(0, "least P0/S2 [1]"), rows(0, "greatest P0/S2 [1]"));
  EXPECT_GT(rows.size(), 100U);
  for (std::size_t i = 1; i < rows.size(); i += 20) {
    const double ratio = rows(i, "S1/S2 [1]");
    const double from = 1.84;  // where the window opens; the maximum lies below, the minimum above
    double maximum = 0;
    double minimum = 1e9;
    for (double R = 1; R < 6; R += 1e-4) {
      if (R < from) maximum = std::max(maximum, static_pressure(R, ratio));
      if (R > from) minimum = std::min(minimum, static_pressure(R, ratio));
    }
    EXPECT_NEAR(rows(i, "greatest P0/S2 [1]"), maximum, 1e-6);  // the square of the scan's step, and its curvature
    EXPECT_NEAR(rows(i, "least P0/S2 [1]"), minimum, 1e-6);
    const double maxwell = rows(i, "Maxwell P0/S2 [1]");
    EXPECT_TRUE(minimum < maxwell && maxwell < maximum);
  }
}

// Corners of the map against single runs.
TEST_F(Figures, DesignsAreWhatRunsDo) {
  make("design");
  const Csv rows = table("design");
  ASSERT_EQ(rows.size(), 625U);
  const double filled = 1.1746530813;  // large enough for all but the last digits of a time
  const json rest = run({"statics", shipped("channel-30mm"), "--set", "pressure={constant=\"36 kPa\"}"});
  const double exact = rest.at("equilibria")[0].at("R");
  EXPECT_NEAR(exact, filled, 1e-3);
  for (const std::size_t corner : {0U, 24U, 600U, 624U}) {
    const auto stroke = [&](const std::string& pressure, double stretch, const char* quantity) {
      const json document = run({"run",   shipped("channel-30mm"),
                                 "-o",    "run",
                                 "--set", "model.name=full",
                                 "--set", "pressure={constant=\"" + pressure + "\"}",
                                 "--set", "initial.stretch=" + json(stretch).dump(),
                                 "--set", "inlet.orifice_radius=" + rows.text(corner, "r_ch [m]") + " m",
                                 "--set", "inlet.channel_length=" + rows.text(corner, "L_ch [m]") + " m",
                                 "--set", "solve.max_events=1",
                                 "--set", "solve.t_end=1e5 s",
                                 "--set", "expect={}"});
      return document.at("quantities").at(quantity).get<double>();
    };
    // both integrate to 1e-9 a step, by different arithmetic
    EXPECT_NEAR(rows(corner, "rise time [s]") / stroke("36 kPa", 1, "rise_time"), 1, 1e-6);
    EXPECT_NEAR(rows(corner, "fall time [s]") / stroke("0 Pa", exact, "fall_time"), 1, 1e-6);
  }
  // With the inertia of the channel alone, (2.25), times go with sqrt(L); emptying depends on the radius.
  EXPECT_NEAR(rows(600, "rise time [s]") / rows(0, "rise time [s]"), std::sqrt(40), 0.02 * std::sqrt(40));
  EXPECT_NEAR(rows(600, "fall time [s]") / rows(0, "fall time [s]"), 1, 0.02);
}

}  // namespace
}  // namespace turgor
