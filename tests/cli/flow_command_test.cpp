// turgor flow, as a user meets it.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
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

const std::string balloon = shipped("orifice-30mm.toml");
const std::string at = "stretch=1.1,rate=-0.1 1/s,time=2.5 s";

json flow_json(const Folder& folder, std::vector<std::string> arguments, const std::string& file = balloon) {
  arguments.insert(arguments.begin(), {"flow", file, "--json", "--no-pictures", "--force", "--resolution", "20"});
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json::parse(result.out);
}

TEST(FlowCommand, WritesItsDirectory) {
  const Folder folder;
  const auto result = turgor(folder, {"flow", balloon, "--at", at});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("36000 Pa  (2.3)"), std::string::npos) << result.out;
  const fs::path directory = folder / "orifice-30mm.flow";
  EXPECT_EQ(contents(directory / "case.toml"), contents(balloon));
  for (const char* file : {"flow.vtu", "wall.csv", "flow.json", "flow.gp"}) {
    EXPECT_GT(fs::file_size(directory / file), 0U) << file;
  }
  EXPECT_NE(contents(directory / "flow.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(contents(directory / "flow.png").substr(1, 3), "PNG");
  for (const auto& entry : fs::directory_iterator(directory)) {
    EXPECT_NE(entry.path().extension(), ".part");
    EXPECT_NE(entry.path().extension(), ".log");
  }
  EXPECT_EQ(turgor(folder, {"flow", balloon, "--at", at}).code, 2);
  EXPECT_EQ(turgor(folder, {"flow", balloon, "--at", at, "--force", "--no-pictures", "-q"}).out, "");
  EXPECT_FALSE(fs::exists(directory / "flow.png"));
}

// The pressures of wall.csv integrated over the wall against the force by g1...g5, with a channel and a profile.
TEST(FlowCommand, PressuresOfTheWallAddUpToTheForce) {
  for (const char* name : {"orifice-30mm.toml", "channel-30mm.toml"}) {
    const Folder folder;
    const json document =
        flow_json(folder, {"--at", at, "-o", "out", "--profile", shipped("profile-orifice.csv")}, shipped(name));
    EXPECT_FALSE(document.at("profile").at("uniform").get<bool>());
    std::istringstream stream(contents(folder / "out" / "wall.csv"));
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, "theta [rad],s [m],r [m],z [m],p_gauge [Pa],velocity [m/s]");
    double force = 0;
    std::vector<double> last;
    while (std::getline(stream, line)) {
      std::vector<double> row;
      std::istringstream fields(line);
      for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
      ASSERT_EQ(row.size(), 6U);
      if (!last.empty()) {
        EXPECT_LT(row[1], last[1]);
        force += std::numbers::pi * (row[2] * row[4] + last[2] * last[4]) * (last[1] - row[1]);
      }
      last = row;
    }
    const double expected = document.at("force_N").at("exact");
    EXPECT_NEAR(force, expected, 1e-4 * std::abs(expected)) << name;  // trapezoids over 500 points
  }
}

// (2.23) written out.
TEST(FlowCommand, AccelerationIsThatOfTheEquationOfMotion) {
  const Folder folder;
  const json state = flow_json(folder, {"--at", at}).at("state");
  EXPECT_EQ(state.at("acceleration_from"), "orifice");
  EXPECT_EQ(state.at("closure"), "corrected");
  const double R = 1.1;
  const double K = 0.03 / (2 * 1000 * std::pow(0.3, 3));
  const double elastic =
      4 * 0.003 / 0.3 * (1.5e6 * (R - std::pow(R, -5)) + 0.15e6 * (std::pow(R, 3) - std::pow(R, -3)));
  const double force = K * (R * R * 36000 - elastic) + 75 / (4 * std::numbers::pi) * 1000 * std::pow(R, 6) * 0.01;
  const double expected = force / (223 / (32 * std::numbers::pi) * std::pow(R, 4));
  EXPECT_NEAR(state.at("d2Rdt2_1_per_s2").get<double>(), expected, 1e-10 * std::abs(expected));
  EXPECT_EQ(flow_json(folder, {"--at", at + ",acceleration=-2"}).at("state").at("acceleration_from"), "given");
  EXPECT_EQ(flow_json(folder, {"--at", at, "--set", "model.name=auto"}).at("state").at("acceleration_from"), "full");
}

TEST(FlowCommand, ReadsItsWords) {
  const Folder folder;
  const json plain = flow_json(folder, {"--at", "stretch=1.1,rate=-0.1,acceleration=-3/2,pressure=20 kPa"});
  EXPECT_EQ(plain.at("state").at("p_gauge_Pa"), 20000);
  EXPECT_EQ(plain.at("state").at("d2Rdt2_1_per_s2"), -1.5);
  EXPECT_EQ(
      flow_json(folder,
                {"--at", " acceleration = \"-1500 1/s/ks\" , pressure=\"0.2 bar\", rate=\"-6 1/min\", stretch=1.1"}),
      plain);
  EXPECT_EQ(flow_json(folder, {"--at", "stretch=1.1,rate=-0.1"}).at("state").at("p_gauge_Pa"), 0);  // at t = 0
  // the volume flux by hand, (2.1)
  const double eps = 1 - std::sqrt(1 - 1 / 121.0);
  const double velocity = (2 - eps) / (eps * (1 - eps)) * 0.3 * -0.1;
  EXPECT_NEAR(plain.at("orifice").at("velocity_m_per_s").get<double>(), velocity, 1e-12 * std::abs(velocity));
  EXPECT_NEAR(plain.at("orifice").at("reynolds").get<double>(), 1000 * std::abs(velocity) * 0.06 / 8.94e-4, 1e-3);
}

// As a user reads it: with another program's reader.
TEST(FlowCommand, TheGridIsReadByMeshio) {
  const Folder folder;
  ASSERT_EQ(turgor(folder, {"flow", balloon, "--at", at, "-o", "out", "--no-pictures", "-q"}).code, 0);
  test::write(folder / "read.py", R"(
import json
import meshio
import numpy as np
grid = meshio.read("out/flow.vtu")
flow = json.load(open("out/flow.json"))
x, data = grid.points, grid.point_data
quads = grid.cells_dict["quad"]
assert x.shape == (201 * 201, 3) and quads.shape == (200 * 200, 4)
assert flow["mesh"] == {"cells": 200, "nodes": 201 * 201}
for values in data.values():
    assert np.isfinite(values).all()
r, rate = 0.33, -0.03
eps = flow["epsilon"]
c = x[quads]
area = ((c[:, 2, 0] - c[:, 0, 0]) * (c[:, 3, 1] - c[:, 1, 1]) - (c[:, 3, 0] - c[:, 1, 0]) * (c[:, 2, 1] - c[:, 0, 1])) / 2
assert (area > 0).all()
cap = np.arccos(1 - eps)
half_disc = r**2 / 2 * (np.pi - cap + np.sin(cap) * np.cos(cap))
assert abs(area.sum() / half_disc - 1) < 3e-4  # chords for arcs, up to 2 degrees long
assert np.hypot(x[:, 0] - 0.03, x[:, 1]).min() > 0.99 * 0.001 * 0.03
# in the middle of the orifice's plane the pressure is that of (2.3)
middle = np.argmin(np.hypot(x[:, 0], x[:, 1]))
assert np.hypot(x[middle, 0], x[middle, 1]) == 0
assert abs(data["pressure"][middle] - flow["orifice"]["pressure_Pa"]) < 1e-4
# the wall moves with dr/dt along its normal, seen from the centre
wall = slice(0, 201)
height = x[wall, 1] - (1 - eps) * r
normal = (data["velocity_relative"][wall, 0] * x[wall, 0] + data["velocity_relative"][wall, 1] * height) / r
assert np.abs(normal - rate).max() < 2e-6 * 15  # 1e-10 of what is integrated, which reaches 15 m/s / 1e-3
assert np.allclose(data["velocity"][:, 1] - data["velocity_relative"][:, 1], rate / (1 - eps), rtol=1e-9, atol=1e-12)
assert (data["velocity"][:, 0] == data["velocity_relative"][:, 0]).all()
# velocity is the gradient of the potential and the curl of the stream function: along the edges of a coarse region
phi, psi, v = (data[name].reshape(201, 201, -1) for name in ("potential", "stream_function", "velocity"))
p = x.reshape(201, 201, 3)
for axis in (0, 1):
    d = np.diff(p[:, :120], axis=axis)[..., :2]
    a, b = (v[:-1, :120], v[1:, :120]) if axis == 0 else (v[:, :119], v[:, 1:120])
    mean = (a + b)[..., :2] / 2
    size = np.hypot(*np.moveaxis(mean, -1, 0)) * np.hypot(*np.moveaxis(d, -1, 0))
    along = (mean * d).sum(-1)
    assert (np.abs(np.diff(phi[:, :120, 0], axis=axis) - along) < 1e-2 * size).all()
    radius = (p[:-1, :120, 0] + p[1:, :120, 0]) / 2 if axis == 0 else (p[:, :119, 0] + p[:, 1:120, 0]) / 2
    across = radius * (mean[..., 1] * d[..., 0] - mean[..., 0] * d[..., 1])
    assert (np.abs(np.diff(psi[:, :120, 0], axis=axis) - across) < 1e-2 * radius * size + 1e-9).all()
print("ok")
)");
  const auto result = test::shell(folder, "/usr/bin/python3 read.py");
  EXPECT_EQ(result.out, "ok\n") << result.err;
}

struct Wrong {
  std::string name;
  std::string at;
  std::vector<std::string> says;
};

class WrongInstant : public testing::TestWithParam<Wrong> {};

TEST_P(WrongInstant, IsExplained) {
  const Folder folder;
  const auto result = turgor(folder, {"flow", balloon, "--at", GetParam().at, "-o", "out"});
  EXPECT_EQ(result.code, 2) << result.out;
  EXPECT_EQ(result.out, "");
  for (const auto& words : GetParam().says) {
    EXPECT_NE(result.err.find(words), std::string::npos) << "no \"" << words << "\" in:\n" << result.err;
  }
  EXPECT_FALSE(fs::exists(folder / "out"));
  const auto document = turgor(folder, {"flow", balloon, "--at", GetParam().at, "-o", "out", "--json"});
  EXPECT_EQ(document.code, 2);
  EXPECT_EQ(json::parse(document.out).at("status"), "bad-input");
}

const std::vector<Wrong> wrong_instants{
    {"Inflating",
     "stretch=1.1,rate=0.1,pressure=20 kPa",
     {"rate = 0.1 1/s", "jet", "no potential flow", "20000 Pa by (2.3)", "negative rate"}},
    {"AtRest", "stretch=1.1,rate=0,pressure=20 kPa", {"nothing flows", "20000 Pa by (2.3)"}},
    {"NoRate", "stretch=1.1", {"rate is missing", "stretch=1.1, rate=-0.1 1/s"}},
    {"NoStretch", "rate=-0.1", {"stretch is missing"}},
    {"Nothing", "", {"stretch is missing"}},
    {"UnknownWord", "stretch=1.1,rate=-0.1,presure=2 kPa", {"presure", "unknown word", "pressure"}},
    {"WordTwice", "stretch=1.1,rate=-0.1,stretch=1.2", {"stretch", "given twice"}},
    {"NoEquals", "stretch=1.1,-0.1", {"\"-0.1\"", "word=value"}},
    {"TrailingComma", "stretch=1.1,rate=-0.1, ", {"word=value"}},
    {"NotANumber", "stretch=nan,rate=-0.1", {"stretch = nan", "not a finite number"}},
    {"NanRate", "stretch=1.1,rate=nan", {"rate", "not a finite number"}},
    {"InfiniteRate", "stretch=1.1,rate=-inf", {"rate", "not a finite number"}},
    {"HugeRate", "stretch=1.1,rate=-1e300", {"rate = -1e+300", "too large"}},
    {"WrongUnit", "stretch=1.1,rate=-0.1 m", {"rate", "wrong dimension"}},
    {"StretchWithUnit", "stretch=1.1 m,rate=-0.1", {"stretch", "not a finite number"}},
    {"PressureWithoutUnit", "stretch=1.1,rate=-0.1,pressure=20", {"pressure", "missing unit", "kPa"}},
    {"TimeWithoutUnit", "stretch=1.1,rate=-0.1,time=2", {"time", "missing unit"}},
    {"NegativeTime", "stretch=1.1,rate=-0.1,time=-2 s", {"time", "out of range"}},
    {"TimeAndPressure", "stretch=1.1,rate=-0.1,time=2 s,pressure=2 kPa", {"one of time and pressure"}},
    {"SmallerThanItsOrifice", "stretch=0.1,rate=-0.1", {"stretch = 0.1", "not larger than its orifice", "0.1"}},
    {"NegativeStretch", "stretch=-1.1,rate=-0.1", {"stretch = -1.1", "not larger than its orifice"}},
    {"TooLarge", "stretch=1e9,rate=-0.1", {"stretch = 1e+09", "out of range", "100"}},
};
INSTANTIATE_TEST_SUITE_P(All, WrongInstant, testing::ValuesIn(wrong_instants),
                         [](const auto& test) { return test.param.name; });

TEST(FlowCommand, OtherMistakes) {
  const Folder folder;
  const auto message = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "flow");
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 2);
    return result.err;
  };
  EXPECT_NE(message({balloon}).find("--at"), std::string::npos);
  EXPECT_NE(message({"none.toml", "--at", at}).find("none.toml"), std::string::npos);
  EXPECT_NE(message({balloon, "--at", at, "--resolution", "5"}).find("--resolution"), std::string::npos);
  EXPECT_NE(message({balloon, "--at", at, "--profile", "none.csv"}).find("none.csv"), std::string::npos);
  test::write(folder / "file", "");
  EXPECT_NE(message({balloon, "--at", at, "-o", "file"}).find("is a file"), std::string::npos);
  const std::string dictated = shipped("motion-orifice-20mm.toml");
  EXPECT_NE(message({dictated, "--at", at}).find("dictates the radius"), std::string::npos);
  EXPECT_EQ(
      flow_json(folder, {"--at", at + ",acceleration=0", "-o", "out"}, dictated).at("state").at("d2Rdt2_1_per_s2"), 0);
  const auto locked = message({shipped("material-gent.toml"), "--at", "stretch=90,rate=-0.1"});
  EXPECT_NE(locked.find("material locks"), std::string::npos) << locked;
}

}  // namespace
}  // namespace turgor
