// [model] closure = "profile": a measured outflow profile in the equation of motion, as a user meets it.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::turgor;
using test::write;

const std::string balloon = R"(balloon = { radius = "30 cm", thickness = "3 mm", density = "1000 kg/m^3" }
material = { model = "mooney-rivlin", s1 = "1.5 MPa", s2 = "0.15 MPa" }
fluid = { density = "1000 kg/m^3", viscosity = "0.894 mPa s" }
inlet = { orifice_radius = "3 cm" }
solve = { t_end = "4 s", samples = 50 }
pressure = { start = "36 kPa", segments = [ { to = "0 Pa", over = "1 s" } ] }
initial = { stretch = "equilibrium" }
)";
const std::string measured = "Upsilon [1],f [1]\n0,1.27\n0.5,1.19\n0.8,0.98\n0.9,0.80\n0.95,0.65\n1,0\n";

json run(const Folder& folder, const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"run", file, "--json", "--no-pictures", "--force"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  return json::parse(result.out);
}

double final_stretch(const json& document) { return document.at("quantities").at("final_stretch").get<double>(); }

// A uniform profile is the potential closure; the measured one makes deflation slower.
TEST(ProfileClosure, UsesTheProfile) {
  const Folder folder;
  write(folder / "uniform.csv", "Upsilon [1],f [1]\n0,3\n0.2,3\n0.5,3\n1,3\n");
  write(folder / "measured.csv", measured);
  write(folder / "potential.toml", balloon + "model = { closure = \"potential\" }\n");
  write(folder / "uniform.toml", balloon + "model = { closure = \"profile\", profile = \"uniform.csv\" }\n");
  write(folder / "measured.toml", balloon + "model = { closure = \"profile\", profile = \"measured.csv\" }\n");
  const double potential = final_stretch(run(folder, "potential.toml"));
  EXPECT_NEAR(final_stretch(run(folder, "uniform.toml")), potential, 1e-8);
  EXPECT_GT(final_stretch(run(folder, "measured.toml")), potential + 1e-3);
}

// The resolved case holds the points, so that it needs no file.
TEST(ProfileClosure, IsResolvedToItsPoints) {
  const Folder folder;
  write(folder / "measured.csv", measured);
  write(folder / "a.toml", balloon + "model = { closure = \"profile\", profile = \"measured.csv\" }\n");
  (void)run(folder, "a.toml", {"-o", "a"});
  fs::remove(folder / "measured.csv");
  fs::copy_file(folder / "a" / "resolved.toml", folder / "b.toml");
  (void)run(folder, "b.toml", {"-o", "b"});
  EXPECT_EQ(contents(folder / "a" / "trajectory.csv"), contents(folder / "b" / "trajectory.csv"));
}

TEST(ProfileClosure, LeadsAForceHistory) {
  const Folder folder;
  write(folder / "measured.csv", measured);
  const auto result = turgor(
      folder, {"force", (fs::path(TURGOR_CASES) / "motion-orifice-30mm.toml").string(), "--json", "--no-pictures",
               "--set", "model.closure=profile", "--set",
               "model.profile_points={ upsilon = [0.0, 0.5, 0.8, 0.9, 0.95, 1.0], f = [1.27, 1.19, 0.98, 0.80, 0.65, "
               "0.0] }"});
  ASSERT_EQ(result.code, 0) << result.err;
  const json forces = json::parse(result.out).at("forces");
  const auto peak = [&](const char* closure) { return forces.at(closure).at("peak_deflating").at("force_N"); };
  // Section 2.3: the profile raises the centripetal force by 1.56; here by 1.6 around kappa = 0.09.
  EXPECT_NEAR(peak("profile").get<double>() / peak("potential").get<double>(), 1.6, 0.05);
}

struct Mistake {
  const char* name;
  const char* model;
  const char* says;
};

class BadProfileClosure : public testing::TestWithParam<Mistake> {};

TEST_P(BadProfileClosure, IsExplained) {
  const Folder folder;
  write(folder / "inward.csv", "Upsilon [1],f [1]\n0,-1\n0.2,-1\n0.5,-1\n1,0\n");
  write(folder / "nothing.csv", "Upsilon [1],f [1]\n0,0\n0.2,0\n0.5,0\n1,0\n");
  write(folder / "nan.csv", "Upsilon [1],f [1]\n0,1\n0.2,nan\n0.5,1\n1,0\n");
  write(folder / "short.csv", "Upsilon [1],f [1]\n0,1\n0.5,1\n1,0\n");
  write(folder / "measured.csv", measured);
  write(folder / "case.toml", balloon + "model = " + GetParam().model + "\n");
  const auto result = turgor(folder, {"validate", "case.toml"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find(GetParam().says), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("case.toml:8"), std::string::npos) << result.err;
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, BadProfileClosure,
    testing::Values(
        Mistake{"NoProfile", R"({ closure = "profile" })", "there is no profile"},
        Mistake{
            "TwoProfiles",
            R"({ closure = "profile", profile = "measured.csv", profile_points = { upsilon = [0, 1], f = [1, 1] } })",
            "there are two profiles"},
        Mistake{"OtherClosure", R"({ profile = "measured.csv" })", "goes with closure = \"profile\" only"},
        Mistake{"NoFile", R"({ closure = "profile", profile = "none.csv" })", "cannot be read"},
        Mistake{"NotAFile", R"({ closure = "profile", profile = 3 })", "not the name of a CSV file"},
        Mistake{"Inward", R"({ closure = "profile", profile = "inward.csv" })", "carries liquid into the balloon"},
        Mistake{"Nothing", R"({ closure = "profile", profile = "nothing.csv" })", "cannot be normalised"},
        Mistake{"NotANumber", R"({ closure = "profile", profile = "nan.csv" })", "row 3"},
        Mistake{"TooShort", R"({ closure = "profile", profile = "short.csv" })", "too few"},
        Mistake{"PointsBeyondTheRim",
                R"({ closure = "profile", profile_points = { upsilon = [0.0, 0.5, 0.9, 1.1], f = [1, 1, 1, 1] } })",
                "out of range"},
        Mistake{"PointsWithoutVelocities",
                R"({ closure = "profile", profile_points = { upsilon = [0, 0.5, 0.7, 1] } })",
                "profile_points.f: missing"},
        Mistake{"PointsAreNoTable", R"({ closure = "profile", profile_points = [1, 2] })", "not a table"}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace turgor
