// Closure::calibrated against the finite elements that it is fitted to.

#include "turgor/closure/calibration.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../support/balloons.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

/// A row of verification/calibrated-closure/data.csv: a force in units of rho r^4 r''/r_ch or rho r^6 r'^2/r_ch^4.
struct Datum {
  bool inertial;
  bool channel;
  double kappa, value, least, greatest, refinement;
};

std::vector<Datum> data() {
  std::ifstream file(TURGOR_CALIBRATION_DATA);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "coefficient,orifice_mm,channel_mm,kappa,value,least,greatest,refinement,step,unknowns");
  std::vector<Datum> rows;
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    const auto number = [&](std::size_t i) { return std::stod(cells.at(i)); };
    rows.push_back({cells.at(0) == "inertial", number(2) > 0, number(3), number(4), number(5), number(6), number(7)});
  }
  return rows;
}

/// The same number by a closure: one term of its force on a balloon with that opening. The channel's own terms are not
/// among them.
double by(Closure closure, const Datum& d) {
  const double a = d.inertial ? -1 : 0;
  const double v = d.inertial ? 0 : -1;
  const FlowState<double> s{1, v, a, 0, d.kappa, d.channel ? 1.0 : 0.0, 1};
  const ForceParts<double> parts = force_parts(closure, Regime::deflating, s);
  return parts.balloon_inertial * d.kappa + parts.balloon_centripetal * std::pow(d.kappa, 4);
}

double error(Closure closure, const Datum& d) { return std::abs(by(closure, d) / d.value - 1); }

// The band is that of the default mesh and finer ones. With a channel it holds the flow at every instant;
// means in time, over eleven of them, lie closer.
TEST(Calibration, IsWithinItsBandsOfTheFiniteElements) {
  int inertial = 0, jets = 0, channels = 0;
  for (const Datum& d : data()) {
    const CalibrationBand band = calibration_band(d.channel);
    const double allowed = d.inertial ? band.inertial : band.centripetal;
    if (d.inertial && d.refinement < 2) continue;  // the error of the inertia is of first order in the mesh
    EXPECT_LT(error(Closure::calibrated, d), d.channel ? 0.03 : allowed) << d.kappa;
    for (const double instant : {d.least, d.greatest}) {
      EXPECT_NEAR(by(Closure::calibrated, d) / instant, 1, allowed) << d.kappa;
    }
    ++(d.inertial ? inertial : d.channel ? channels : jets);
  }
  EXPECT_GE(inertial, 4);
  EXPECT_GE(jets, 8);
  EXPECT_GE(channels, 3);
}

TEST(Calibration, IsBetterThanTheConstantsOfThePaper) {
  for (const Datum& d : data()) {
    const double ours = error(Closure::calibrated, d);
    if (d.channel) {
      EXPECT_LT(2 * ours, error(Closure::corrected, d)) << d.kappa;
    } else {
      EXPECT_LT(20 * ours, error(Closure::corrected, d)) << d.kappa;
    }
  }
}

// A finer mesh brings the finite elements nearer to the theory of the inertia.
TEST(Calibration, InertiaIsTheLimitOfFineMeshes) {
  for (const Datum& coarse : data()) {
    for (const Datum& fine : data()) {
      if (!coarse.inertial || !fine.inertial || coarse.kappa != fine.kappa || coarse.refinement >= fine.refinement) {
        continue;
      }
      EXPECT_LT(error(Closure::calibrated, fine), 0.75 * error(Closure::calibrated, coarse)) << fine.kappa;
    }
  }
}

// Central differences over h kappa err by h^2/6 kappa^2 of the third derivative of kappa ln kappa, below h^2.
TEST(Calibration, TableHasTheFitsAndTheirSlopes) {
  constexpr double h = 1e-5;
  for (const bool channel : {false, true}) {
    for (const double kappa : {0x1p-17, 1e-4, 0.013, 0.06, 0.1, 0.3, 0.7499}) {
      const auto at = calibrated_force_table(channel).at(kappa);
      EXPECT_NEAR(at.inertial, calibrated_inertial(kappa), 1e-14);
      EXPECT_NEAR(at.centripetal, calibrated_centripetal(kappa, channel), 1e-14);
      const double up = kappa * (1 + h);
      const double down = kappa * (1 - h);
      EXPECT_NEAR(at.inertial_slope * (up - down), calibrated_inertial(up) - calibrated_inertial(down), 1e-14);
      EXPECT_NEAR(at.centripetal_slope * (up - down),
                  calibrated_centripetal(up, channel) - calibrated_centripetal(down, channel), 1e-14);
    }
  }
}

// What the fits must keep beyond their range: masses that grow with the balloon, and a jet that presses.
TEST(Calibration, GoesOnBeyondItsRange) {
  double mass = std::numeric_limits<double>::infinity();
  double jet = mass;
  for (double kappa = ForceTable::least_kappa; kappa <= ForceTable::greatest_kappa; kappa *= 1.01) {
    for (const bool channel : {false, true}) EXPECT_GT(calibrated_centripetal(kappa, channel), 1);
    EXPECT_GT(calibrated_inertial(kappa), 0.7);
    EXPECT_LT(calibrated_inertial(kappa) / kappa, mass);
    EXPECT_LE(calibrated_centripetal(kappa, false), jet);
    mass = calibrated_inertial(kappa) / kappa;
    jet = calibrated_centripetal(kappa, false);
  }
  EXPECT_NEAR(calibrated_inertial(1e-12), std::numbers::pi / 4, 1e-11);
}

TEST(Calibration, GoesByTheChannel) {
  const auto table = [](double channel) {
    return force_table(test::with_closure(test::paper_balloon<double>(0.02, channel), Closure::calibrated));
  };
  EXPECT_EQ(table(0), &calibrated_force_table(false));
  EXPECT_EQ(table(0.5), &calibrated_force_table(true));
  EXPECT_NE(table(0), table(0.5));
  EXPECT_NE(table(0)->at(0.03).centripetal, table(0.5)->at(0.03).centripetal);
}

TEST(Calibration, HasTheStaticsOfThePotentialFlow) {
  const auto balloon = [](Closure closure) {
    return test::with_closure(test::paper_balloon<double>(0.06, 0.0), closure);
  };
  const auto exact = equilibria(balloon(Closure::potential), 20e3);
  const auto ours = equilibria(balloon(Closure::calibrated), 20e3);
  ASSERT_FALSE(exact.empty());
  ASSERT_EQ(ours.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_EQ(ours[i].stretch, exact[i].stretch);
}

TEST(Calibration, RefusesABalloonBeyondItsTable) {
  const auto p = test::with_closure(test::paper_balloon<double>(0.3 * 0.76, 0.0), Closure::calibrated);
  try {
    static_cast<void>(force_table(p));
    FAIL() << "expected InvalidInput";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.issues().front().key, "inlet.orifice_radius");
    EXPECT_NE(std::string(error.what()).find("calibrated"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace turgor
