// turgor sweep, as a user meets it.

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::shell;
using test::turgor;

const std::string balloon = R"(title = "A sweep"
[balloon]
radius = "30 cm"
thickness = "3 mm"
density = "1000 kg/m^3"
[material]
model = "mooney-rivlin"
s1 = "1.5 MPa"
s2 = "0.15 MPa"
max_stretch = 1.3
[fluid]
density = "1000 kg/m^3"
viscosity = "8.94e-4 Pa s"
[inlet]
orifice_radius = "3 cm"
[pressure]
segments = [ { to = "30 kPa", over = "2 s", shape = "smooth" }, { hold = "2 s" } ]
[solve]
t_end = "4 s"
rtol = 1e-6
)";

/// Orifices up to larger than the balloon, pressures up to bursting it: every kind of member.
const std::string grid = R"([sweep]
event_times = 3
[sweep.axes]
"inlet.orifice_radius" = { from = "1 cm", to = "33 cm", n = 23, spacing = "log" }
"pressure.segments[0].to" = { from = "20 kPa", to = "45 kPa", n = 26 }
"model.name" = { values = ["orifice", "full"] }
)";
constexpr std::size_t grid_members = 23 * 26 * 2;

std::vector<double> variable(const fs::path& file, const std::string& name) {
  int id = 0;
  int variable = 0;
  int rank = 0;
  EXPECT_EQ(nc_open(file.c_str(), NC_NOWRITE, &id), NC_NOERR) << file;
  EXPECT_EQ(nc_inq_varid(id, name.c_str(), &variable), NC_NOERR) << name;
  nc_inq_varndims(id, variable, &rank);
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  nc_inq_vardimid(id, variable, dimensions.data());
  std::size_t size = 1;
  for (const int dimension : dimensions) {
    std::size_t length = 0;
    nc_inq_dimlen(id, dimension, &length);
    size *= length;
  }
  std::vector<double> values(size);
  EXPECT_EQ(nc_get_var_double(id, variable, values.data()), NC_NOERR);
  nc_close(id);
  return values;
}

/// A sweep into o.nc, and the bytes of what it leaves.
std::string swept(const Folder& folder, const std::string& options) {
  const auto result =
      shell(folder, std::string("'") + TURGOR_PROGRAM + "' sweep case.toml -o o.nc -q --no-pictures " + options);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_FALSE(fs::exists(folder / "o.nc.part"));
  return contents(folder / "o.nc");
}

TEST(Sweep, WritesOneFile) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const auto result = turgor(folder, {"sweep", "case.toml"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("1196 members"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("failed: inlet.orifice_radius: the orifice is larger than the balloon"), std::string::npos);
  EXPECT_NE(result.out.find("failed: the wall bursts"), std::string::npos);
  EXPECT_EQ(variable(folder / "case.nc", "inlet_orifice_radius").size(), 23U);
  EXPECT_EQ(variable(folder / "case.nc", "pressure_segments_0_to").back(), 45e3);
  EXPECT_EQ(variable(folder / "case.nc", "event_time").size(), 3 * grid_members);
  for (const char* ending : {".png", ".svg", ".gp"}) {
    EXPECT_TRUE(fs::exists(folder / (std::string("case-peak_stretch") + ending))) << ending;
  }
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos);
}

// A run takes its steps one balloon at a time, a sweep several balloons at once: the two agree within the tolerance,
// here a tight one. Times at which R is flat are ill-conditioned, and the Reynolds number is sampled at points of the
// steps.
TEST(Sweep, MembersAreWhatRunGives) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  (void)swept(folder, "--set solve.rtol=1e-11 --set solve.atol=1e-11");
  const auto radius = variable(folder / "o.nc", "inlet_orifice_radius");
  const auto pressure = variable(folder / "o.nc", "pressure_segments_0_to");
  for (const std::size_t member : {0U, 17U, 500U, 777U, 1051U, 1195U}) {
    const std::size_t r = member / 52;
    const std::size_t p = member / 2 % 26;
    const auto set = [](const std::string& key, double value, const std::string& unit) {
      return key + "=" + json(value).dump() + " " + unit;
    };
    const auto run = turgor(
        folder, {"run", "case.toml", "-o", "run", "--force", "--no-pictures", "--json", "--set", "solve.rtol=1e-11",
                 "--set", "solve.atol=1e-11", "--set", set("inlet.orifice_radius", radius[r], "m"), "--set",
                 set("pressure.segments[0].to", pressure[p], "Pa"), "--set",
                 std::string("model.name=") + (member % 2 == 0 ? "orifice" : "full")});
    const auto document = json::parse(run.out);
    const double outcome = variable(folder / "o.nc", "outcome")[member];
    if (document.at("status") == "bad-input") {
      EXPECT_EQ(outcome, -1) << member;
      EXPECT_TRUE(std::isnan(variable(folder / "o.nc", "peak_stretch")[member]));
      continue;
    }
    EXPECT_EQ(outcome, document.at("outcome") == "burst" ? 3 : 0) << member;
    for (const auto& [name, value] : document.at("quantities").items()) {
      const double stored = variable(folder / "o.nc", name)[member];
      if (name == "peak_time") continue;
      if (value.is_null()) {
        EXPECT_TRUE(std::isnan(stored)) << name;
      } else {
        const double expected = value.get<double>();
        const double share = name.ends_with("_time") ? 1e-4 : 2e-6;
        EXPECT_NEAR(stored, expected, share * std::max(1.0, std::abs(expected))) << name << " of member " << member;
      }
    }
  }
}

TEST(Sweep, IsTheSameForAnyNumberOfThreadsAndRanks) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const std::string one = swept(folder, "--threads 1");
  EXPECT_TRUE(one == swept(folder, "--force --threads 2"));
  EXPECT_TRUE(one == swept(folder, "--force --threads 5"));
  for (const char* ranks :
       {"2", "3"}) {  // OpenMPI keeps memory of its own to the end, which a leak checker would report
    const auto result = shell(
        folder,
        std::string("LSAN_OPTIONS=detect_leaks=0 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
                    "--oversubscribe -n ") +
            ranks + " '" + TURGOR_PROGRAM + "' sweep case.toml -o o.nc -q --no-pictures --force");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(one == contents(folder / "o.nc"));
  }
}

TEST(Sweep, SamplesAreTheSameForAnyNumberOfThreads) {
  for (const char* sampler : {"latin-hypercube", "sobol"}) {
    const Folder folder;
    test::write(folder / "case.toml", balloon + "[sweep]\nsampler = \"" + sampler + R"("
members = 700
seed = 3
quantities = ["final_stretch"]
[sweep.axes]
"material.s1" = { normal = ["1.5 MPa", "0.1 MPa"] }
"inlet.orifice_radius" = { from = "1 cm", to = "3 cm", spacing = "log" }
"balloon.thickness" = { lognormal = ["3 mm", 0.1] }
)");
    const std::string one = swept(folder, "--threads 1");
    EXPECT_TRUE(one == swept(folder, "--threads 2 --force"));
    EXPECT_EQ(variable(folder / "o.nc", "material_s1").size(), 700U);
  }
}

/// Starts a command, waits until its journal exists and for some seconds more, and sends it a signal.
test::Finished signalled(const Folder& folder, const std::string& command, const std::string& signal,
                         const std::string& seconds) {
  return shell(folder, "bash -c \"" + command +
                           " & p=\\$!; while kill -0 \\$p && [ ! -s o.nc.part ]; do sleep 0.005; done; sleep " +
                           seconds + "; kill -s " + signal + " \\$p; wait \\$p\"");
}

const std::string sweep_case =
    std::string("'") + TURGOR_PROGRAM + "' sweep case.toml -o o.nc --no-pictures --threads 1";

TEST(Sweep, AKilledOneGoesOnToTheSameBits) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const std::string whole = swept(folder, "--threads 1");
  int killed = 0;
  for (const char* moment : {"0", "0.02", "0.04", "0.07", "0.1"}) {
    fs::remove(folder / "o.nc");
    (void)signalled(folder, sweep_case, "KILL", moment);
    if (!fs::exists(folder / "o.nc.part")) continue;  // it was done already
    ++killed;
    (void)signalled(folder, sweep_case + " --resume", "KILL", "0.02");  // and once more
    if (fs::exists(folder / "o.nc.part")) {
      EXPECT_EQ(shell(folder, sweep_case + " --resume").code, 0);
    }
    EXPECT_TRUE(whole == contents(folder / "o.nc")) << moment;
  }
  EXPECT_GT(killed, 0) << "no moment was right";
}

const std::string slow = " --set solve.rtol=1e-12";

TEST(Sweep, AnInterruptedOneKeepsWhatItHas) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const auto result = signalled(folder, sweep_case + slow, "INT", "0.1");
  EXPECT_EQ(result.code, 130) << result.err;
  EXPECT_NE(result.err.find("members are kept in o.nc.part; go on with --resume"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(folder / "o.nc"));
  const auto resumed = shell(folder, sweep_case + slow + " --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_NE(resumed.out.find("of them now"), std::string::npos) << resumed.out;
}

TEST(Sweep, AFullDiskLosesNothing) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const std::string whole = swept(folder, "");
  fs::remove(folder / "o.nc");
  for (const char* kilobytes : {"100", "150"}) {
    const std::string resume = fs::exists(folder / "o.nc.part") ? " --resume" : "";
    const auto result =
        shell(folder, std::string("bash -c \"ulimit -f ") + kilobytes + "; " + sweep_case + resume + "\"");
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("is the disk full?"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("--resume"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "o.nc"));
    EXPECT_TRUE(fs::exists(folder / "o.nc.part"));
  }
  EXPECT_TRUE(whole == swept(folder, "--resume"));
}

TEST(Sweep, AResultThatCannotBeWrittenKeepsEveryMember) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const std::string whole = swept(folder, "");
  fs::remove(folder / "o.nc");
  fs::create_directories(folder / "o.nc.new" / "in-the-way");
  const auto result = shell(folder, sweep_case);
  EXPECT_EQ(result.code, 4);
  EXPECT_NE(result.err.find("cannot write o.nc.new"), std::string::npos) << result.err;
  fs::remove_all(folder / "o.nc.new");
  EXPECT_TRUE(whole == swept(folder, "--resume"));
}

TEST(Sweep, RefusesToOverwriteOrToMixSweeps) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const auto message = [&](const std::vector<std::string>& options, int code = 2) {
    std::vector<std::string> arguments{"sweep", "case.toml", "--no-pictures", "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, code) << result.err;
    return result.err;
  };
  EXPECT_NE(message({"-o", "o.nc", "--resume"}).find("there is nothing to resume"), std::string::npos);
  (void)swept(folder, "");
  EXPECT_NE(message({"-o", "o.nc"}).find("exists already"), std::string::npos);
  EXPECT_NE(message({"-o", "o.nc", "--resume"}).find("is complete"), std::string::npos);
  EXPECT_NE(message({"-o", "none/o.nc"}).find("the folder none does not exist"), std::string::npos);
  EXPECT_NE(message({"-o", "/proc/o.nc"}).find("/proc/o.nc"), std::string::npos);
  EXPECT_NE(message({"-o", "."}).find("is a folder"), std::string::npos);
  EXPECT_NE(message({"-o", "o.nc", "--threads", "0"}).find("--threads"), std::string::npos);

  fs::remove(folder / "o.nc");
  (void)signalled(folder, sweep_case + slow, "INT", "0");
  ASSERT_TRUE(fs::exists(folder / "o.nc.part"));
  EXPECT_NE(message({"-o", "o.nc"}).find("an unfinished sweep has left o.nc.part"), std::string::npos);
  const std::string other = message({"-o", "o.nc", "--resume", "--set", "solve.rtol=1e-5"});
  EXPECT_NE(other.find("it has \"rtol = 1e-12\", now there is \"rtol = 1e-05\""), std::string::npos) << other;
}

TEST(Sweep, PythonReadsIt) {
  const Folder folder;
  if (shell(folder, "/usr/bin/python3 -c 'import xarray, netCDF4'").code != 0) {
    GTEST_SKIP() << "python3-xarray and python3-netcdf4 are not installed (section [test] of packages.txt)";
  }
  test::write(folder / "case.toml", balloon + grid);
  (void)swept(folder, "");
  test::write(folder / "read.py", R"(
import xarray
data = xarray.open_dataset("o.nc")
assert data.peak_stretch.dims == ("inlet_orifice_radius", "pressure_segments_0_to", "model_name")
point = data.sel(pressure_segments_0_to=30e3, model_name="full").sel(inlet_orifice_radius=0.02, method="nearest")
assert 1.0 < float(point.peak_stretch) < 1.3
assert data.peak_stretch.where(data.outcome == -1).isnull().all()
failed = data.failure.values[data.outcome.values == -1]
assert set(data.failure_message.values[failed.astype(int)]) == {"inlet.orifice_radius: the orifice is larger than the balloon"}
assert data.attrs["status"] == "complete" and data.event_time.units == "s"
assert data.attrs["case"] == open("case.toml").read()
)");
  const auto result = shell(folder, "/usr/bin/python3 read.py");
  EXPECT_EQ(result.code, 0) << result.err;
}

TEST(Sweep, JsonIsOneDocument) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  const auto document = json::parse(turgor(folder, {"sweep", "case.toml", "--json", "--no-pictures"}).out);
  EXPECT_EQ(document.at("status"), "complete");
  EXPECT_EQ(document.at("members"), grid_members);
  EXPECT_EQ(document.at("quantities").at("peak_stretch").at("unit"), "1");
}

TEST(Sweep, OtherCommandsLeaveTheAxesAlone) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + grid);
  EXPECT_EQ(turgor(folder, {"run", "case.toml", "-q", "--no-pictures"}).code, 0);
  EXPECT_EQ(turgor(folder, {"info", "case.toml"}).code, 0);
  EXPECT_NE(turgor(folder, {"doc", "sweep"}).out.find("sweep.axes"), std::string::npos);
}

TEST(Sweep, ADictatedMotionIsForAnotherCommand) {
  const Folder folder;
  const auto result = turgor(folder, {"sweep", (fs::path(TURGOR_CASES) / "motion-orifice-30mm.toml").string()});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("`turgor force`"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(folder / "motion-orifice-30mm.nc"));
}

TEST(Sweep, ACaseWithoutASweepIsSaidSo) {
  const Folder folder;
  test::write(folder / "case.toml", balloon);
  const auto result = turgor(folder, {"sweep", "case.toml"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("the case has no [sweep] table"), std::string::npos) << result.err;
}

/// A [sweep] table with a mistake, and what the message must say.
struct BadSweep {
  std::string name;
  std::string table;
  std::vector<std::string> says;
};

class BadSweepTable : public testing::TestWithParam<BadSweep> {};

TEST_P(BadSweepTable, IsExplained) {
  const Folder folder;
  test::write(folder / "case.toml", balloon + "[sweep]\n" + GetParam().table);
  for (const char* command : {"validate", "sweep", "run"}) {
    const auto result = turgor(folder, {command, "case.toml"});
    EXPECT_EQ(result.code, 2) << result.out;
    for (const auto& words : GetParam().says)
      EXPECT_NE(result.err.find(words), std::string::npos) << "no \"" << words << "\" in:\n" << result.err;
    EXPECT_NE(result.err.find("case.toml:"), std::string::npos) << result.err;
  }
  EXPECT_FALSE(fs::exists(folder / "case.nc"));
}

const std::string sampled = "sampler = \"sobol\"\nmembers = 10\n";
const std::vector<BadSweep> bad_sweeps{
    {"NoAxes", "", {"sweep.axes: no axes"}},
    {"UnknownSampler", "sampler = \"sobel\"\n", {"sweep.sampler = \"sobel\"", "\"sobol\""}},
    {"UnknownKeyOfTheTable", "sampel = 1\n", {"sweep.sampel", "unknown key", "did you mean sweep.sampler"}},
    {"UnknownQuantity", "quantities = [\"peak\"]\n", {"sweep.quantities[0] = \"peak\"", "peak_stretch"}},
    {"EmptyQuantities", "quantities = []\n", {"sweep.quantities", "is empty"}},
    {"UnknownAxis",
     "axes = { \"inlet.orifice_radios\" = { from = \"1 cm\", to = \"2 cm\", n = 3 } }\n",
     {"no such key", "did you mean \"inlet.orifice_radius\"?"}},
    {"UnquotedAxis",
     "axes.inlet.orifice_radius = { from = \"1 cm\", to = \"2 cm\", n = 3 }\n",
     {"write the whole key in quotes"}},
    {"UnsweepableTitle", "axes = { \"title\" = { values = [\"a\"] } }\n", {"cannot be swept"}},
    {"UnsweepableOutput", "axes = { \"output.time_unit\" = { values = [\"s\"] } }\n", {"cannot be swept"}},
    {"UnsweepableSweep", "axes = { \"sweep.seed\" = { values = [1] } }\n", {"cannot be swept"}},
    {"UnsweepableTable", "axes = { \"pressure.segments\" = { values = [1] } }\n", {"cannot be swept"}},
    {"NoSuchSegment",
     "axes = { \"pressure.segments[7].to\" = { values = [\"1 Pa\"] } }\n",
     {"segments has no element [7]"}},
    {"AxisTwice",
     "axes = { \"pressure.segments[0].to\" = { values = [\"1 Pa\"] }, \"pressure.segments[00].to\" = { values = "
     "[\"2 Pa\"] } }\n",
     {"the same axis twice"}},
    {"ZeroCount",
     "axes = { \"inlet.orifice_radius\" = { from = \"1 cm\", to = \"2 cm\", n = 0 } }\n",
     {"n = 0", "out of range", "from 1"}},
    {"MissingCount", "axes = { \"inlet.orifice_radius\" = { from = \"1 cm\", to = \"2 cm\" } }\n", {".n: missing"}},
    {"MissingTo", "axes = { \"inlet.orifice_radius\" = { from = \"1 cm\", n = 3 } }\n", {".to: missing"}},
    {"MissingFrom", "axes = { \"inlet.orifice_radius\" = { to = \"1 cm\", n = 3 } }\n", {".from: missing"}},
    {"LogFromZero",
     "axes = { \"inlet.channel_length\" = { from = \"0 cm\", to = \"1 cm\", n = 3, spacing = \"log\" } }\n",
     {"must be > 0 with spacing = \"log\""}},
    {"UnknownSpacing",
     "axes = { \"inlet.orifice_radius\" = { from = \"1 cm\", to = \"2 cm\", n = 3, spacing = \"lin\" } }\n",
     {"spacing = \"lin\"", "\"linear\", \"log\""}},
    {"WrongUnit",
     "axes = { \"inlet.orifice_radius\" = { from = \"1 kPa\", to = \"2 cm\", n = 3 } }\n",
     {"\"kPa\" has the wrong dimension"}},
    {"OutOfRange",
     "axes = { \"inlet.orifice_radius\" = { from = \"-1 cm\", to = \"2 cm\", n = 3 } }\n",
     {".from = \"-1 cm\"", "out of range", "> 0 m"}},
    {"NotFinite", "axes = { \"initial.stretch\" = { values = [1.0, nan] } }\n", {"not a finite number"}},
    {"UnknownWord", "axes = { \"model.name\" = { values = [\"fool\"] } }\n", {"unknown name", "\"full\""}},
    {"EmptyValues", "axes = { \"model.name\" = { values = [] } }\n", {"is empty"}},
    {"RangeOfWords", "axes = { \"model.name\" = { from = 1, to = 2, n = 2 } }\n", {"takes words"}},
    {"FractionalInteger", "axes = { \"solve.max_events\" = { values = [1.5] } }\n", {"not an integer"}},
    {"TwoForms",
     "axes = { \"initial.stretch\" = { values = [1.0], from = 1.0, to = 2.0, n = 2 } }\n",
     {"says more than one thing"}},
    {"NoForm", "axes = { \"initial.stretch\" = { } }\n", {"has no values"}},
    {"UnknownForm", "axes = { \"initial.stretch\" = { gamma = [1, 2] } }\n", {".gamma", "unknown key"}},
    {"TooManyMembers",
     "axes = { \"initial.stretch\" = { from = 1.0, to = 2.0, n = 1000000 }, \"inlet.orifice_radius\" = { from = "
     "\"1 cm\", to = \"2 cm\", n = 1000000 } }\n",
     {"this grid has 1e+12 members", "1e+09"}},
    {"DistributionInAGrid",
     "axes = { \"initial.stretch\" = { normal = [1.0, 0.1] } }\n",
     {"a distribution is for samplers other than grid"}},
    {"MembersInAGrid",
     "members = 5\naxes = { \"initial.stretch\" = { values = [1.0] } }\n",
     {"sweep.members", "goes with samplers other than grid"}},
    {"NoMembers",
     "sampler = \"sobol\"\naxes = { \"initial.stretch\" = { uniform = [1.0, 2.0] } }\n",
     {"sweep.members: missing"}},
    {"ZeroMembers",
     "sampler = \"sobol\"\nmembers = 0\naxes = { \"initial.stretch\" = { uniform = [1.0, 2.0] } }\n",
     {"sweep.members = 0", "from 1 to 1e+09"}},
    {"AbsurdMembers",
     "sampler = \"sobol\"\nmembers = 1000000000000\naxes = { \"initial.stretch\" = { uniform = [1.0, 2.0] } }\n",
     {"sweep.members = 1000000000000", "from 1 to 1e+09"}},
    {"ListWhenSampled",
     sampled + "axes = { \"initial.stretch\" = { values = [1.0] } }\n",
     {"a list of values is for grids"}},
    {"CountWhenSampled",
     sampled + "axes = { \"initial.stretch\" = { from = 1.0, to = 2.0, n = 5 } }\n",
     {"goes with sampler = \"grid\""}},
    {"UnknownDistribution",
     sampled + "axes = { \"initial.stretch\" = { gauss = [1.0, 2.0] } }\n",
     {".gauss", "unknown key", "normal"}},
    {"NegativeSigma",
     sampled + "axes = { \"material.s1\" = { normal = [\"1 MPa\", \"-1 kPa\"] } }\n",
     {"normal[1] = \"-1 kPa\"", "> 0 Pa"}},
    {"LognormalOfANegativeMedian",
     sampled + "axes = { \"material.s1\" = { lognormal = [\"-1 MPa\", 0.1] } }\n",
     {"lognormal[0]", "> 0 Pa"}},
    {"OneParameter", sampled + "axes = { \"material.s1\" = { normal = [\"1 MPa\"] } }\n", {"has 1 elements, not 2"}},
    {"SampledWord", sampled + "axes = { \"model.name\" = { uniform = [1, 2] } }\n", {"takes words", "in a grid"}},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, BadSweepTable, testing::ValuesIn(bad_sweeps),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace turgor
