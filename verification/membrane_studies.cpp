// Errors of the membrane at rest on series of chains and holes, as a table of comma-separated values.

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <numbers>
#include <string>

#include "membrane/samples.hpp"
#include "membrane/shooting.hpp"
#include "membrane/sphere_modes.hpp"
#include "turgor/base/text.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {
namespace {

/// A row of the table; rows of one panel and quantity are a series.
void print(const std::string& panel, const std::string& quantity, double x, double value) {
  std::printf("%s,%s,%.12g,%.12g\n", panel.c_str(), quantity.c_str(), x, value);
}

double size_of(std::size_t elements) { return 1 / static_cast<double>(elements); }

double volume_at(double stretch) { return 4 * std::numbers::pi / 3 * std::pow(stretch * sample_radius, 3); }

Parameters<double> sphere() {
  Parameters<double> p{};
  p.radius = sample_radius;
  p.thickness = sample_wall().thickness;
  p.material = sample_wall().material;
  return p;
}

Membrane chain(double rim, std::size_t elements, double bending = 0) {
  MembraneWall wall = sample_wall();
  wall.bending_stiffness = bending;
  return {spherical_meridian(sample_radius, rim, elements, rim > 0 ? 20 : 1), wall};
}

/// Pressure over that of (3.1) at the state's radius, less 1.
double excess(const MembraneState& state) {
  return state.pressure / static_pressure(sphere(), state.radius / sample_radius).value - 1;
}

/// Greatest difference from (3.1) at stretches up to 2.2.
double greatest_excess(const Membrane& membrane) {
  MembraneState state = slack_state(membrane);
  double greatest = 0;
  for (const double stretch : {1.05, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0, 2.2}) {
    state = hold_volume(membrane, state, volume_at(stretch));
    greatest = std::max(greatest, std::abs(excess(state)));
  }
  return greatest;
}

/// The state in which the balloon has a stretch.
MembraneState at_stretch(const Membrane& membrane, double stretch) {
  MembraneState state = slack_state(membrane);
  double volume = volume_at(stretch);
  for (int i = 0; i < 5; ++i) {
    state = hold_volume(membrane, state, volume);
    volume *= std::pow(stretch * sample_radius / state.radius, 3);
  }
  return state;
}

void closed_sphere() {
  const LimitPoint exact = limit_points(sphere()).front();
  for (const std::size_t n : {8U, 16U, 32U, 64U}) {
    const Membrane membrane = chain(0, n);
    print("closed sphere", "greatest up to R = 2.2", size_of(n), greatest_excess(membrane));
    const MembraneState limit = limit_point(membrane, volume_at(1.8));
    print("closed sphere", "R of the limit point", size_of(n),
          std::abs(limit.radius / sample_radius / exact.stretch - 1));
  }
}

void holes() {
  constexpr std::size_t elements = 96;
  for (const double rim : {0.03, 0.02, 0.015, 0.0075, 0.00375}) {
    const double greatest = greatest_excess(chain(rim, elements));
    print("hole", "greatest up to R = 2.2", rim / sample_radius, greatest);
    if (rim <= 0.015) print("small hole", "greatest up to R = 2.2", rim / sample_radius, greatest);
  }
  for (const double stretch : {1.1, 1.5, 2.2}) {
    print("3 cm hole", "excess in per cent", stretch, 100 * excess(at_stretch(chain(0.03, elements), stretch)));
  }
}

void shooting() {
  const Shooting shots(sample_wall(), sample_radius, 0.03);
  for (const double pole : {1.1, 1.5, 2.2}) {
    const ShotState expected = shots.at(pole);
    for (const std::size_t n : {8U, 16U, 32U}) {
      const Membrane membrane = chain(0.03, n);
      const MembraneState state = hold_volume(membrane, slack_state(membrane), expected.volume);
      print("3 cm hole by shooting", "pole stretched by " + rounded(pole), size_of(n),
            std::abs(state.pressure / expected.pressure - 1));
    }
  }
}

void stability() {
  const Membrane membrane = chain(0.03, 48, sample_bending);
  const InflationCurve curve = inflation_curve(membrane, slack_state(membrane), volume_at(3.6));
  const double limit = curve.states[curve.limit_points.front()].volume;
  const double second = curve.states[curve.limit_points.back()].volume;
  for (const MembraneState& state : curve.states) {
    if (std::abs(state.volume - limit) < 1e-6 * limit || std::abs(state.volume - second) < 1e-6 * second) continue;
    const UnstableModes modes = unstable_modes(membrane, state);
    const char* branch = state.volume < limit ? "first branch" : state.volume < second ? "between" : "second branch";
    print("modes at held pressure", branch, state.radius / sample_radius, modes.at_pressure);
    print("modes at held volume", "whole curve", state.radius / sample_radius, modes.at_volume);
  }
}

void shape_frequencies() {
  for (const int n : {2, 3}) {
    const double exact = exact_frequency(sample_wall(), n);
    const std::string name = "n = " + std::to_string(n);
    print("frequency", name, mode_stretch, exact);
    for (const std::size_t elements : {8U, 16U, 32U, 64U}) {
      print("shape modes", name, size_of(elements),
            std::abs(sphere_frequencies(elements)[static_cast<std::size_t>(n)] / exact - 1));
    }
  }
}

/// Greatest force on a node, over that which the wall of a balloon of R = 1.2 has there: of bending and stretching
/// after a shift of the slack balloon along the axis, of damping while the stretched one moves along it.
void rigid_motion() {
  MembraneWall wall = sample_wall();
  wall.bending_stiffness = sample_bending;
  wall.damping_time = 0.01;
  const Membrane membrane(spherical_meridian(sample_radius, 0, 48), wall);
  const MembraneState state = hold_volume(membrane, slack_state(membrane), volume_at(1.2));
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(state.places.size());
  for (Eigen::Index i = 1; i < shift.size(); i += 2) shift(i) = 0.1;
  const double scale = membrane.elastic(state.places).gradient.cwiseAbs().maxCoeff();
  const Eigen::VectorXd moved = membrane.reference() + shift;
  print("rigid motion", "bending and stretching", 1, membrane.elastic(moved).gradient.cwiseAbs().maxCoeff() / scale);
  print("rigid motion", "damping", 1, membrane.damping(state.places, shift).force.cwiseAbs().maxCoeff() / scale);
}

void all() {
  std::puts("panel,quantity,x,value");
  closed_sphere();
  holes();
  shooting();
  stability();
  shape_frequencies();
  rigid_motion();
}

}  // namespace
}  // namespace turgor

int main() {
  try {
    turgor::all();
  } catch (const std::exception& error) {
    std::cerr << "membrane-studies: " << error.what() << '\n';
    return 1;
  }
}
