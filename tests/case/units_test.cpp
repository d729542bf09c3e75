#include "turgor/case/units.hpp"

#include <gtest/gtest.h>

#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

TEST(Units, ReadWhatPeopleWrite) {
  EXPECT_DOUBLE_EQ(parse_quantity("30 cm", "m"), 0.3);
  EXPECT_DOUBLE_EQ(parse_quantity("30cm", "m"), 0.3);
  EXPECT_DOUBLE_EQ(parse_quantity("  +1.5e0   MPa ", "Pa"), 1.5e6);
  EXPECT_DOUBLE_EQ(parse_quantity("8.94e-4 Pa s", "Pa s"), 8.94e-4);
  EXPECT_DOUBLE_EQ(parse_quantity("1 g/cm^3", "kg/m^3"), 1000);
  EXPECT_DOUBLE_EQ(parse_quantity("-2 1/min", "1/s"), -1.0 / 30);
  EXPECT_DOUBLE_EQ(parse_quantity("0 cm", "m"), 0);
  // Definitions: 1 mmHg = 133.322387415 Pa, 1 psi = 6894.757293168 Pa, 1 cmH2O = 98.0665 Pa (NIST SP 811, appendix B).
  EXPECT_NEAR(parse_quantity("1 mmHg", "Pa"), 133.322387415, 1e-3);
  EXPECT_NEAR(parse_quantity("1 psi", "Pa"), 6894.757293168, 1e-6);
  EXPECT_NEAR(parse_quantity("1 cmH2O", "Pa"), 98.0665, 1e-4);
  EXPECT_DOUBLE_EQ(parse_quantity("1 mL", "m^3"), 1e-6);
  EXPECT_NEAR(parse_quantity("180 degrees", "rad"), 3.14159265358979, 1e-14);
}

TEST(Units, WhatIsWrittenInSiReadsBackToTheBit) {
  for (const double value : {0.1, 1.0 / 3, 36000.0, 8.94e-4, 6.02214076e23}) {
    char text[64];
    std::snprintf(text, sizeof text, "%.17g Pa", value);
    EXPECT_EQ(parse_quantity(text, "Pa"), value);
  }
}

TEST(Units, RefuseWhatIsNoQuantity) {
  for (const char* text : {"", "cm", "30", "30 ", "30 bananas", "30 kPa", "nan m", "inf m", "1e999 m", "3 1/m",
                           "3,5 cm", "3 degC", "--3 m"}) {
    EXPECT_THROW((void)parse_quantity(text, "m"), InvalidInput) << text;
  }
  EXPECT_THROW((void)parse_quantity("3 s", "Hz"), InvalidInput);  // reciprocal units convert in UDUNITS
  for (const char* text :
       {"60 rpm", "360 degrees/s", "1 rad/s"}) {  // radians count as 1 there, which would be 2 pi off
    EXPECT_THROW((void)parse_quantity(text, "Hz"), InvalidInput) << text;
  }
}

}  // namespace
}  // namespace turgor
