// turgor coefficients and turgor profile, as a user meets them.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "../support/program.hpp"

namespace turgor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contents;
using test::Folder;
using test::turgor;

const std::string example = (fs::path(TURGOR_CASES) / "profile-orifice.csv").string();

json coefficients(const Folder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"coefficients", "--json", "--kappa"});
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  return json::parse(result.out);
}

json profile(const Folder& folder, const std::string& csv, std::vector<std::string> arguments = {}) {
  test::write(folder / "f.csv", csv);
  arguments.insert(arguments.begin(), {"profile", "f.csv", "--json"});
  const auto result = turgor(folder, arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  return json::parse(result.out);
}

void expect_close(const json& value, double expected, double tolerance) {
  EXPECT_NEAR(value.get<double>(), expected, tolerance * std::abs(expected));
}

// Values of an independent evaluation of appendix B, to the digits given.
TEST(CoefficientsCommand, ValuesAndErrorsOfTheFits) {
  const Folder folder;
  const json low = coefficients(folder, {"1/200"}).at(0);
  EXPECT_EQ(low.at("kappa"), 0.005);
  expect_close(low.at("g3"), 10096.962, 1e-7);
  expect_close(low.at("g5"), 1.6005067e11, 1e-7);
  EXPECT_NEAR(low.at("g3_fit_error").get<double>(), 0.0085, 5e-5);
  EXPECT_NEAR(low.at("g5_fit_error").get<double>(), -0.0403, 5e-5);
  const json high = coefficients(folder, {"0.1", "--harmonics", "20000"}).at(0);
  expect_close(high.at("g3"), 508.65924, 1e-7);
  expect_close(high.at("g5"), 9.1541781e5, 1e-7);
  expect_close(high.at("g5_truncated_without_integral"), 9.1707347e5, 1e-7);
  EXPECT_NEAR(high.at("g5_fit_error").get<double>(), 0.0435, 5e-5);
  EXPECT_LT(std::abs(high.at("g3_close_error").get<double>()), 6.1e-7);
  // (2.9), and the channel's coefficients in closed form
  const double pi = std::acos(-1.0);
  const double eps = 1 - std::sqrt(1 - 0.01);
  expect_close(high.at("epsilon"), eps, 1e-13);
  expect_close(high.at("g1"), 2 * pi * (2 - eps), 1e-14);
  expect_close(high.at("g1_leading"), 4 * pi, 1e-15);
  expect_close(high.at("g2_leading"), 8 * pi / eps, 1e-13);
  expect_close(high.at("g4_leading"), -16 * pi / eps, 1e-13);
  EXPECT_FALSE(low.contains("g3_truncated"));
}

TEST(CoefficientsCommand, RangesAreGeometric) {
  const Folder folder;
  const json rows = coefficients(folder, {"1/200:1/10:5"});
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows.front().at("kappa"), 0.005);
  EXPECT_EQ(rows.back().at("kappa"), 0.1);
  expect_close(rows.at(2).at("kappa"), std::sqrt(0.0005), 1e-14);
  EXPECT_EQ(rows.at(4), coefficients(folder, {"0.1"}).at(0));
}

// The table ends at 0.75; above it the flow is computed.
TEST(CoefficientsCommand, WideOrificesContinueTheTable) {
  const Folder folder;
  const json below = coefficients(folder, {"0.75"}).at(0);
  const json above = coefficients(folder, {"0.7500001"}).at(0);
  for (const char* name : {"g3", "g5"}) expect_close(above.at(name), below.at(name), 1e-5);  // slopes of order 10
  EXPECT_TRUE(std::isfinite(coefficients(folder, {"0.999"}).at(0).at("g5").get<double>()));
}

TEST(CoefficientsCommand, AUniformProfileChangesNothing) {
  const Folder folder;
  test::write(folder / "f.csv", "Upsilon [1],velocity [m/s]\n0,3\n0.3,3\n0.6,3\n1,3\n");
  const json expected = coefficients(folder, {"1/50"}).at(0);
  const json found = coefficients(folder, {"1/50", "--profile", "f.csv", "--harmonics", "3000"}).at(0);
  for (const char* name : {"g1", "g2", "g3", "g4", "g5"}) expect_close(found.at(name), expected.at(name), 1e-10);
  const json sums = coefficients(folder, {"1/50", "--harmonics", "3000"}).at(0);
  expect_close(found.at("g5_truncated"), sums.at("g5_truncated"), 1e-8);
}

TEST(CoefficientsCommand, TableAndFiles) {
  const Folder folder;
  const auto table = turgor(folder, {"coefficients", "--kappa", "1/200:1/10:5", "--harmonics", "100"});
  EXPECT_EQ(table.code, 0);
  EXPECT_NE(table.out.find("10096.96"), std::string::npos);
  EXPECT_NE(table.out.find("-4.03"), std::string::npos);
  const auto result = turgor(folder, {"coefficients", "--kappa", "1/200:1/10:5", "-o", "out"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::string csv = contents(folder / "out" / "coefficients.csv");
  EXPECT_TRUE(csv.starts_with("kappa [1],epsilon [1],g1 [1],g2 [1],g3 [1],g4 [1],g5 [1],g1_leading [1],"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  EXPECT_EQ(contents(folder / "out" / "coefficients.png").substr(1, 3), "PNG");
  EXPECT_EQ(turgor(folder, {"coefficients", "--kappa", "0.1", "-o", "out"}).code, 2);
  EXPECT_EQ(turgor(folder, {"coefficients", "--kappa", "0.1", "-o", "out", "--force"}).code, 0);
  EXPECT_FALSE(fs::exists(folder / "out" / "coefficients.png"));
}

TEST(CoefficientsCommand, Mistakes) {
  const Folder folder;
  const auto message = [&](const std::string& kappa, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"coefficients", "--kappa", kappa});
    const auto result = turgor(folder, more);
    EXPECT_EQ(result.code, 2) << kappa;
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  for (const char* kappa : {"1", "0", "-0.1", "1/1", "3/2", "0.1:1:3", "0:0.1:3"}) {
    EXPECT_NE(message(kappa).find("lies between 0 and 1"), std::string::npos) << kappa;
  }
  for (const char* kappa : {"", "x", "nan", "inf", "1/0", "1/", "0.1 ", "0.1x", "x:0.1:3"}) {
    EXPECT_NE(message(kappa).find(*kappa == '\0' ? "kappa" : "is not a number"), std::string::npos) << kappa;
  }
  EXPECT_NE(message("1e-6").find("7.62939453125e-06"), std::string::npos);
  EXPECT_NE(message("0.01:0.1:1").find("allowed are 2 to"), std::string::npos);
  EXPECT_NE(message("0.01:0.1:2.5").find("\"2.5\""), std::string::npos);
  EXPECT_NE(message("0.01:0.1:1000000000").find("allowed are 2 to"), std::string::npos);
  EXPECT_NE(message("0.1:0.01:5").find("FROM must be less than TO"), std::string::npos);
  EXPECT_NE(message("0.1:0.1:5").find("FROM must be less than TO"), std::string::npos);
  EXPECT_NE(message("0.01:0.1").find("FROM:TO:N"), std::string::npos);
  EXPECT_NE(message("0.01:0.1:3:4").find("FROM:TO:N"), std::string::npos);
  EXPECT_NE(message("0.1", {"--harmonics", "0"}).find("--harmonics"), std::string::npos);
  EXPECT_NE(message("0.1", {"--harmonics", "200000", "--profile", example}).find("100000"), std::string::npos);
  EXPECT_EQ(turgor(folder, {"coefficients"}).code, 2);
}

TEST(ProfileCommand, UniformOutflowHasFactorsOfOne) {
  const Folder folder;
  const json study = profile(folder, "Upsilon [1],f [1]\n0,2\n0.4,2\n0.7,2\n1,2\n");
  expect_close(study.at("normalisation"), 0.5, 1e-13);
  expect_close(study.at("momentum_factor"), 1, 1e-13);
  EXPECT_EQ(study.at("harmonics"), 20000);
  ASSERT_EQ(study.at("factors").size(), 9U);
  expect_close(study.at("factors").front().at("kappa"), 1 / 200.0, 1e-14);
  expect_close(study.at("factors").back().at("kappa"), 1 / 10.0, 1e-14);
  for (const char* way : {"exact", "paper"}) {
    expect_close(study.at(way).at("inertial_factor"), 1, 1e-8);  // 2e4 harmonics by quadrature
    expect_close(study.at(way).at("centripetal_factor"), 1, 1e-8);
    expect_close(study.at(way).at("inertial_constant"), 9 * std::sqrt(2.0) / 2, 1e-8);
    expect_close(study.at(way).at("centripetal_constant"), 1.5, 1e-8);
  }
}

// The paper's closure: an inertial factor of 1.095, constants of 223/32 and 75/32.
TEST(ProfileCommand, TheShippedProfileIsNearThePaperS) {
  const Folder folder;
  const json study = profile(folder, contents(example));
  for (const json& row : study.at("factors")) {
    EXPECT_NEAR(row.at("inertial_factor").get<double>(), 1.10, 0.01);
    EXPECT_GT(row.at("centripetal_factor").get<double>(), 1.59);
    EXPECT_LT(row.at("centripetal_factor").get<double>(), 1.65);
  }
  const json& last = study.at("factors").back();  // 2e4 harmonics are enough at kappa = 1/10
  expect_close(last.at("inertial_factor_paper"), last.at("inertial_factor"), 1e-5);
  expect_close(last.at("centripetal_factor_paper"), last.at("centripetal_factor"), 1e-3);
  expect_close(study.at("exact").at("inertial_constant"), 223 / 32.0, 0.01);
  expect_close(study.at("exact").at("centripetal_constant"), 75 / 32.0, 0.05);
}

TEST(ProfileCommand, LengthsAndSpeedsOfAnyUnit) {
  const Folder folder;
  const json expected = profile(folder, contents(example), {"--kappa", "1/20", "--harmonics", "500"});
  json found = profile(folder, "radius [mm],velocity [cm/s]\n0,127\n15,119\n24,98\n27,80\n28.5,65\n30,0\n",
                       {"--kappa", "0.05", "--harmonics", "500"});
  expect_close(found.at("normalisation"), expected.at("normalisation").get<double>(), 1e-12);
  for (const char* name : {"inertial_factor", "centripetal_factor", "centripetal_factor_paper"}) {
    expect_close(found.at("factors").at(0).at(name), expected.at("factors").at(0).at(name).get<double>(), 1e-9);
  }
}

// f = 2 (1 - Upsilon^2): momentum factor 4/3; between its rows a cubic, 1e-4 off for rows 1/20 apart.
TEST(ProfileCommand, PoiseuilleSMomentumFactor) {
  const Folder folder;
  std::string csv = "Upsilon [1],f [1]\n";
  for (int k = 0; k <= 20; ++k) csv += std::to_string(k / 20.0) + "," + std::to_string(1 - k * k / 400.0) + "\n";
  const json study = profile(folder, csv, {"--kappa", "1/10", "--harmonics", "500"});
  expect_close(study.at("momentum_factor"), 4 / 3.0, 1e-3);
  expect_close(study.at("normalisation"), 2, 1e-3);
}

TEST(ProfileCommand, TableAndFiles) {
  const Folder folder;
  const auto result = turgor(folder, {"profile", example, "-o", "out"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("223/32"), std::string::npos);
  const std::string csv = contents(folder / "out" / "profile.csv");
  EXPECT_TRUE(csv.starts_with("kappa [1],inertial [1],centripetal [1],inertial_paper [1],centripetal_paper [1]\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 10);
  EXPECT_EQ(contents(folder / "out" / "profile.png").substr(1, 3), "PNG");
  EXPECT_EQ(turgor(folder, {"profile", example, "-o", "out"}).code, 2);
  EXPECT_EQ(turgor(folder, {"profile", example, "-o", "one", "--kappa", "0.02"}).err, "");
}

struct Wrong {
  std::string name;
  std::string csv;
  std::vector<std::string> says;
};

class WrongProfile : public testing::TestWithParam<Wrong> {};

TEST_P(WrongProfile, IsExplained) {
  const Folder folder;
  test::write(folder / "f.csv", GetParam().csv);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"profile", "f.csv"}, {"coefficients", "--kappa", "0.1", "--profile", "f.csv"}}) {
    const auto result = turgor(folder, command);
    EXPECT_EQ(result.code, 2) << result.out;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("f.csv"), std::string::npos) << result.err;
    for (const auto& words : GetParam().says) {
      EXPECT_NE(result.err.find(words), std::string::npos) << "no \"" << words << "\" in:\n" << result.err;
    }
  }
}

const std::vector<Wrong> wrong_profiles{
    {"Inflow", "U [1],f [1]\n0,-1\n0.5,-1\n0.7,-1\n1,-1\n", {"into the balloon", "out of it"}},
    {"NoFlux", "U [1],f [1]\n0,0\n0.5,0\n0.7,0\n1,0\n", {"carries no liquid"}},
    {"NotANumber", "U [1],f [1]\n0,1\n0.5,nan\n0.7,1\n1,0\n", {"row 3", "\"nan\" is not a finite number"}},
    {"Word", "U [1],f [1]\n0,1\n0.5,x\n0.7,1\n1,0\n", {"row 3", "\"x\""}},
    {"TooFew", "U [1],f [1]\n0,1\n0.5,1\n1,0\n", {"3 points", "too few", "four"}},
    {"NoRows", "U [1],f [1]\n", {"no rows of numbers"}},
    {"Empty", "", {"no rows of numbers"}},
    {"NotFromTheAxis", "U [1],f [1]\n0.1,1\n0.5,1\n0.7,1\n1,0\n", {"row 2", "axis"}},
    {"NotToTheRim", "U [1],f [1]\n0,1\n0.5,1\n0.7,1\n0.9,0\n", {"row 5", "Upsilon = 0.9", "last Upsilon is 1"}},
    {"LengthNotFromTheAxis", "r [mm],f [1]\n1,1\n2,1\n3,1\n4,0\n", {"row 2", "axis"}},
    {"NotIncreasing", "U [1],f [1]\n0,1\n0.5,1\n0.5,0.9\n1,0\n", {"row 4", "increase"}},
    {"NoUnits", "U,f\n0,1\n0.5,1\n0.7,1\n1,0\n", {"has no unit", "[1]"}},
    {"WrongUnit", "U [s],f [1]\n0,1\n0.5,1\n0.7,1\n1,0\n", {"row 1", "wrong dimension", "1 or m"}},
    {"WrongSpeed", "U [1],f [Pa]\n0,1\n0.5,1\n0.7,1\n1,0\n", {"row 1", "wrong dimension", "1 or m/s"}},
    {"OneColumn", "U [1]\n0\n0.5\n0.7\n1\n", {"has 1 columns", "2 are needed"}},
};
INSTANTIATE_TEST_SUITE_P(All, WrongProfile, testing::ValuesIn(wrong_profiles),
                         [](const auto& test) { return test.param.name; });

TEST(ProfileCommand, OtherMistakes) {
  const Folder folder;
  EXPECT_NE(turgor(folder, {"profile", "none.csv"}).err.find("none.csv"), std::string::npos);
  EXPECT_EQ(turgor(folder, {"profile"}).code, 2);
  EXPECT_EQ(turgor(folder, {"profile", example, "--kappa", "2"}).code, 2);
  EXPECT_EQ(turgor(folder, {"profile", example, "--harmonics", "0"}).code, 2);
  EXPECT_EQ(turgor(folder, {"profile", example, "--harmonics", "1000000"}).code, 2);
}

}  // namespace
}  // namespace turgor
