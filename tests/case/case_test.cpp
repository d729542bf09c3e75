#include "turgor/case/case.hpp"

#include <gtest/gtest.h>

#include "../support/program.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

std::vector<std::filesystem::path> shipped_cases() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(TURGOR_CASES)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

const std::filesystem::path paper_case = std::filesystem::path(TURGOR_CASES) / "orifice-30mm.toml";

TEST(Case, IsReadInSiUnits) {
  const Case c = read_case(paper_case);
  EXPECT_EQ(c.title, "Water balloon through a 3 cm orifice");
  EXPECT_DOUBLE_EQ(c.parameters.radius, 0.3);
  EXPECT_DOUBLE_EQ(c.parameters.thickness, 0.003);
  EXPECT_DOUBLE_EQ(std::get<MooneyRivlin<double>>(c.parameters.material).s1, 1.5e6);
  EXPECT_DOUBLE_EQ(c.parameters.fluid_viscosity, 8.94e-4);
  EXPECT_EQ(c.model, Model::orifice);
  EXPECT_EQ(c.parameters.closure, Closure::corrected);
  EXPECT_DOUBLE_EQ(c.pressure(1.0), 18e3);
  EXPECT_EQ(c.solve.atol, c.solve.rtol);  // atol defaults to rtol
  EXPECT_EQ(c.source, test::contents(paper_case));
}

TEST(Node, LongTextsAreShortenedBetweenCharacters) {
  for (std::size_t letters = 54; letters < 58; ++letters) {
    const std::string text = Node{std::string(letters, 'a') + "\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC", "", 0}.text();
    const std::string kept = text.substr(0, text.size() - 3);
    EXPECT_TRUE(text.ends_with("...")) << text;
    EXPECT_TRUE(kept.ends_with('a') || kept.ends_with("\xE2\x82\xAC")) << text;
  }
}

TEST(Case, OverridesReplaceAnyKey) {
  const Case c = read_case(
      paper_case, {"inlet.orifice_radius=2 cm", "solve.rtol=1e-6", "model.name=full", "initial.stretch = equilibrium",
                   "pressure.segments[0].to=30 kPa", "material.max_stretch=3", "title=An override"});
  EXPECT_DOUBLE_EQ(c.parameters.orifice_radius, 0.02);
  EXPECT_EQ(c.solve.rtol, 1e-6);
  EXPECT_EQ(c.solve.atol, 1e-6);
  EXPECT_EQ(c.model, Model::full);
  EXPECT_EQ(c.stretch, 1.0);
  EXPECT_DOUBLE_EQ(c.pressure(3.0), 30e3);
  EXPECT_EQ(c.max_stretch, 3);
  EXPECT_EQ(c.title, "An override");
}

TEST(Case, LowestStableEquilibriumCanBeTheStart) {
  const Case c = read_case(paper_case, {"pressure.start=20 kPa", "initial.stretch=equilibrium"});
  EXPECT_EQ(c.stretch, equilibria(c.parameters, 20e3).front().stretch);
}

// A list of segments starts at 0 Pa, ramps are straight unless they say otherwise, and the last value holds.
TEST(Case, SegmentsHaveTheirDefaults) {
  const std::string text = test::contents(paper_case);
  const Case c =
      parse_case(text, paper_case,
                 {"pressure.segments=[{ to = \"10 kPa\", over = \"2 s\" }, { step = \"4 kPa\" }, { hold = \"1 s\" }]"});
  EXPECT_DOUBLE_EQ(c.pressure(0.5), 2500);
  EXPECT_EQ(c.pressure(2.0), 4e3);
  EXPECT_EQ(c.pressure(50.0), 4e3);
}

// Without t_end a dictated motion ends with its last segment; the inlet's pressure is nulled unless it is given.
TEST(Case, DictatedMotionHasItsDefaults) {
  const std::filesystem::path file = std::filesystem::path(TURGOR_CASES) / "motion-orifice-30mm.toml";
  const Case c = read_case(file);
  ASSERT_TRUE(c.motion);
  EXPECT_EQ(c.solve.t_end, 5);
  EXPECT_EQ(c.pressure(1.0), 0);
  EXPECT_EQ(c.motion->at(0).rate, 0);
  EXPECT_EQ(c.motion->at(1.0).rate, 0.02);
  const Case other = read_case(file, {"solve.t_end=3 s", "motion.inlet_pressure=2 kPa", "motion.start=1 mm/s"});
  EXPECT_EQ(other.solve.t_end, 3);
  EXPECT_EQ(other.pressure(1.0), 2000);
  EXPECT_EQ(other.motion->at(0).rate, 0.001);
}

// The cells follow the orifice and the balloon: r_ch/60, r_ch/15, r0/37.5. A wide orifice never wants larger cells than
// the wall.
TEST(Case, FiniteElementsHaveTheirDefaults) {
  const Case c = read_case(paper_case);
  EXPECT_FALSE(c.inlet.slip);
  EXPECT_TRUE(c.inlet.tangential_free);
  EXPECT_FALSE(c.inlet.total_pressure);
  EXPECT_EQ(c.inlet.inflow_penalty, 0.5);
  EXPECT_EQ(c.fem.scheme, FemScheme::bdf2);
  EXPECT_EQ(c.fem.cfl, 0.5);
  EXPECT_EQ(c.fem.time_step, 0);
  EXPECT_DOUBLE_EQ(c.fem.h_rim, 0.5e-3);
  EXPECT_DOUBLE_EQ(c.fem.h_orifice, 2e-3);
  EXPECT_DOUBLE_EQ(c.fem.h_wall, 8e-3);
  EXPECT_EQ(c.fem.fields, 21);
  EXPECT_NE(c.resolved.find("[fem]\nscheme = \"bdf2\"\ncfl = 0.5\n"), std::string::npos) << c.resolved;
  EXPECT_EQ(c.resolved.find("time_step"), std::string::npos);
  const Case narrow = read_case(paper_case, {"inlet.orifice_radius=1 cm"});
  EXPECT_DOUBLE_EQ(narrow.fem.h_rim, 0.01 / 60);
  EXPECT_DOUBLE_EQ(narrow.fem.h_wall, 8e-3);
  const Case wide = read_case(paper_case, {"inlet.orifice_radius=25 cm"});
  EXPECT_EQ(wide.fem.h_orifice, wide.fem.h_wall);
  const Case fine = read_case(paper_case, {"fem.h_wall=0.3 mm"});
  EXPECT_EQ(fine.fem.h_orifice, 3e-4);
  EXPECT_EQ(fine.fem.h_rim, 3e-4);
}

// E d0^3/(12 (1 - nu^2)) with E = 3 * 2 (s1 + s2) = 9.9 MPa and nu = 1/2: 0.0297 N m.
TEST(Case, TheWallHasTheBendingStiffnessOfItsThickness) {
  const Case c = read_case(paper_case);
  EXPECT_NEAR(c.wall.bending_stiffness, 0.0297, 1e-15);
  EXPECT_EQ(c.wall.damping_time, 0.02);  // the case's
  EXPECT_EQ(read_case(std::filesystem::path(TURGOR_CASES) / "material-gent.toml").wall.damping_time, 0);
  EXPECT_FALSE(c.wall.clamped);
  const Case thick = read_case(paper_case, {"balloon.thickness=6 mm", "wall.bending_stiffness=auto"});
  EXPECT_NEAR(thick.wall.bending_stiffness, 8 * 0.0297, 1e-14);
  const Case other =
      read_case(paper_case, {"wall.bending_stiffness=0.1 N cm", "wall.damping_time=5 ms", "wall.rim=clamped"});
  EXPECT_DOUBLE_EQ(other.wall.bending_stiffness, 1e-3);
  EXPECT_DOUBLE_EQ(other.wall.damping_time, 0.005);
  EXPECT_TRUE(other.wall.clamped);
  EXPECT_EQ(parse_case(other.resolved, paper_case).resolved, other.resolved);
  EXPECT_EQ(read_case(paper_case, {"wall.bending_stiffness=0 N m"}).wall.bending_stiffness, 0);
}

TEST(Case, FiniteElementsAreReadInSiUnits) {
  const Case c = read_case(
      paper_case, {"inlet.wall=slip", "inlet.tangential=zero", "inlet.pressure=total", "inlet.inflow_penalty=5",
                   "fem.scheme=bdf1", "fem.time_step=10 ms", "fem.h_rim=0.25 mm", "fem.h_orifice=1 mm",
                   "fem.h_wall=1 cm", "fem.tolerance=1e-6", "fem.max_iterations=7", "fem.max_steps=99",
                   "fem.checkpoint_every=2 min", "fem.field_times=[\"0 s\", \"100 ms\"]"});
  EXPECT_TRUE(c.inlet.slip);
  EXPECT_FALSE(c.inlet.tangential_free);
  EXPECT_TRUE(c.inlet.total_pressure);
  EXPECT_EQ(c.inlet.inflow_penalty, 5);
  EXPECT_EQ(c.fem.scheme, FemScheme::bdf1);
  EXPECT_EQ(c.fem.cfl, 0);
  EXPECT_DOUBLE_EQ(c.fem.time_step, 0.01);
  EXPECT_EQ(c.fem.error_tolerance, 0);
  EXPECT_DOUBLE_EQ(c.fem.h_rim, 0.25e-3);
  EXPECT_DOUBLE_EQ(c.fem.h_orifice, 1e-3);
  EXPECT_DOUBLE_EQ(c.fem.h_wall, 0.01);
  EXPECT_EQ(c.fem.tolerance, 1e-6);
  EXPECT_EQ(c.fem.max_iterations, 7);
  EXPECT_EQ(c.fem.max_steps, 99);
  EXPECT_EQ(c.fem.checkpoint_every, 120);
  EXPECT_EQ(c.fem.fields, 0);
  EXPECT_EQ(c.fem.field_times, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(parse_case(c.resolved, paper_case).resolved, c.resolved);
  EXPECT_EQ(read_case(paper_case, {"fem.cfl=2", "fem.error_tolerance=1e-3"}).fem.error_tolerance, 1e-3);
}

// Figure 3: up by 3 cm over the 3 cm orifice, 4 mm over the 2 cm one, and in proportion to the times over the others;
// then back to where it was, to the last digit.
TEST(Case, ShippedMotionsReturn) {
  for (const std::string inlet : {"orifice", "channel"}) {
    for (const auto& [size, way] : {std::pair{30, 0.03}, {20, 4e-3}, {10, 4e-3 / 8}, {5, 4e-3 / 64}}) {
      const Case c =
          read_case(std::filesystem::path(TURGOR_CASES) / ("motion-" + inlet + "-" + std::to_string(size) + "mm.toml"));
      ASSERT_TRUE(c.motion);
      EXPECT_DOUBLE_EQ(c.parameters.orifice_radius, size / 1e3);
      EXPECT_EQ(c.parameters.channel_length, inlet == "channel" ? 0.5 : 0);
      EXPECT_EQ(c.motion->at(0).radius, 0.3);
      EXPECT_EQ(c.motion->at(c.solve.t_end).radius, 0.3);
      EXPECT_NEAR(range_of(*c.motion, c.solve.t_end).greatest - 0.3, way, 1e-16);  // an ulp of 0.3
      EXPECT_EQ(range_of(*c.motion, c.solve.t_end).least, 0.3);
    }
  }
}

class ShippedCase : public testing::TestWithParam<std::filesystem::path> {};

// The resolved case is complete and means the same to the last bit, also from another folder.
TEST_P(ShippedCase, ResolvesToItself) {
  const Case c = read_case(GetParam());
  const Case again = parse_case(c.resolved, "/elsewhere/case.toml");
  EXPECT_EQ(again.resolved, c.resolved);
  EXPECT_EQ(again.stretch, c.stretch);
  EXPECT_EQ(again.scales.time, c.scales.time);
  for (double t = 0; t < c.solve.t_end; t += c.solve.t_end / 37) EXPECT_EQ(again.pressure(t), c.pressure(t));
  ASSERT_EQ(again.motion.has_value(), c.motion.has_value());
  for (double t = 0; c.motion && t < c.solve.t_end; t += c.solve.t_end / 37) {
    EXPECT_EQ(again.motion->at(t).radius, c.motion->at(t).radius);
  }
  EXPECT_FALSE(c.title.empty());
}

INSTANTIATE_TEST_SUITE_P(All, ShippedCase, testing::ValuesIn(shipped_cases()), [](const auto& test) {
  std::string name = test.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// One case for each material, so that each runs from file to picture.
TEST(ShippedCases, CoverEveryMaterial) {
  for (const auto& entry : catalogue()) {
    bool found = false;
    for (const auto& file : shipped_cases()) found = found || read_case(file).material_name == entry.name;
    EXPECT_TRUE(found) << "no case for " << entry.name;
  }
}

TEST(Schema, EveryKeyExplainsItself) {
  for (const Key& key : case_schema().keys()) {
    EXPECT_FALSE(key.meaning.empty()) << key.path;
    EXPECT_FALSE(key.required && !key.fallback.empty()) << key.path << " is required and has a default";
  }
}

TEST(Schema, SuggestsTheNearestKey) {
  const Schema& schema = case_schema();
  EXPECT_EQ(schema.nearest("inlet.radius", "gent"), "inlet.orifice_radius");
  EXPECT_EQ(schema.nearest("solve.tend", "gent"), "solve.t_end");
  EXPECT_EQ(schema.nearest("material.jn", "gent"), "material.jm");
  EXPECT_EQ(schema.nearest("balloon.colour_of_the_ribbon", "gent"), "");
}

}  // namespace
}  // namespace turgor
