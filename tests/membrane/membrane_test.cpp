#include "turgor/membrane/membrane.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <functional>
#include <numbers>

#include "samples.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

/// Derivative of a vector function by central differences of fourth order; h in parts of the unit.
MatrixXd differences(const std::function<VectorXd(const VectorXd&)>& f, const VectorXd& x, double h) {
  MatrixXd out(f(x).size(), x.size());
  for (Index i = 0; i < x.size(); ++i) {
    const VectorXd unit = VectorXd::Unit(x.size(), i) * h;
    out.col(i) = (8 * (f(x + unit) - f(x - unit)) - (f(x + 2 * unit) - f(x - 2 * unit))) / (12 * h);
  }
  return out;
}

struct Sample {
  const char* name;
  double rim_radius;
  Material<double> material;
  double bending;
  Rim rim;
  bool reversed;
};

Membrane build(const Sample& sample, std::size_t elements = 5) {
  MembraneWall wall = sample_wall();
  wall.material = sample.material;
  wall.bending_stiffness = sample.bending;
  wall.rim = sample.rim;
  wall.damping_time = 0.01;
  Meridian meridian = spherical_meridian(sample_radius, sample.rim_radius, elements, 1.7);
  if (sample.reversed) std::ranges::reverse(meridian.nodes);
  return {meridian, wall};
}

const std::vector<Sample> samples{
    {"hole", 0.03, MooneyRivlin<double>{1.5e6, 1.5e5}, 0, Rim::hinged, false},
    {"hinged", 0.03, MooneyRivlin<double>{1.5e6, 1.5e5}, 500, Rim::hinged, false},
    {"clamped", 0.03, MooneyRivlin<double>{1.5e6, 1.5e5}, 500, Rim::clamped, false},
    {"clamped_reversed", 0.03, MooneyRivlin<double>{1.5e6, 1.5e5}, 500, Rim::clamped, true},
    {"closed", 0, Gent<double>{1e6, 30}, 500, Rim::hinged, false},
    {"ogden", 0.05, Ogden<double>{{6.3e5, 1.2e3, -1e4}, {1.3, 5.0, -2.0}}, 500, Rim::clamped, true},
};

class EveryMembrane : public testing::TestWithParam<Sample> {
 protected:
  Membrane membrane = build(GetParam());
  VectorXd x = sample_state(membrane);
};

// With steps of 1e-4 m and features of 3 cm the formula is off by 1e-10 and rounding by 1e-12; 1e-8 of the greatest
// entry leaves room for the elements near the axis, where everything changes faster.
constexpr double step = 2e-5;
constexpr double off = 1e-7;

TEST_P(EveryMembrane, ForceIsTheGradientOfTheEnergy) {
  const MembraneForm form = membrane.elastic(x);
  const auto energy = [&](const VectorXd& y) { return VectorXd::Constant(1, membrane.elastic(y).value); };
  const VectorXd expected = differences(energy, x, step).transpose();
  // r of a node on the axis cannot change
  for (const Index i : membrane.free_unknowns()) {
    EXPECT_NEAR(form.gradient(i), expected(i), off * expected.cwiseAbs().maxCoeff()) << "unknown " << i;
  }
}

TEST_P(EveryMembrane, TangentIsTheGradientOfTheForceAndSymmetric) {
  const MatrixXd tangent = membrane.elastic(x).hessian;
  const MatrixXd expected = differences([&](const VectorXd& y) { return membrane.elastic(y).gradient; }, x, step);
  const double scale = tangent.cwiseAbs().maxCoeff();
  for (const Index i : membrane.free_unknowns()) {
    for (const Index j : membrane.free_unknowns()) EXPECT_NEAR(tangent(i, j), expected(i, j), off * scale);
  }
  EXPECT_LT((tangent - tangent.transpose()).cwiseAbs().maxCoeff(), 1e-15 * scale);
}

TEST_P(EveryMembrane, LoadAndItsTangentAreDerivativesOfTheVolume) {
  const MembraneForm form = membrane.volume(x);
  const MatrixXd tangent = form.hessian;
  const auto value = [&](const VectorXd& y) { return VectorXd::Constant(1, membrane.volume(y).value); };
  const VectorXd gradient = differences(value, x, 0.01).transpose();  // the volume is a cubic: no step is too long
  const MatrixXd hessian = differences([&](const VectorXd& y) { return membrane.volume(y).gradient; }, x, 0.01);
  EXPECT_LT((form.gradient - gradient).cwiseAbs().maxCoeff(), 1e-12 * gradient.cwiseAbs().maxCoeff());
  EXPECT_LT((tangent - hessian).cwiseAbs().maxCoeff(), 1e-12 * hessian.cwiseAbs().maxCoeff());
}

TEST_P(EveryMembrane, DampingHasItsDerivatives) {
  VectorXd velocity = VectorXd::Zero(x.size());
  for (const Index i : membrane.free_unknowns()) velocity(i) = std::sin(3.0 * static_cast<double>(i) + 1);
  const MembraneDamping damping = membrane.damping(x, velocity);
  const double force = damping.force.cwiseAbs().maxCoeff();
  EXPECT_LT((damping.by_velocity * velocity - damping.force).cwiseAbs().maxCoeff(), 1e-13 * force);
  const MatrixXd by_place = damping.by_place;
  const MatrixXd expected =
      differences([&](const VectorXd& y) { return membrane.damping(y, velocity).force; }, x, step);
  for (const Index i : membrane.free_unknowns()) {
    for (const Index j : membrane.free_unknowns()) {
      EXPECT_NEAR(by_place(i, j), expected(i, j), off * by_place.cwiseAbs().maxCoeff());
    }
  }
}

TEST_P(EveryMembrane, ARigidMotionCostsNothing) {
  const VectorXd shifted = moved(membrane, [](double r, double z) { return std::pair(r, z + 0.4); });
  const VectorXd along = shifted - membrane.reference();
  // places have 16 digits: strains of 1e-15, curvatures of 1e-13, which the energy squares
  const double stiffness = 1e6 * 3e-3 * 0.09;
  EXPECT_NEAR(membrane.elastic(membrane.reference()).value, 0, 1e-26 * stiffness);
  EXPECT_NEAR(membrane.elastic(shifted).value, 0, 1e-24 * stiffness);
  EXPECT_LT(membrane.elastic(shifted).gradient.cwiseAbs().maxCoeff(), 1e-10 * stiffness);
  EXPECT_LT(membrane.damping(x, along).force.cwiseAbs().maxCoeff(), 1e-12 * stiffness);
  if (GetParam().rim == Rim::hinged) {
    // a deformed membrane may be shifted too: no force along the shift
    EXPECT_NEAR(membrane.elastic(x).gradient.dot(along), 0, 1e-12 * membrane.elastic(x).gradient.cwiseAbs().maxCoeff());
  }
}

TEST_P(EveryMembrane, TheOrderOfNodesDoesNotMatter) {
  Sample other = GetParam();
  other.reversed = !other.reversed;
  const Membrane turned = build(other);
  VectorXd y(x.size());
  for (Index i = 0; i < x.size(); i += 2) y.segment<2>(x.size() - 2 - i) = x.segment<2>(i);
  EXPECT_NEAR(turned.elastic(y).value / membrane.elastic(x).value, 1, 1e-13);
  EXPECT_NEAR(turned.volume(y).value / membrane.volume(x).value, 1, 1e-13);
  EXPECT_GT(membrane.volume(x).value, 0);
}

INSTANTIATE_TEST_SUITE_P(Membranes, EveryMembrane, testing::ValuesIn(samples),
                         [](const auto& test) { return std::string(test.param.name); });

// The part of the sphere above the rim: area 2 pi r0 h, volume pi h^2 (3 r0 - h)/3. A quadratic chain is off by the
// fourth power of its elements' lengths.
TEST(Membrane, HasAreaVolumeAndMassOfTheCap) {
  const double a = 0.03;
  const double height = sample_radius + std::sqrt(sample_radius * sample_radius - a * a);
  std::vector<double> area;
  std::vector<double> volume;
  for (const std::size_t elements : {4U, 8U, 16U}) {
    const Membrane membrane(spherical_meridian(sample_radius, a, elements), sample_wall());
    const VectorXd& x = membrane.reference();
    area.push_back(std::abs(membrane.area(x) / (sample_radius * height) - 1));
    volume.push_back(std::abs(membrane.volume(x).value / (height * height * (3 * sample_radius - height) / 6) - 1));
    VectorXd lifted = VectorXd::Zero(x.size());
    for (Index i = 1; i < x.size(); i += 2) lifted(i) = 1;
    EXPECT_NEAR(lifted.dot(membrane.mass() * lifted), 1000 * 3e-3 * membrane.area(x), 1e-14);
  }
  EXPECT_LT(area.back(), 1e-5);
  EXPECT_LT(volume.back(), 1e-5);
  EXPECT_NEAR(observed_order(area), 4, 0.2);
  EXPECT_NEAR(observed_order(volume), 4, 0.2);
}

// A sphere blown up uniformly: d0 W(l, l) and k1 = k2 = (1/l - 1)/r0 everywhere, exact area.
TEST(Membrane, HasTheEnergyOfASphereBlownUp) {
  const double l = 1.7;
  MembraneWall wall = sample_wall();
  const double strain = wall.thickness * strain_energy(wall.material, l).value * 2 * sample_radius * sample_radius;
  const double bending = 3 * 500.0 * (1 - 1 / l) * (1 - 1 / l);
  std::vector<double> strain_errors;
  std::vector<double> bending_errors;
  for (const std::size_t elements : {8U, 16U, 32U}) {
    const Membrane slack(spherical_meridian(sample_radius, 0, elements), wall);
    wall.bending_stiffness = 500;
    const Membrane stiff(spherical_meridian(sample_radius, 0, elements), wall);
    wall.bending_stiffness = 0;
    const VectorXd x = l * slack.reference();
    const double energy = slack.elastic(x).value;
    strain_errors.push_back(std::abs(energy / strain - 1));
    bending_errors.push_back(std::abs((stiff.elastic(x).value - energy) / bending - 1));
  }
  EXPECT_LT(strain_errors.back(), 1e-6);
  EXPECT_NEAR(observed_order(strain_errors), 4, 0.1);
  EXPECT_LT(bending_errors.back(), 1e-6);
  EXPECT_GT(observed_order(bending_errors), 3.7);
}

// A sphere made into a spheroid of half axes a (radial) and c: its curvatures are those of textbooks.
TEST(Membrane, HasTheBendingEnergyOfASpheroid) {
  const double a = 0.33;
  const double c = 0.42;
  const auto density = [&](double angle) {
    const double g = std::hypot(a * std::cos(angle), c * std::sin(angle));
    const double k1 = a * c / (g * g * g) - 1 / sample_radius;
    const double k2 = c / (a * g) - 1 / sample_radius;
    return 250 * (k1 * k1 + k1 * k2 + k2 * k2) * sample_radius * sample_radius * std::sin(angle);
  };
  const double exact = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(density, 0, pi, 10, 1e-13);
  std::vector<double> errors;
  for (const std::size_t elements : {16U, 32U, 64U}) {
    MembraneWall wall = sample_wall();
    const Membrane slack(spherical_meridian(sample_radius, 0, elements), wall);
    wall.bending_stiffness = 500;
    const Membrane stiff(spherical_meridian(sample_radius, 0, elements), wall);
    const VectorXd x = moved(slack, [&](double r, double z) {
      return std::pair(r * a / sample_radius, (z - sample_radius) * c / sample_radius);
    });
    errors.push_back(std::abs((stiff.elastic(x).value - slack.elastic(x).value) / exact - 1));
  }
  EXPECT_LT(errors.back(), 1e-7);
  EXPECT_GT(observed_order(errors), 3.9);
}

// A flat disc under a small uniform pressure is Kirchhoff's circular plate: the middle gives way by p a^4/(64 D) when
// clamped, and (5 + nu)/(1 + nu) = 11/3 times as much when hinged (Timoshenko & Woinowsky-Krieger, section 16).
TEST(Membrane, BendsAsACircularPlate) {
  const double a = 0.2;
  for (const Rim rim : {Rim::clamped, Rim::hinged}) {
    const double exact = std::pow(a, 4) / 64 / 7.0 * (rim == Rim::clamped ? 1 : 11.0 / 3);
    std::vector<double> errors;
    for (const std::size_t elements : {8U, 16U, 32U}) {
      Meridian disc;
      for (std::size_t i = 0; i <= 2 * elements; ++i) {
        disc.nodes.push_back({a * (1 - static_cast<double>(i) / static_cast<double>(2 * elements)), 0.0});
      }
      MembraneWall wall = sample_wall();
      wall.bending_stiffness = 7;
      wall.rim = rim;
      const Membrane membrane(disc, wall);
      const auto& free = membrane.free_unknowns();
      const MatrixXd tangent = membrane.elastic(membrane.reference()).hessian;
      const VectorXd load = membrane.volume(membrane.reference()).gradient;
      const VectorXd answer = tangent(free, free).ldlt().solve(load(free));
      errors.push_back(std::abs(std::abs(answer(answer.size() - 1)) / exact - 1));
    }
    EXPECT_LT(errors.back(), 1e-3);
    EXPECT_GT(observed_order(errors), 1.85);
  }
}

// A sphere that grows at the rate l' everywhere: eta d0 W''(l) l'^2 per stress-free area, W the equal biaxial energy.
TEST(Membrane, DampingTakesThePowerOfAGrowingSphere) {
  MembraneWall wall = sample_wall();
  wall.damping_time = 0.01;
  const Membrane membrane(spherical_meridian(sample_radius, 0, 32), wall);
  const VectorXd velocity = 0.25 * membrane.reference();
  const double power = membrane.damping(1.4 * membrane.reference(), velocity).force.dot(velocity);
  const double exact =
      0.01 * 3e-3 * strain_energy(wall.material, 1.4).second * 0.25 * 0.25 * 2 * sample_radius * sample_radius;
  EXPECT_NEAR(power / exact, 1, 1e-6);  // the chain's area
}

TEST(Membrane, RefusesWhatIsNoMeridianOrWall) {
  const auto message = [](const Meridian& meridian, const MembraneWall& wall) {
    try {
      const Membrane membrane(meridian, wall);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto sphere = [] { return spherical_meridian(0.3, 0.03, 3); };
  EXPECT_EQ(message(sphere(), sample_wall()), "accepted");
  Meridian bad = sphere();
  bad.nodes.pop_back();
  EXPECT_NE(message(bad, sample_wall()).find("6 nodes"), std::string::npos);
  bad.nodes.pop_back();
  EXPECT_NE(message(bad, sample_wall()).find("does not reach the axis"), std::string::npos);
  bad = sphere();
  bad.nodes[3][0] = -0.1;
  EXPECT_NE(message(bad, sample_wall()).find("node 3"), std::string::npos);
  bad = sphere();
  bad.nodes[2][1] = NAN;
  EXPECT_NE(message(bad, sample_wall()).find("finite"), std::string::npos);
  MembraneWall wall = sample_wall();
  wall.thickness = 0;
  EXPECT_NE(message(sphere(), wall).find("balloon.thickness"), std::string::npos);
  wall = sample_wall();
  wall.bending_stiffness = -1;
  EXPECT_NE(message(sphere(), wall).find("wall.bending_stiffness"), std::string::npos);
  wall = sample_wall();
  wall.damping_time = NAN;
  EXPECT_NE(message(sphere(), wall).find("wall.damping_time"), std::string::npos);
  EXPECT_THROW(spherical_meridian(0.3, 0.3, 3), InvalidInput);
  EXPECT_THROW(spherical_meridian(-0.3, 0, 3), InvalidInput);
  EXPECT_THROW(spherical_meridian(0.3, 0, 0), InvalidInput);
  EXPECT_THROW(spherical_meridian(0.3, 0, 3, 0), InvalidInput);
}

TEST(Membrane, SaysWhereItCannotBe) {
  MembraneWall wall = sample_wall();
  wall.material = Gent<double>{1e6, 5};
  const Membrane membrane(spherical_meridian(0.3, 0.03, 4), wall);
  const auto message = [&](const VectorXd& x) {
    try {
      (void)membrane.elastic(x);
    } catch (const ComputationFailed& error) {
      return std::string(error.what());
    }
    return std::string("computed");
  };
  EXPECT_NE(message(3 * membrane.reference()).find("locked"), std::string::npos);
  EXPECT_NE(message(-membrane.reference()).find("crossed the axis"), std::string::npos);
  EXPECT_NE(message(NAN * membrane.reference()).find("not numbers"), std::string::npos);
}

}  // namespace
}  // namespace turgor
