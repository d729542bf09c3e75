#include "turgor/flow/outflow_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

TEST(OutflowProfile, IsNormalised) {
  EXPECT_DOUBLE_EQ(OutflowProfile::uniform().momentum_factor(), 1);
  const OutflowProfile poiseuille = OutflowProfile::polynomial({5, 0, -5});  // 2 (1 - Y^2)
  EXPECT_NEAR(poiseuille.normalisation(), 0.4, 1e-15);
  EXPECT_NEAR(poiseuille(0), 2, 1e-14);
  EXPECT_NEAR(poiseuille.at(0.7).value, 2 * (1 - 0.49), 1e-14);
  EXPECT_NEAR(poiseuille.at(0.7).slope, -4 * 0.7, 1e-13);
  EXPECT_NEAR(poiseuille.momentum_factor(), 4.0 / 3, 1e-14);
}

TEST(OutflowProfile, GoesThroughTheTable) {
  const std::vector<double> upsilon{0, 0.5, 0.8, 0.9, 0.95, 1};
  const std::vector<double> velocity{1.27, 1.19, 0.98, 0.80, 0.65, 0};
  const OutflowProfile profile = OutflowProfile::table(upsilon, velocity);
  for (std::size_t i = 0; i < upsilon.size(); ++i) {
    EXPECT_NEAR(profile(upsilon[i]), profile.normalisation() * velocity[i], 1e-14);
  }
  EXPECT_NEAR(profile.at(0).slope, 0, 1e-11);  // smooth at the axis, to the rounding of a derivative
  double flux = 0;                             // midpoint rule, error O(1e-8)
  constexpr int points = 20000;
  for (int i = 0; i < points; ++i) {
    const double y = (i + 0.5) / points;
    flux += y * profile(y) / points;
    EXPECT_LE(profile.at(y).slope, 1e-12) << y;  // monotone as the data
  }
  EXPECT_NEAR(flux, 0.5, 1e-7);
}

// A turbulent profile, singular at the rim: int Y (1-Y)^(1/7) dY = 49/120, so f = 60/49 (1-Y)^(1/7).
TEST(OutflowProfile, ApproximatesFunctions) {
  const OutflowProfile profile = OutflowProfile::function([](double y) { return std::pow(1 - y, 1.0 / 7); });
  EXPECT_NEAR(profile.normalisation(), 60.0 / 49, 1e-9);
  for (const double y : {0.0, 0.3, 0.9, 0.999, 0.999999}) {
    EXPECT_NEAR(profile(y), 60.0 / 49 * std::pow(1 - y, 1.0 / 7), 1e-9) << y;
  }
  // 2 (60/49)^2 int Y (1-Y)^(2/7) dY = 2 (60/49)^2 49/144
  EXPECT_NEAR(profile.momentum_factor(), 2 * 3600.0 / 2401 * 49 / 144, 1e-8);
}

void expect_refused(const std::vector<double>& upsilon, const std::vector<double>& velocity, const char* says) {
  try {
    (void)OutflowProfile::table(upsilon, velocity);
    ADD_FAILURE() << says;
  } catch (const InvalidInput& error) {
    EXPECT_NE(error.issues().front().text().find(says), std::string::npos) << error.issues().front().text();
  }
}

TEST(OutflowProfile, RefusesWhatIsNone) {
  const double nan = std::nan("");
  const std::vector<double> four{0, 0.3, 0.6, 1};
  expect_refused({0, 0.5, 1}, {1, 1, 1}, "too few");
  expect_refused(four, {1, 1, 1}, "differ in length");
  expect_refused(four, {1, nan, 1, 1}, "not a finite number");
  expect_refused({0, 0.6, 0.3, 1}, {1, 1, 1, 1}, "increase strictly");
  expect_refused({0.1, 0.3, 0.6, 1}, {1, 1, 1, 1}, "from the axis to the rim");
  expect_refused({0, 0.3, 0.6, 0.9}, {1, 1, 1, 1}, "from the axis to the rim");
  expect_refused(four, {-1, -1, -1, -1}, "into the balloon");
  expect_refused(four, {0, 0, 0, 0}, "cannot be normalised");
  EXPECT_THROW((void)OutflowProfile::polynomial({1, 0, -2}), InvalidInput);  // carries nothing
  EXPECT_THROW((void)OutflowProfile::polynomial({}), InvalidInput);
  EXPECT_THROW((void)OutflowProfile::function([](double y) { return 2 + std::sin(1e6 * y); }), InvalidInput);
  EXPECT_THROW((void)OutflowProfile::polynomial({std::numeric_limits<double>::infinity()}), InvalidInput);
}

}  // namespace
}  // namespace turgor
