// Every mistake a person can make in a case file or on the command line gets one clear message and exit code 2.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor {
namespace {

using test::Folder;
using test::turgor;

const std::string good_case = R"(title = "A good case"
[balloon]
radius = "30 cm"
thickness = "3 mm"
density = "1000 kg/m^3"
[material]
model = "mooney-rivlin"
s1 = "1.5 MPa"
s2 = "0.15 MPa"
[fluid]
density = "1000 kg/m^3"
viscosity = "8.94e-4 Pa s"
[inlet]
orifice_radius = "3 cm"
channel_length = "0 cm"
[pressure]
segments = [ { to = "36 kPa", over = "2 s", shape = "smooth" }, { hold = "2 s" } ]
[initial]
stretch = 1.0
[model]
name = "orifice"
[solve]
t_end = "6 s"
samples = 20
)";

/// One mistake: the text that replaces part of the good case, and what the message must say.
struct Mistake {
  std::string name;
  std::string from;
  std::string to;
  std::vector<std::string> says;
};

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = good_case;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "the good case no longer holds: " << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// The lines from one text up to the next, which is kept.
std::string without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  text.erase(at, text.find(to) - at);
  return text;
}

/// The same balloon on a dictated radius.
std::string dictated(const std::string& motion) {
  return without(good_case, "[pressure]", "[model]") + "[motion]\n" + motion;
}

class BadCase : public testing::TestWithParam<Mistake> {};

TEST_P(BadCase, IsExplained) {
  const Mistake& mistake = GetParam();
  const Folder folder;
  const std::string text = replaced(mistake.from, mistake.to);
  test::write(folder / "case.toml", text);
  const auto validated = turgor(folder, {"validate", "case.toml"});
  EXPECT_EQ(validated.code, 2) << validated.out << validated.err;
  EXPECT_EQ(validated.out, "");
  for (const auto& words : mistake.says)
    EXPECT_NE(validated.err.find(words), std::string::npos) << "no \"" << words << "\" in:\n" << validated.err;
  EXPECT_NE(validated.err.find("case.toml"), std::string::npos) << validated.err;

  const auto run = turgor(folder, {"run", "case.toml", "-o", "result"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err, validated.err);
  EXPECT_FALSE(std::filesystem::exists(folder / "result"));

  const auto json = turgor(folder, {"run", "case.toml", "-o", "result", "--json"});
  EXPECT_EQ(json.code, 2);
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_EQ(document.at("status"), "bad-input");
  EXPECT_FALSE(document.at("issues").empty());
}

const std::vector<Mistake> mistakes{
    {"UnknownKey",
     "orifice_radius =",
     "orifice_radios =",
     {"case.toml:14", "orifice_radios", "unknown key", "did you mean inlet.orifice_radius",
      "inlet.orifice_radius: missing"}},
    {"UnknownTable", "[fluid]", "[liquid]", {"liquid: unknown key", "did you mean fluid", "fluid.density: missing"}},
    {"UnknownTopLevelKey", "title =", "titel =", {"case.toml:1", "titel", "did you mean title"}},
    {"MissingKey", "thickness = \"3 mm\"\n", "", {"balloon.thickness: missing", "wall thickness"}},
    {"MissingUnit", "\"30 cm\"", "\"30\"", {"case.toml:3", "balloon.radius = \"30\"", "missing unit", "cm"}},
    {"NumberInsteadOfQuantity", "\"30 cm\"", "0.3", {"case.toml:3", "balloon.radius = 0.3", "missing unit"}},
    {"QuantityInsteadOfNumber", "stretch = 1.0", "stretch = \"1 m\"", {"case.toml:19", "not a plain number"}},
    {"NoNumber", "\"30 cm\"", "\"cm\"", {"does not start with a number"}},
    {"EmptyString", "\"30 cm\"", "\"\"", {"does not start with a number"}},
    {"WrongDimension", "\"30 cm\"", "\"30 kPa\"", {"case.toml:3", "\"kPa\" has the wrong dimension", "cm"}},
    {"ReciprocalDimension", "t_end = \"6 s\"", "t_end = \"6 Hz\"", {"case.toml:23", "\"Hz\" has the wrong dimension"}},
    {"UnknownUnit", "\"30 cm\"", "\"30 cmm\"", {"case.toml:3", "unknown unit \"cmm\""}},
    {"OffsetUnit", "\"30 cm\"", "\"30 degC\"", {"wrong dimension"}},
    {"NegativeSize", "\"30 cm\"", "\"-30 cm\"", {"case.toml:3", "out of range", "> 0 m"}},
    {"ZeroSize", "\"3 mm\"", "\"0 mm\"", {"balloon.thickness", "out of range", "> 0 m"}},
    {"ZeroOrifice", "\"3 cm\"", "\"0 cm\"", {"inlet.orifice_radius", "> 0 m"}},
    {"NegativeChannel", "channel_length = \"0 cm\"", "channel_length = \"-1 cm\"", {"inlet.channel_length", ">= 0 m"}},
    {"OrificeLargerThanBalloon", "\"3 cm\"", "\"31 cm\"", {"case.toml:14", "larger than the balloon", "0.3 m"}},
    {"WallThickerThanBalloon", "\"3 mm\"", "\"30 cm\"", {"as thick as the balloon"}},
    {"CompressedBelowOrifice", "stretch = 1.0", "stretch = 0.05", {"less than its orifice"}},
    {"UnknownChannelWall",
     "channel_length",
     "wall = \"slippery\"\nchannel_length",
     {"inlet.wall", "unknown name", "slip"}},
    {"NegativePenalty",
     "channel_length",
     "inflow_penalty = -0.5\nchannel_length",
     {"inlet.inflow_penalty", "out of range", ">= 0"}},
    {"NegativeDamping",
     "[model]",
     "[wall]\ndamping_time = \"-1 ms\"\n[model]",
     {"wall.damping_time", "out of range", ">= 0 s"}},
    {"DampingWithoutUnit", "[model]", "[wall]\ndamping_time = 0.01\n[model]", {"wall.damping_time", "missing unit"}},
    {"NegativeBendingStiffness",
     "[model]",
     "[wall]\nbending_stiffness = \"-1 N m\"\n[model]",
     {"wall.bending_stiffness", "out of range", ">= 0 N m"}},
    {"UnknownBendingStiffness",
     "[model]",
     "[wall]\nbending_stiffness = \"stiff\"\n[model]",
     {"wall.bending_stiffness", "does not start with a number", "or \"auto\""}},
    {"BendingStiffnessOfAnotherDimension",
     "[model]",
     "[wall]\nbending_stiffness = \"1 MPa\"\n[model]",
     {"wall.bending_stiffness", "wrong dimension"}},
    {"UnknownRim", "[model]", "[wall]\nrim = \"glued\"\n[model]", {"wall.rim", "unknown name", "clamped"}},
    {"TwoStepSizes",
     "[model]",
     "[fem]\ncfl = 0.5\ntime_step = \"10 ms\"\n[model]",
     {"fem.time_step", "given together with fem.cfl", "give one of them"}},
    {"ZeroCfl", "[model]", "[fem]\ncfl = 0.0\n[model]", {"fem.cfl", "out of range", "> 0"}},
    {"ErrorControlOfAFixedStep",
     "[model]",
     "[fem]\nerror_tolerance = 1e-3\ntime_step = \"10 ms\"\n[model]",
     {"fem.error_tolerance", "fixed fem.time_step", "fem.cfl in place"}},
    {"CoarseRim",
     "[model]",
     "[fem]\nh_rim = \"3 mm\"\n[model]",
     {"fem.h_rim", "out of range", "fem.h_orifice = 0.002 m"}},
    {"CoarseOrifice",
     "[model]",
     "[fem]\nh_orifice = \"1.6 cm\"\nh_wall = \"2 cm\"\n[model]",
     {"fem.h_orifice", "a third of inlet.orifice_radius = 0.01 m"}},
    {"CoarseWall", "[model]", "[fem]\nh_wall = \"16 cm\"\n[model]", {"fem.h_wall", "half of balloon.radius = 0.15 m"}},
    {"FieldsTwice",
     "[model]",
     "[fem]\nfields = 3\nfield_times = [\"1 s\"]\n[model]",
     {"fem.field_times", "given together with fem.fields"}},
    {"FieldsInDisorder",
     "[model]",
     "[fem]\nfield_times = [\"2 s\", \"1 s\"]\n[model]",
     {"field_times[1]", "must increase"}},
    {"FieldsAfterTheEnd",
     "[model]",
     "[fem]\nfield_times = [\"9 s\"]\n[model]",
     {"field_times[0]", "the run ends at 6 s"}},
    {"SweptMesh",
     "[model]",
     "[sweep.axes]\n\"fem.cfl\" = { from = 0.1, to = 1.0, n = 3 }\n[model]",
     {"fem.cfl", "cannot be swept"}},
    {"SweptWall",
     "[model]",
     "[sweep.axes]\n\"wall.damping_time\" = { from = \"1 ms\", to = \"9 ms\", n = 3 }\n[model]",
     {"wall.damping_time", "cannot be swept"}},
    {"NotANumber", "stretch = 1.0", "stretch = nan", {"case.toml:19", "initial.stretch", "not a finite number"}},
    {"Infinite", "\"30 cm\"", "\"inf cm\"", {"not a finite number"}},
    {"NanQuantity", "\"30 cm\"", "\"nan cm\"", {"not a finite number"}},
    {"Overflow", "\"30 cm\"", "\"1e999 cm\"", {"not a finite number"}},
    {"ZeroStretch", "stretch = 1.0", "stretch = 0", {"initial.stretch", "out of range"}},
    {"UnknownWordForStretch", "stretch = 1.0", "stretch = \"equlibrium\"", {"equilibrium"}},
    {"NoStableEquilibrium",
     "[pressure]\nsegments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } "
     "]\n[initial]\nstretch = 1.0",
     "[pressure]\nconstant = \"-1e30 Pa\"\n[initial]\nstretch = \"equilibrium\"",
     {"no stable equilibrium"}},
    {"EmptySegments",
     "[ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "[]",
     {"pressure.segments", "is empty"}},
    {"SegmentWithoutKind",
     "{ hold = \"2 s\" }",
     "{ over = \"2 s\" }",
     {"pressure.segments[1]", "says neither hold, step nor to"}},
    {"SegmentWithTwoKinds",
     "{ hold = \"2 s\" }",
     "{ hold = \"2 s\", step = \"1 Pa\" }",
     {"more than one of hold, step and to"}},
    {"SegmentWithoutDuration", "over = \"2 s\", ", "", {"says to but not over"}},
    {"SegmentWithZeroDuration", "{ hold = \"2 s\" }", "{ hold = \"0 s\" }", {"pressure.segments[1].hold", "> 0 s"}},
    {"UnknownShape", "\"smooth\"", "\"smoth\"", {"unknown name", "\"linear\", \"smooth\""}},
    {"UnknownSegmentKey",
     "{ hold = \"2 s\" }",
     "{ hold = \"2 s\", shpe = \"linear\" }",
     {"shpe", "did you mean pressure.segments[].shape"}},
    {"SegmentsNoList",
     "[ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "\"36 kPa\"",
     {"not a list of tables"}},
    {"SegmentNoTable", "{ hold = \"2 s\" }", "\"2 s\"", {"pressure.segments[1]", "not a table"}},
    {"TwoPrograms",
     "[pressure]\n",
     "[pressure]\nconstant = \"1 kPa\"\n",
     {"more than one pressure program", "constant and segments"}},
    {"NoProgram",
     "segments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "",
     {"no pressure program"}},
    {"EmptyTable",
     "segments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "table = { t = [], p = [] }",
     {"pressure.table.t", "is empty"}},
    {"UnsortedTable",
     "segments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "table = { t = [\"0 s\", \"2 s\", \"1 s\"], p = [\"0 Pa\", \"1 Pa\", \"2 Pa\"] }",
     {"case.toml:17", "times must increase"}},
    {"RaggedTable",
     "segments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "table = { t = [\"0 s\", \"2 s\"], p = [\"0 Pa\"] }",
     {"differ in length"}},
    {"MissingTableFile",
     "segments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
     "table = { file = \"none.csv\" }",
     {"none.csv", "cannot be read"}},
    {"NegativeEnd", "t_end = \"6 s\"", "t_end = \"-6 s\"", {"solve.t_end", "> 0 s"}},
    {"ZeroEnd", "t_end = \"6 s\"", "t_end = \"0 s\"", {"solve.t_end", "> 0 s"}},
    {"UnknownMethod", "samples = 20", "samples = 20\nmethod = \"exact\"", {"case.toml:25", "\"quadrature\""}},
    {"QuadratureUnderARamp",
     "samples = 20",
     "samples = 20\nmethod = \"quadrature\"",
     {"case.toml:25", "solve.method = \"quadrature\"", "not constant from 0 s to 2 s (piece 1 of the program)",
      "\"adaptive\"", "hold and step"}},
    {"TooTight", "samples = 20", "samples = 20\nrtol = 1e-15", {"solve.rtol", "from 1e-13 to 0.01"}},
    {"TooLoose", "samples = 20", "samples = 20\nrtol = 0.5", {"solve.rtol", "from 1e-13 to 0.01"}},
    {"AbsurdSamples", "samples = 20", "samples = 1000000000000", {"solve.samples", "from 2 to 1e+07"}},
    {"OneSample", "samples = 20", "samples = 1", {"solve.samples", "from 2"}},
    {"FractionalSamples", "samples = 20", "samples = 20.5", {"solve.samples", "not an integer"}},
    {"SamplesAndTimes",
     "samples = 20",
     "samples = 20\ntimes = [\"1 s\"]",
     {"solve.samples", "solve.times", "one of them"}},
    {"TimesNotIncreasing", "samples = 20", "times = [\"2 s\", \"1 s\"]", {"times must increase"}},
    {"TimesTooLate", "samples = 20", "times = [\"2 s\", \"7 s\"]", {"later than solve.t_end"}},
    {"EmptyTimes", "samples = 20", "times = []", {"solve.times", "is empty"}},
    {"WrongType", "[balloon]\nradius", "[balloon]\nradius = [1]\n#", {"balloon.radius", "a list"}},
    {"TableForValue", "name = \"orifice\"", "name = { full = true }", {"model.name", "a table, not a string"}},
    {"ValueForTable", "[initial]\nstretch = 1.0", "[model]\n", {"case.toml"}},
    {"DateForQuantity", "\"30 cm\"", "2026-01-01", {"a date or time"}},
    {"UnknownModel", "name = \"orifice\"", "name = \"orifise\"", {"case.toml:21", "unknown name", "\"long-channel\""}},
    {"OrificeTooWideForThePotentialClosure",
     "\"3 cm\"\nchannel_length = \"0 cm\"\n[pressure]\nsegments = [ { to = \"36 kPa\", over = \"2 s\", shape = "
     "\"smooth\" }, "
     "{ hold = \"2 s\" } ]\n[initial]\nstretch = 1.0\n[model]\nname = \"orifice\"",
     "\"24 cm\"\n[pressure]\nconstant = \"1 kPa\"\n[model]\nclosure = \"potential\"",
     {"case.toml:14", "inlet.orifice_radius", "\"potential\"", "0.225 m"}},
    {"StartBeyondThePotentialClosure",
     "stretch = 1.0\n[model]\n",
     "stretch = 0.13\n[model]\nclosure = \"potential\"\n",
     {"case.toml:19", "initial.stretch", "beyond the range of model.closure", "0.13333333"}},
    {"UnknownClosure",
     "name = \"orifice\"",
     "name = \"orifice\"\nclosure = \"exact\"",
     {"model.closure", "\"theoretical\""}},
    {"UnknownMaterial", "mooney-rivlin", "mooney", {"material.model", "unknown name", "mooney-rivlin"}},
    {"KeyOfAnotherMaterial",
     "s2 = \"0.15 MPa\"",
     "s2 = \"0.15 MPa\"\njm = 3.0",
     {"material.jm", "not a key of this material", "gent"}},
    {"UnstableMaterial", "\"1.5 MPa\"", "\"-1.5 MPa\"", {"unstable"}},
    {"BurstBeforeStart",
     "s2 = \"0.15 MPa\"",
     "s2 = \"0.15 MPa\"\nmax_stretch = 0.5",
     {"material.max_stretch", "above 1"}},
    {"LongChannelWithoutChannel",
     "name = \"orifice\"",
     "name = \"long-channel\"",
     {"case.toml:21", "there is no channel"}},
    {"OrificeWithChannel",
     "channel_length = \"0 cm\"",
     "channel_length = \"50 cm\"",
     {"case.toml:21", "there is a channel"}},
    {"UnknownOutputUnit",
     "[solve]",
     "[output]\npressure_unit = \"parsec\"\n[solve]",
     {"output.pressure_unit", "wrong dimension"}},
    {"UnknownQuantity",
     "[solve]",
     "[expect]\npeak = { value = 1.0, tolerance = 0.1 }\n[solve]",
     {"expect.peak", "did you mean expect.peak_"}},
    {"ExpectationWithoutTolerance",
     "[solve]",
     "[expect]\npeak_stretch = { value = 1.0 }\n[solve]",
     {"expect.peak_stretch.tolerance: missing"}},
    {"NotToml", "[balloon]", "[balloon", {"case.toml:2", "not valid TOML"}},
    {"KeyTwice", "radius = \"30 cm\"", "radius = \"30 cm\"\nradius = \"31 cm\"", {"case.toml:4", "not valid TOML"}},
};

// The lines below [motion], which is line 21.
const std::vector<std::pair<std::string, std::vector<std::string>>> bad_motions{
    {"", {"motion.radius: missing", "motion.velocity: missing"}},
    {"radius = \"30 cm\"\n", {"motion.velocity: missing", "at least one segment"}},
    {"velocity = [ { hold = \"1 s\" } ]\n", {"motion.radius: missing"}},
    {"radius = \"30 cm\"\nvelocity = []\n", {"case.toml:23", "motion.velocity", "is empty"}},
    {"radius = \"30 cm\"\nvelocity = \"2 cm/s\"\n", {"motion.velocity", "not a list of tables"}},
    {"radius = \"30 cm\"\nvelocity = [ \"2 cm/s\" ]\n", {"motion.velocity[0]", "not a table"}},
    {"radius = \"30 cm\"\nvelocity = [ { step = \"2 cm/s\" } ]\n",
     {"case.toml:23", "motion.velocity[0]", "infinite acceleration", "to = \"2 cm/s\", over ="}},
    {"radius = \"30 cm\"\nvelocity = [ { shape = \"smooth\" } ]\n", {"says neither hold nor to"}},
    {"radius = \"30 cm\"\nvelocity = [ { to = \"2 cm/s\" } ]\n", {"says to but not over"}},
    {"radius = \"30 cm\"\nvelocity = [ { to = \"2 cm\", over = \"1 s\" } ]\n",
     {"motion.velocity[0].to", "\"cm\" has the wrong dimension", "m/s"}},
    {"radius = \"30 kPa\"\nvelocity = [ { hold = \"1 s\" } ]\n", {"motion.radius", "\"kPa\" has the wrong dimension"}},
    {"radius = \"30 cm\"\nspeed = \"1 m/s\"\nvelocity = [ { hold = \"1 s\" } ]\n",
     {"case.toml:23", "motion.speed", "unknown key"}},
    {"radius = \"30 cm\"\nstrat = \"1 m/s\"\nvelocity = [ { hold = \"1 s\" } ]\n", {"did you mean motion.start"}},
    {"radius = \"3 cm\"\nvelocity = [ { hold = \"1 s\" } ]\n",
     {"case.toml:22", "no larger than its orifice", "inlet.orifice_radius = 0.03 m"}},
    // from 0.3 m at -0.2 m/s: 0.03 m is passed after 1.35 s, and at the end of the run 0.3 m - 6 s 0.2 m/s is left
    {"radius = \"30 cm\"\nstart = \"-20 cm/s\"\nvelocity = [ { hold = \"1 s\" } ]\n",
     {"case.toml:24", "motion.velocity", "at t = 1.35 s, and to -0.9 m at t = 6 s",
      "above inlet.orifice_radius = 0.03 m"}},
    // -0.4 m/s to 0.4 m/s over 4 s turns after 2 s, 0.4 m further in
    {"radius = \"30 cm\"\nstart = \"-40 cm/s\"\nvelocity = [ { to = \"40 cm/s\", over = \"4 s\" } ]\n",
     {"and to -0.1 m at t = 2 s"}},
    {"radius = \"30 cm\"\nvelocity = [ { to = \"10 m/s\", over = \"1 s\" } ]\n",
     {"grows to 55.3 m at t = 6 s", "30 m"}},
    {"radius = \"30 cm\"\nvelocity = [ { hold = \"1e308 s\" }, { hold = \"1e308 s\" } ]\n", {"never end"}},
    {"radius = \"30 cm\"\nvelocity = [ { hold = \"1 s\" } ]\n[pressure]\nconstant = \"1 kPa\"\n",
     {"case.toml:24", "pressure: given together with [motion]", "[pressure] and [initial]"}},
    {"radius = \"30 cm\"\nvelocity = [ { hold = \"1 s\" } ]\n[initial]\nstretch = 1.1\n",
     {"case.toml:24", "initial: given together with [motion]", "[pressure] and [initial]"}},
    {"radius = \"30 cm\"\nvelocity = [ { hold = \"1 s\" } ]\n[expect]\nevents = { value = 1, tolerance = 0 }\n",
     {"expect: given together with [motion]"}},
};

TEST(BadInput, DictatedMotions) {
  const Folder folder;
  for (const auto& [motion, says] : bad_motions) {
    test::write(folder / "case.toml", dictated(motion));
    const auto validated = turgor(folder, {"validate", "case.toml"});
    EXPECT_EQ(validated.code, 2) << motion;
    for (const auto& words : says) {
      EXPECT_NE(validated.err.find(words), std::string::npos) << "no \"" << words << "\" in:\n" << validated.err;
    }
    const auto force = turgor(folder, {"force", "case.toml", "-o", "result"});
    EXPECT_EQ(force.code, 2);
    EXPECT_EQ(force.err, validated.err);
    EXPECT_FALSE(std::filesystem::exists(folder / "result"));
  }
  test::write(folder / "case.toml", "motion = 3\n" + good_case);
  EXPECT_NE(turgor(folder, {"validate", "case.toml"}).err.find("motion = 3: is an integer, not a table"),
            std::string::npos);
}

TEST(BadInput, ForcesThatAreNoNumbers) {
  const Folder folder;
  test::write(folder / "case.toml",
              dictated("radius = \"30 cm\"\nvelocity = [ { to = \"1e200 m/s\", over = \"1e-210 s\" }, "
                       "{ to = \"0 m/s\", over = \"1e-210 s\" } ]\n"));
  const auto result = turgor(folder, {"force", "case.toml", "-o", "result"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("not a finite number (r = 0.3 m, dr/dt = "), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "result"));
}

// Each command tells which one takes the other kind of case.
TEST(BadInput, CasesForAnotherCommand) {
  const Folder folder;
  test::write(folder / "motion.toml", dictated("radius = \"30 cm\"\nvelocity = [ { hold = \"1 s\" } ]\n"));
  ASSERT_EQ(turgor(folder, {"validate", "motion.toml"}).code, 0);
  for (const char* command : {"run", "info"}) {
    const auto result = turgor(folder, {command, "motion.toml"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("motion.toml: motion: the case dictates the radius"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("`turgor force`"), std::string::npos) << result.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "motion.run"));

  test::write(folder / "case.toml", good_case);
  const auto result = turgor(folder, {"force", "case.toml"});
  EXPECT_EQ(result.code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "case.force"));
  // the lines that the message shows make a case
  const std::size_t lines = result.err.find("[motion]\nradius = ");
  ASSERT_NE(lines, std::string::npos) << result.err;
  test::write(folder / "case.toml", without(good_case, "[pressure]", "[model]") + result.err.substr(lines));
  EXPECT_EQ(turgor(folder, {"force", "case.toml", "--no-pictures"}).code, 0);
}

INSTANTIATE_TEST_SUITE_P(Mistakes, BadCase, testing::ValuesIn(mistakes),
                         [](const auto& test) { return test.param.name; });

TEST(BadInput, AllIssuesOfAFileAreReportedAtOnce) {
  const Folder folder;
  std::string text = replaced("\"30 cm\"", "\"-30 cm\"");
  text.replace(text.find("\"3 mm\""), 6, "3");
  text.replace(text.find("\"orifice\""), 9, "\"hole\"");
  test::write(folder / "case.toml", text);
  const auto result = turgor(folder, {"validate", "case.toml"});
  EXPECT_EQ(result.code, 2);
  for (const char* key : {"balloon.radius", "balloon.thickness", "model.name"})
    EXPECT_NE(result.err.find(key), std::string::npos);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 3);
}

TEST(BadInput, UnreadableFiles) {
  const Folder folder;
  for (const char* command : {"run", "force", "info", "validate"}) {
    const auto missing = turgor(folder, {command, "none.toml"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_NE(missing.err.find("none.toml"), std::string::npos);
    EXPECT_EQ(turgor(folder, {command, "."}).code, 2);
  }
}

TEST(BadInput, OddBytesAreNoCrash) {
  const Folder folder;
  for (const std::string& bytes :
       {std::string("\xff\xfe\x00\x01", 4), std::string("a = \"\xc3\x28\""), std::string("\0", 1),
        std::string("[[[[[["), std::string("x = " + std::string(5000, '['))}) {
    test::write(folder / "case.toml", bytes);
    EXPECT_EQ(turgor(folder, {"validate", "case.toml"}).code, 2);
  }
}

TEST(BadInput, CsvTables) {
  const Folder folder;
  test::write(folder / "case.toml",
              replaced("segments = [ { to = \"36 kPa\", over = \"2 s\", shape = \"smooth\" }, { hold = \"2 s\" } ]",
                       "table = { file = \"p.csv\" }"));
  const auto message = [&](const std::string& csv) {
    test::write(folder / "p.csv", csv);
    const auto result = turgor(folder, {"validate", "case.toml"});
    EXPECT_EQ(result.code, csv.starts_with("t [ms],p [mmHg]\n0,0\n100,20") ? 0 : 2) << result.err;
    return result.err;
  };
  EXPECT_EQ(message("t [ms],p [mmHg]\n0,0\n100,20\n"), "");
  EXPECT_NE(message("").find("no rows"), std::string::npos);
  EXPECT_NE(message("t,p\n0,0\n1,1\n").find("has no unit"), std::string::npos);
  EXPECT_NE(message("t [s],p [m]\n0,0\n1,1\n").find("wrong dimension"), std::string::npos);
  EXPECT_NE(message("t [s],p [Pa]\n0,0\n1\n").find("row 3"), std::string::npos);
  EXPECT_NE(message("t [s],p [Pa]\n0,0\n1,x\n").find("\"x\" is not a finite number"), std::string::npos);
  EXPECT_NE(message("t [s],p [Pa]\n0,0\n1,nan\n").find("not a finite number"), std::string::npos);
  EXPECT_NE(message("t [s],p [Pa]\n1,0\n0,1\n").find("increase"), std::string::npos);
  EXPECT_NE(message("t [s],p [Pa]\n0,0\n").find("at least two rows"), std::string::npos);
}

TEST(BadInput, Overrides) {
  const Folder folder;
  test::write(folder / "case.toml", good_case);
  const auto message = [&](const std::string& assignment) {
    const auto result = turgor(folder, {"validate", "case.toml", "--set", assignment});
    EXPECT_EQ(result.code, 2) << assignment;
    EXPECT_NE(result.err.find("--set"), std::string::npos) << result.err;
    return result.err;
  };
  EXPECT_NE(message("inlet.orifice_radius").find("no equals sign"), std::string::npos);
  EXPECT_NE(message("=3").find("no key"), std::string::npos);
  EXPECT_NE(message("inlet.orifice_radios=2 cm").find("did you mean"), std::string::npos);
  EXPECT_NE(message("inlet.orifice_radius=2").find("missing unit"), std::string::npos);
  EXPECT_NE(message("pressure.segments[7].to=2 kPa").find("has no element [7]"), std::string::npos);
  EXPECT_NE(message("pressure.segments[x].to=2 kPa").find("index"), std::string::npos);
  EXPECT_NE(message("title.more=2").find("runs through a string"), std::string::npos);
}

TEST(BadInput, RunDirectories) {
  const Folder folder;
  test::write(folder / "case.toml", good_case);
  const std::vector<std::string> run{"run", "case.toml", "-q", "--no-pictures", "-o"};
  const auto into = [&](const std::string& directory, const std::string& extra = "--no-pictures") {
    auto arguments = run;
    arguments.push_back(directory);
    if (extra != "--no-pictures") arguments.push_back(extra);
    return turgor(folder, arguments);
  };
  EXPECT_EQ(into("result").code, 0);
  const auto again = into("result");
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("exists already"), std::string::npos);
  EXPECT_NE(again.err.find("--force"), std::string::npos);
  EXPECT_EQ(into("result", "--force").code, 0);

  test::write(folder / "file", "");
  EXPECT_NE(into("file").err.find("is a file"), std::string::npos);
  EXPECT_EQ(into("file/below").code, 2);
  EXPECT_EQ(into("/proc/turgor").code, 2);
  EXPECT_NE(into("/proc/turgor").err.find("cannot be created"), std::string::npos);
}

TEST(BadInput, CommandLines) {
  const Folder folder;
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {}, {"simulate"}, {"run"}, {"run", "a", "b"}, {"run", "a", "--fast"}, {"force"}, {"doc", "tables"}}) {
    const auto result = turgor(folder, arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err, "");
  }
}

// A build without deal.II has no turgor-fem beside it.
TEST(BadInput, FiniteElementsThatWereNotBuiltAreExplained) {
  const Folder folder;
  std::filesystem::copy_file(TURGOR_PROGRAM, folder / "turgor");
  const auto run = test::shell(folder, "./turgor fem flow case.toml");
  EXPECT_EQ(run.code, 4);
  for (const std::string words : {"turgor-fem", "TURGOR_FEM", "./dev build fem"}) {
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace turgor
