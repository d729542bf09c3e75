// Waves in a tube of elastic rings, against their exact theory, and the pressure pulse that others have computed.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "fem/known_flows.hpp"
#include "studies.hpp"
#include "tube_wall.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

struct Cells {
  std::size_t columns;
  std::size_t rows;
  bool graded = false;
};

/// A tube and the solver of its liquid.
class FullTube {
 public:
  FullTube(const Tube& tube, const Cells& cells, Side below, FemScheme scheme,
           std::function<double(double t)> pressure = {})
      : mesh_(tube_mesh(tube, cells.columns, cells.rows, below, cells.graded)),
        space_(mesh_),
        wall_(std::make_shared<TubeWall>(space_, tube)),
        solver_(space_, definition(tube, std::move(pressure)), tight(scheme)) {}

  [[nodiscard]] const FlowSpace& space() const { return space_; }
  [[nodiscard]] const TubeWall& wall() const { return *wall_; }
  [[nodiscard]] FlowSolver& solver() { return solver_; }
  [[nodiscard]] std::vector<double> displacements() const { return wall_->displacements(solver_); }

 private:
  [[nodiscard]] FlowDefinition definition(const Tube& tube, std::function<double(double t)> pressure) const {
    FlowDefinition flow;
    flow.density = tube.density;
    flow.viscosity = tube.viscosity;
    flow.wall = wall_;
    flow.inlet_pressure = std::move(pressure);
    return flow;
  }

  BalloonMesh mesh_;
  FlowSpace space_;
  std::shared_ptr<const TubeWall> wall_;
  FlowSolver solver_;
};

/// Share of cos kz in displacements at equal spacings of the tube.
double share(const std::vector<double>& displacements, double waves) {
  const auto n = static_cast<double>(displacements.size() - 1);
  double sum = 0;
  for (std::size_t i = 0; i < displacements.size(); ++i) {
    const double end = i == 0 || i + 1 == displacements.size() ? 0.5 : 1.0;
    sum += 2 / n * end * displacements[i] * std::cos(pi * waves * static_cast<double>(i) / n);
  }
  return sum;
}

/// The factor zeta of a series that is Re c zeta^i, from each `stride`-th member.
Complex factor(const std::vector<double>& series, std::size_t stride) {
  Eigen::MatrixXd before(static_cast<Eigen::Index>(series.size() - 2 * stride), 2);
  Eigen::VectorXd after(before.rows());
  for (Eigen::Index i = 0; i < before.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    before.row(i) << series[at + stride], series[at];
    after[i] = series[at + 2 * stride];
  }
  const Eigen::Vector2d fit = before.colPivHouseholderQr().solve(after);
  const Complex strided = fit[0] / 2 + std::sqrt(Complex(fit[0] * fit[0] / 4 + fit[1]));
  return std::pow(strided, 1.0 / static_cast<double>(stride));
}

/// Factor by which a standing wave of `waves` half lengths changes in a step.
/// @param steps  in a period
Complex wave_factor(const Tube& tube, int waves, const Cells& cells, FemScheme scheme, int steps) {
  constexpr double amplitude = 1e-6;  // of the radius, so that nothing is carried along
  const double k = waves * pi / tube.length;
  const StandingWave wave(tube, k, amplitude * tube.radius);
  FullTube full(tube, cells, Side::wall, scheme);
  const auto level = [&](double t) {
    FlowLevel now = level_of(full.space(), t, [&](const Point2& X) { return wave.velocity(X, t); });
    now.positions = full.wall().start();
    const auto moved = full.wall().followed([&](double z) { return wave.displacement(z, t); });
    for (std::size_t i = 0; i < moved.size(); ++i) now.positions[i] += moved[i];
    now.mesh_velocities = full.wall().followed([&](double z) { return wave.velocity({tube.radius, z}, t)[0]; });
    return now;
  };
  const double dt = 2 * pi / wave.rate().imag() / steps;
  full.solver().start({level(-dt), level(0)});
  std::vector<double> series;
  take_steps(full.solver(), dt, 1.5 * steps * dt, [&](const FlowSolver& now) {
    // the other roots of the scheme, which start a little, fall to a third with every step
    if (now.time() > steps / 2 * dt) series.push_back(share(full.displacements(), waves));
  });
  return factor(series, static_cast<std::size_t>(steps / 8));
}

/// Decay and frequency of a wave on a mesh, without any error of time: bdf2 takes a wave that is e^{st} exactly by the
/// factor of its formula, (3 - 4/zeta + 1/zeta^2)/2 = s dt.
Complex wave_rate(const Tube& tube, int waves, const Cells& cells) {
  constexpr int steps = 32;
  const Complex back = 1.0 / wave_factor(tube, waves, cells, FemScheme::bdf2, steps);
  const double dt = 2 * pi / StandingWave(tube, waves * pi / tube.length, 1).rate().imag() / steps;
  return (3.0 - 4.0 * back + back * back) / 2.0 / dt;
}

void print_modes() {
  for (const bool string : {true, false}) {
    Tube tube;
    if (!string) tube.tension = 0;
    const std::string wall = string ? "string" : "rings";
    for (const int waves : {1, 2, 4, 8, 16}) {
      const double k = waves * pi / tube.length;
      const double exact = tube.frequency(k);
      const double found = wave_rate(tube, waves, {.columns = 8, .rows = 80}).imag();
      print("waves", wall + " by theory", k * tube.radius, exact / k / tube.long_wave_speed());
      print("waves", wall, k * tube.radius, found / k / tube.long_wave_speed());
      print("frequency over theory", wall, k * tube.radius, found / exact);
    }
  }
}

void print_orders() {
  const Tube tube;
  constexpr int waves = 2;
  const Complex exact = StandingWave(tube, waves * pi / tube.length, 1).rate();
  for (const std::size_t n : {1U, 2U, 4U, 8U}) {
    const Complex found = wave_rate(tube, waves, {.columns = n, .rows = 4 * n});
    print("space", "frequency", tube.radius / static_cast<double>(n) * 1e3, std::abs(found - exact) / std::abs(exact));
  }
  for (const FemScheme scheme : {FemScheme::bdf1, FemScheme::bdf2}) {
    for (const int steps : {16, 32, 64, 128}) {
      const double dt = 2 * pi / exact.imag() / steps;
      const Complex found = std::log(wave_factor(tube, waves, {.columns = 8, .rows = 40}, scheme, steps)) / dt;
      print("time", std::string(name_of(scheme)), 1.0 / steps, std::abs(found - exact) / std::abs(exact));
    }
  }
}

/// Against viscous theory: what viscosity takes from the frequency, and decay.
void print_viscous_waves() {
  for (const double viscosity : {0.3, 0.1, 0.03, 0.01, 0.003}) {
    Tube tube;
    const double k = pi / tube.length;
    const double without = tube.frequency(k);
    tube.viscosity = viscosity;
    const Complex exact = StandingWave(tube, k, 1).rate();
    const Complex found = wave_rate(tube, 1, {.columns = 16, .rows = 20, .graded = true});
    const double number = tube.radius * std::sqrt(exact.imag() * tube.density / viscosity);
    print("viscous waves", "frequency over that without viscosity", number, found.imag() / without);
    print("viscous waves", "decay over frequency without viscosity", number, -found.real() / without);
    print("viscous waves over theory", "frequency", number, found.imag() / exact.imag());
    print("viscous waves over theory", "decay", number, found.real() / exact.real());
  }
}

/// Pressure at the open end of a tube at rest.
struct Pulse {
  Tube tube;
  Cells cells;
  double step = 0;  ///< [s], a whole share of 1 ms
  PressurePulse pressure;
};

struct PulseResult {
  std::vector<std::vector<double>> profile;  ///< displacements after 0, 1, 2, ... ms
  std::vector<double> middle;                ///< displacement half way along the tube after each step
  double far_end = 0;                        ///< greatest displacement there
  double volume = 0;                         ///< that is missing, over what has come in
  double energy = 0;                         ///< that is missing, over the work of the pressure
};

/// Integrals over time, the pressure constant within steps.
class Account {
 public:
  Account(FullTube& tube, double step) : tube_(tube), step_(step), before_(balance()), volume_(before_.volume) {}

  void add(double pressure) {
    const FlowBalance now = balance();
    entered_ += step_ / 2 * (before_.inflow + now.inflow);
    work_ += pressure * step_ / 2 * (before_.inflow + now.inflow);
    gained_ += step_ / 2 * (gain(before_) + gain(now));
    before_ = now;
  }
  [[nodiscard]] double volume() const { return std::abs(before_.volume - volume_ - entered_) / entered_; }
  [[nodiscard]] double energy() const {
    const double energy = before_.kinetic_energy + tube_.wall().energy(tube_.solver());
    return std::abs(energy - work_ - gained_) / work_;
  }

 private:
  [[nodiscard]] FlowBalance balance() const {
    return flow_balance(tube_.solver(), [](const Point2&) { return Point2{}; });
  }
  static double gain(const FlowBalance& b) {
    return b.inlet_kinetic - b.viscous_loss - b.upwind_loss - b.grad_div_loss - b.penalty_loss;
  }

  FullTube& tube_;
  double step_;
  FlowBalance before_;
  double volume_;
  double entered_ = 0;
  double work_ = 0;
  double gained_ = 0;
};

PulseResult run(const Pulse& pulse, int milliseconds) {
  FullTube full(pulse.tube, pulse.cells, Side::inlet, FemScheme::bdf2, pulse.pressure);
  FlowSolver& solver = full.solver();
  Account account(full, pulse.step);
  PulseResult found;
  found.profile.push_back(full.displacements());
  const auto per_millisecond = std::lround(1e-3 / pulse.step);
  for (long k = 1; k <= milliseconds * per_millisecond; ++k) {
    solver.step_to(static_cast<double>(k) * pulse.step);
    account.add(pulse.pressure(solver.time()));
    // bdf2 would smear the jump of the pressure: one step of bdf1, as at the start
    const bool jump = !pulse.pressure.smooth && std::abs(solver.time() - pulse.pressure.duration) < pulse.step / 2;
    if (jump) solver.start({solver.levels().back()});
    const std::vector<double> now = full.displacements();
    found.middle.push_back(now[now.size() / 2]);
    found.far_end = std::max(found.far_end, now.back());
    if (k % per_millisecond == 0) found.profile.push_back(now);
  }
  found.volume = account.volume();
  found.energy = account.energy();
  return found;
}

/// Displacements by the linear theory, in as many places as there are of another profile.
std::vector<double> theory(const Pulse& pulse, std::size_t places, double t) {
  std::vector<double> list;
  for (std::size_t i = 0; i < places; ++i) {
    const double z = pulse.tube.length * static_cast<double>(i) / static_cast<double>(places - 1);
    list.push_back(pulse_displacement(pulse.tube, pulse.pressure, z, t));
  }
  return list;
}

/// Root mean square of the difference over the greatest displacement by theory.
double off_theory(const Pulse& pulse, const std::vector<double>& found, double t) {
  const std::vector<double> exact = theory(pulse, found.size(), t);
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i) sum += std::pow(found[i] - exact[i], 2);
  return std::sqrt(sum / static_cast<double>(found.size())) / std::ranges::max(exact);
}

struct Crest {
  double place;  ///< in spacings of the list
  double height;
  double front;  ///< foremost place of half the height
};
/// Of a list with its greatest value inside; the parabola through it and its neighbours.
Crest crest_of(const std::vector<double>& list) {
  const auto top = static_cast<std::size_t>(std::ranges::max_element(list) - list.begin());
  const double before = list.at(top - 1);
  const double after = list.at(top + 1);
  const double slope = (after - before) / 2;
  const double bend = after - 2 * list[top] + before;
  Crest crest{static_cast<double>(top) - slope / bend, list[top] - slope * slope / (2 * bend), 0};
  std::size_t i = list.size() - 1;
  while (list[i] < crest.height / 2) --i;
  const double within = i + 1 < list.size() ? (list[i] - crest.height / 2) / (list[i] - list[i + 1]) : 0;
  crest.front = static_cast<double>(i) + within;
  return crest;
}

/// In mm, of a profile along a tube.
Crest crest_along(const Tube& tube, const std::vector<double>& profile) {
  Crest crest = crest_of(profile);
  const double spacing = tube.length * 1e3 / static_cast<double>(profile.size() - 1);
  crest.place *= spacing;
  crest.front *= spacing;
  crest.height *= 1e3;
  return crest;
}

/// Cells of half a millimetre at fineness 1, steps of 0.05 ms.
Pulse refined(const Tube& tube, double fineness, const PressurePulse& pressure) {
  const auto cells = [&](double at_one) { return static_cast<std::size_t>(std::lround(at_one * fineness)); };
  return {tube, {cells(8), cells(100), tube.viscosity > 0}, 5e-5 / fineness, pressure};
}

constexpr PressurePulse benchmark{};

Tube viscous_tube() {
  Tube tube;
  tube.viscosity = 0.003;
  return tube;
}

/// So small that nothing is carried along.
PressurePulse small(bool smooth) { return {.height = 1e-4 * benchmark.height, .smooth = smooth}; }

void print_small_pulses() {
  for (const bool smooth : {true, false}) {
    const std::string shape = smooth ? "smooth" : "sudden";
    for (const double fineness : {0.25, 0.5, 1.0, 2.0}) {
      if (fineness == 2 && !smooth) continue;
      const Pulse pulse = refined({}, fineness, small(smooth));
      print("small pulse", shape, 0.5 / fineness, off_theory(pulse, run(pulse, 5).profile[5], 5e-3));
    }
  }
}

/// At the closed end the pulse turns back.
void print_far_end() {
  const Pulse pulse = refined({}, 0.5, small(true));
  const PulseResult found = run(pulse, 14);
  double greatest = 0;
  for (double t = 8e-3; t < 14e-3; t += 1e-5) {
    greatest = std::max(greatest, pulse_displacement(pulse.tube, pulse.pressure, pulse.tube.length, t));
  }
  print("far end", "greatest displacement over theory", 0, found.far_end / greatest);
  print("far end", "greatest displacement over that on the way", 0, found.far_end / crest_of(found.profile[6]).height);
  print("far end", "off theory on the way back", 0, off_theory(pulse, found.profile[14], 14e-3));
}

/// The benchmark's crest and front, and speed of the front.
void print_pulse(const Pulse& pulse, const PulseResult& found) {
  std::vector<double> fronts;
  for (const std::size_t t : {2U, 4U, 6U, 8U}) {
    const auto ms = static_cast<double>(t);
    const Crest crest = crest_along(pulse.tube, found.profile[t]);
    const Crest linear = crest_along(pulse.tube, theory(pulse, found.profile[t].size(), 1e-3 * ms));
    print("pulse", "crest", ms, crest.place);
    print("pulse", "crest by linear theory", ms, linear.place);
    print("pulse", "front", ms, crest.front);
    print("pulse", "front by linear theory", ms, linear.front);
    print("height", "crest", ms, crest.height);
    print("height", "crest by linear theory", ms, linear.height);
    if (t == 2 || t == 6) fronts.insert(fronts.end(), {crest.front, linear.front});
  }
  print("speed", "front over long waves", 0, (fronts[2] - fronts[0]) / 4 / pulse.tube.long_wave_speed());
  print("speed", "front over long waves by linear theory", 0,
        (fronts[3] - fronts[1]) / 4 / pulse.tube.long_wave_speed());
}

/// By meshes and steps.
void print_pulse_orders() {
  for (const double fineness : {0.25, 0.5, 1.0, 2.0}) {
    const Pulse pulse = refined(viscous_tube(), fineness, benchmark);
    const PulseResult result = run(pulse, 4);
    const Crest crest = crest_along(pulse.tube, result.profile[4]);
    print("balances", "volume", pulse.step * 1e3, result.volume);
    print("balances", "energy", pulse.step * 1e3, result.energy);
    print("pulse by cells and steps", "front", pulse.step * 1e3, crest.front);
    print("pulse by cells and steps", "height", pulse.step * 1e3, crest.height);
  }
}

/// Without viscosity, over the height of the pressure, less what little pressure makes.
void print_amplitudes() {
  const std::vector<double> linear = run(refined({}, 0.5, small(false)), 6).profile[6];
  for (const double part : {1.0, 0.5, 0.25, 0.125}) {
    const std::vector<double> found = run(refined({}, 0.5, {.height = part * benchmark.height}), 6).profile[6];
    double sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += std::pow(found[i] / part - linear[i] * 1e4, 2);
    const double rms = std::sqrt(sum / static_cast<double>(found.size()));
    print("amplitudes", "what convection and stretch change", part, rms / (std::ranges::max(linear) * 1e4));
  }
}

/// Displacement half way along.
struct Passage {
  double half;    ///< when it is half the crest's [ms]
  double crest;   ///< [ms]
  double height;  ///< [mm]
};

Passage passage(const std::string& wall, const Pulse& pulse, const PulseResult& found) {
  const Crest crest = crest_of(found.middle);
  const auto half = std::ranges::find_if(found.middle, [&](double d) { return d > crest.height / 2; });
  const double beyond = (half[0] - crest.height / 2) / (half[0] - half[-1]);
  const auto after = static_cast<double>(half - found.middle.begin() + 1);  // steps
  const double step = pulse.step * 1e3;
  const Passage at{(after - beyond) * step, (crest.place + 1) * step, crest.height * 1e3};
  print("half way", wall + ": half the crest [ms]", 0, at.half);
  print("half way", wall + ": crest [ms]", 0, at.crest);
  print("half way", wall + ": crest [mm]", 0, at.height);
  return at;
}

/// Rings as stiff and as heavy as a thick tube without stress along it, by Lame: outer radius b,
///   pressure/displacement of the inner wall = E/{a [(a^2 + b^2)/(b^2 - a^2) + nu]}.
Tube thick_tube() {
  Tube tube = viscous_tube();
  const double a = tube.radius;
  const double b = a + 1e-3;
  tube.stiffness = 3e5 / (a * ((a * a + b * b) / (b * b - a * a) + Tube::poisson));
  tube.mass = 1200 * (b * b - a * a) / (2 * a);
  tube.tension = 0;
  return tube;
}

void print_benchmark() {
  const Pulse pulse = refined(viscous_tube(), 1, benchmark);
  const PulseResult found = run(pulse, 8);
  print_pulse(pulse, found);
  const Passage string = passage("string", pulse, found);
  print("half way", "string: crest over the displacement at rest", 0,
        string.height / (benchmark.height / pulse.tube.stiffness * 1e3));
  const Pulse thick = refined(thick_tube(), 1, benchmark);
  const Passage rings = passage("thick rings", thick, run(thick, 9));
  // the wall as an elastic solid in three dimensions, radial displacement at the inner side: solids4foam-tutorials-
  // benchmark-data, 3dTube/v2012/pimpleFluid/IQNILS/Euler/deltaT2.5e-5, solidPointDisplacement_displacement.dat
  constexpr Passage solid{5.438, 7.25, 0.1402};
  print("over a solid wall", "time of half the crest", 0, rings.half / solid.half);
  print("over a solid wall", "time of the crest", 0, rings.crest / solid.crest);
  print("over a solid wall", "height of the crest", 0, rings.height / solid.height);
}

}  // namespace

void elastic_tube() {
  print_modes();
  print_orders();
  print_viscous_waves();
  print_small_pulses();
  print_far_end();
  print_benchmark();
  print_pulse_orders();
  print_amplitudes();
}

}  // namespace turgor
