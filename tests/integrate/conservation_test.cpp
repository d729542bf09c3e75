// What the equations conserve, or can only lose: tests that know nothing of how a trajectory was computed.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "../support/balloons.hpp"
#include "../support/seed.hpp"
#include "turgor/integrate/simulate.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

using test::paper_balloon;
using test::si_scales;

SimulationOptions<double> at_tolerance(double tolerance) {
  SimulationOptions<double> options;
  options.rtol = options.atol = tolerance;
  return options;
}

/// Half of Phi(R) - Phi(1) = 2 int F with F = E - a P, from the energy and the volume.
double potential(const Oscillator<double>& oscillator, double R, double P) {
  return oscillator.elastic_energy(R) - P * (R * R * R - 1) / 3;
}

struct InflatingCase {
  Model model;
  double orifice_radius;
  double channel_length;
  double pressure;
  double start;
};

// For constant P inflation conserves w + C3 Phi (2.23), R^4 w + C1~ Phi (2.25), (a0 + b R^4) w + K Phi (2.22), with
// w = (dR/dT)^2: all three are M_+ w/2 + Phi/2. The paper says that no such integral exists for the latter two.
TEST(FirstIntegral, IsConservedWhileInflating) {
  const std::vector<InflatingCase> cases{
      {Model::orifice, 0.03, 0.0, 41e3, 1.0},      {Model::orifice, 0.01, 0.0, 50e3, 1.1},
      {Model::long_channel, 0.03, 0.5, 41e3, 1.0}, {Model::long_channel, 0.01, 0.5, 50e3, 1.1},
      {Model::full, 0.03, 0.5, 41e3, 1.0},         {Model::full, 0.02, 0.1, 46e3, 1.4},
      {Model::full, 0.015, 0.0, 30e3, 1.0},
  };
  for (const auto& c : cases) {
    const auto p = paper_balloon<double>(c.orifice_radius, c.channel_length);
    const auto scales = natural_scales(p, constant_pressure(c.pressure), 1.0);
    const Oscillator<double> oscillator(c.model, p, constant_pressure(c.pressure), scales);
    const double P = c.pressure / scales.pressure;
    auto options = at_tolerance(1e-10);
    options.max_events = 1;
    const auto trajectory = simulate(oscillator, 0.0, c.start, 0.0, 1e4, options);
    ASSERT_EQ(trajectory.outcome, Outcome::max_events);
    double scale = 0;
    double worst = 0;
    for (const auto& step : trajectory.steps) {
      const double R = step.stretch_at(0);
      const double v = step.rate_at(0);
      const double kinetic = oscillator.coefficients(Regime::inflating, R).mass * v * v / 2;
      const double released = potential(oscillator, R, P) - potential(oscillator, c.start, P);
      scale = std::max(scale, kinetic);
      worst = std::max(worst, std::abs(kinetic + released));
    }
    EXPECT_LT(worst, 1e-9 * scale) << name_of(c.model) << " r_ch = " << c.orifice_radius
                                   << " L_ch = " << c.channel_length;
  }
}

// Deflating from rest at R_i, (2.23) and (2.25): w(R) = 2 C1 int_R^{R_i} G(s) exp(-(2/3) C2 (s^3 - R^3)) ds with
// G = (E - a P)/R^4, by quadrature in pieces since the kernel is 1/(2 C2 R^2) wide.
TEST(FirstIntegral, GivesTheRateWhileDeflating) {
  for (const Model model : {Model::orifice, Model::long_channel}) {
    for (const double start : {1.3, 2.5, 5.2}) {
      const auto p = paper_balloon<double>(0.03, model == Model::orifice ? 0.0 : 0.5);
      const double pressure = 30e3;  // below the lower limit point: everything above R = 1.13 deflates
      const auto scales = natural_scales(p, constant_pressure(pressure), 1.0);
      const Oscillator<double> oscillator(model, p, constant_pressure(pressure), scales);
      const double P = pressure / scales.pressure;
      const auto& g = oscillator.dimensionless_groups();
      const double C1 = model == Model::orifice ? g.C1 : g.C1_long;
      const double C2 = model == Model::orifice ? g.C2 : g.C2_long;
      auto options = at_tolerance(1e-10);
      options.atol = 1e-15;  // the slow manifold's rates are small
      options.max_events = 1;
      const auto trajectory = simulate(oscillator, 0.0, start, 0.0, 1e5, options);
      ASSERT_EQ(trajectory.outcome, Outcome::max_events);
      double largest = 0;
      for (const auto& step : trajectory.steps) largest = std::max(largest, std::abs(step.rate_at(0)));
      for (std::size_t i = 1; i < trajectory.steps.size(); i += 7) {
        const double R = trajectory.steps[i].stretch_at(0);
        const auto integrand = [&](double s) {
          const double G = -oscillator.force_at_rest(s, P) / std::pow(s, 4);
          return G * std::exp(-2 * C2 / 3 * (s * s * s - R * R * R));
        };
        double integral = 0;
        const double width = 1 / (2 * C2 * R * R);
        for (double from = R; from < start && from < R + 50 * width; from += width) {
          integral += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, from,
                                                                                    std::min(from + width, start), 0);
        }
        // sqrt(w) to 1e-9 of the largest rate, ten times the tolerance
        EXPECT_NEAR(-trajectory.steps[i].rate_at(0), std::sqrt(std::max(0.0, 2 * C1 * integral)), 1e-9 * largest)
            << name_of(model) << " from " << start << " at R = " << R;
      }
    }
  }
}

// Deflating from rest by (2.22): (mu w)' = -2 K F mu/N with N = a0 + (b + m) R^4, c^4 = a0/(b + m) and
// mu = N^(b/(b+m)) exp(-(2n/(b+m)) [R^3/3 - c^4 J]), J' = R^2/(R^4 + c^4). Only ratios mu(s)/mu(R) are needed.
TEST(FirstIntegral, GivesTheRateOfTheFullModelWhileDeflating) {
  using boost::math::quadrature::gauss_kronrod;
  for (const double channel_length : {0.0, 0.05, 0.5}) {
    const auto p = paper_balloon<double>(0.03, channel_length);
    const double pressure = 30e3;  // below the lower limit point
    const double start = 1.5;
    const auto scales = natural_scales(p, constant_pressure(pressure), 1.0);
    const Oscillator<double> oscillator(Model::full, p, constant_pressure(pressure), scales);
    const double P = pressure / scales.pressure;
    const auto& g = oscillator.dimensionless_groups();
    const double liquid = g.b + g.m;
    const double c4 = g.a0 / liquid;
    auto options = at_tolerance(1e-10);
    options.atol = 1e-15;
    options.max_events = 1;
    const auto trajectory = simulate(oscillator, 0.0, start, 0.0, 1e5, options);
    ASSERT_EQ(trajectory.outcome, Outcome::max_events);
    double largest = 0;
    for (const auto& step : trajectory.steps) largest = std::max(largest, std::abs(step.rate_at(0)));
    const auto N = [&](double x) { return g.a0 + liquid * std::pow(x, 4); };
    for (std::size_t i = 1; i < trajectory.steps.size(); i += 5) {
      const double R = trajectory.steps[i].stretch_at(0);
      const auto integrand = [&](double s) {
        const double J =
            gauss_kronrod<double, 31>::integrate([&](double x) { return x * x / (std::pow(x, 4) + c4); }, R, s, 0);
        const double exponent = (s * s * s - R * R * R) / 3 - c4 * J;
        const double mu_ratio = std::pow(N(s) / N(R), g.b / liquid) * std::exp(-2 * g.n / liquid * exponent);
        return -2 * g.K * oscillator.force_at_rest(s, P) / N(s) * mu_ratio;
      };
      double w = 0;
      const double width = liquid / (2 * g.n * R * R);  // of the exponential
      for (double from = R; from < start && from < R + 50 * width; from += width) {
        w += gauss_kronrod<double, 31>::integrate(integrand, from, std::min(from + width, start), 0);
      }
      EXPECT_NEAR(-trajectory.steps[i].rate_at(0), std::sqrt(std::max(0.0, w)), 1e-9 * largest)
          << "L_ch = " << channel_length << " at R = " << R;
    }
  }
}

/// A balloon within wide but sensible limits, with a random material of the catalogue's kinds.
Parameters<double> random_balloon(std::mt19937_64& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto log_between = [&](double a, double b) { return std::exp(between(std::log(a), std::log(b))); };
  Parameters<double> p;
  p.radius = log_between(0.005, 1);
  p.thickness = p.radius * log_between(1e-3, 5e-2);
  p.solid_density = between(500, 3000);
  p.fluid_density = between(500, 3000);
  p.fluid_viscosity = 1e-3;
  p.orifice_radius = p.radius * log_between(1.0 / 100, 1.0 / 5);
  p.channel_length = between(0, 1) < 0.3 ? 0 : p.orifice_radius * log_between(0.1, 100);
  p.closure = between(0, 1) < 0.5 ? Closure::theoretical : Closure::corrected;
  const double mu = log_between(1e4, 1e7);
  switch (std::uniform_int_distribution<int>(0, 4)(random)) {
    case 0: p.material = MooneyRivlin<double>{mu, mu * between(0.02, 0.4)}; break;
    case 1: p.material = Gent<double>{mu, between(5, 100)}; break;
    case 2: p.material = Fung<double>{mu, between(0.01, 1)}; break;
    case 3: p.material = Ogden<double>{{mu, mu * 1e-3, -mu * 0.02}, {1.3, 5.0, -2.0}}; break;
    default: p.material = ArrudaBoyce<double>{mu, between(2, 6)}; break;
  }
  return p;
}

// Under constant pressure M_s v^2/2 + Phi/2 of (2.22) stays constant while inflating and only falls while deflating.
// The slack is the integration's own error at rtol 1e-9, a hundred tolerances of the energies involved.
TEST(Energy, NeverGrowsWhileDeflatingForAThousandRandomBalloons) {
  const std::uint64_t seed = test::random_seed();
  std::mt19937_64 random(seed);
  long checked = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto p = random_balloon(random);
    const double stiffness = p.thickness * strain_energy(p.material, 1.0).second / p.radius;
    const double pressure = stiffness * std::uniform_real_distribution<double>(-0.02, 0.15)(random);
    const double largest = std::min(4.0, 0.9 * stretch_limit(p.material));
    const double start = std::uniform_real_distribution<double>(1.05, std::max(1.06, largest))(random);
    const auto scales = natural_scales(p, constant_pressure(pressure), 1.0);
    const Oscillator<double> oscillator(Model::full, p, constant_pressure(pressure), scales);
    const double P = pressure / scales.pressure;
    auto options = at_tolerance(1e-9);
    options.max_events = 6;
    options.max_steps = 20000;
    const auto trajectory = simulate(oscillator, 0.0, start, 0.0, 1e4, options);
    const auto energy = [&](const TrajectoryStep<double>& step, double theta) {
      const double R = step.stretch_at(theta);
      const double v = step.rate_at(theta);
      return oscillator.coefficients(step.regime, R).mass * v * v / 2 + potential(oscillator, R, P);
    };
    double span = 0;
    for (const auto& step : trajectory.steps) {
      span = std::max({span, std::abs(energy(step, 0)), oscillator.elastic_energy(step.stretch_at(0))});
    }
    for (const auto& step : trajectory.steps) {
      if (step.regime != Regime::deflating) continue;
      ++checked;
      ASSERT_LE(energy(step, 1), energy(step, 0) + 1e-7 * span)
          << "balloon " << i << " of seed " << seed << " at T = " << step.start;
    }
  }
  EXPECT_GT(checked, 20000);
}

// (2.22) turns into (2.25) as 1 << L/r_ch << eps^(-3/2). With r_ch = h^2 r0 and L = h r0 the only term that inflation
// drops is the wall's inertia, a0/b = O(h^3). Deflation drops m/b = O(h), but the inertia itself only matters like
// 1/C2~ = b/n = O(h^5) there, so that the difference is m/n = O(h^6).
TEST(Limit, FullModelBecomesTheLongChannel) {
  const auto difference = [](double h, double start) {
    const auto p = paper_balloon<double>(0.3 * h * h, 0.3 * h);
    const auto program = constant_pressure(30e3);
    const auto scales = natural_scales(p, program, 1.0);
    const auto at_end = [&](Model model) {
      const Oscillator<double> oscillator(model, p, program, scales);
      return simulate(oscillator, 0.0, start, 0.0, 3.0, at_tolerance(1e-13)).at(3.0).stretch;
    };
    return std::abs(at_end(Model::full) - at_end(Model::long_channel));
  };
  const double coarse = difference(0.08, 1.0);
  const double fine = difference(0.04, 1.0);
  EXPECT_GT(fine, 1e-9);  // far above the integration's error
  EXPECT_NEAR(std::log2(coarse / fine), 3.0, 0.2);
  EXPECT_NEAR(std::log2(difference(0.08, 1.4) / difference(0.04, 1.4)), 6.0, 0.2);
}

}  // namespace
}  // namespace turgor
