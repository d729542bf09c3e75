#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/util/bind.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
// the two above must come first
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cstdint>
#include <utility>

#include "odeint_fehlberg78.hpp"
#include "odeint_rosenbrock4.hpp"
#include "peers.hpp"

namespace turgor::bench {

namespace {

namespace odeint = boost::numeric::odeint;
using Flow = PeerFlow;

/// Steps a dense-output stepper over one stretch.
template <class Stepper, class System, class Vector>
void advance(Stepper& stepper, const System& system, const Stretch& stretch, State& state, std::vector<double>& values,
             Vector y, double first_step) {
  const double sign = static_cast<int>(stretch.regime);
  const auto& times = stretch.problem.times;
  y[0] = state.stretch;
  y[1] = state.rate;
  stepper.initialize(y, state.time, first_step);
  Vector at = y;
  const auto rate_at = [&](double t) {
    stepper.calc_state(t, at);
    return sign * at[1];
  };
  constexpr long too_many = 3'000'000;  // steps; some tolerances leave it crawling
  for (long steps = 0; steps < too_many; ++steps) {
    const auto [from, to] = stepper.do_step(system);
    double end = std::min(to, stretch.target);
    const bool crosses =
        rate_at(end) < 0 && from + 1e-3 * (end - from) < end && rate_at(from + 1e-3 * (end - from)) > 0;
    if (crosses) {
      std::uintmax_t iterations = 100;
      end = boost::math::tools::toms748_solve(rate_at, from + 1e-3 * (end - from), end,
                                              boost::math::tools::eps_tolerance<double>(50), iterations)
                .second;
    }
    while (values.size() < times.size() && times[values.size()] <= end) {
      stepper.calc_state(times[values.size()], at);
      values.push_back(at[0]);
    }
    if (!crosses && end < stretch.target) continue;
    stepper.calc_state(end, at);
    state = {end, at[0], crosses ? 0.0 : at[1]};
    return;
  }
  throw std::runtime_error("odeint crawls at t = " + std::to_string(state.time));
}

/// A first step that no stretch outgrows; the controllers adapt it at once.
double first_step(const Stretch& stretch, const State& state, double tolerance) {
  return std::min(1e-3 * std::pow(tolerance, 0.2), (stretch.target - state.time) / 2);
}

}  // namespace

namespace {

/// @param make  makes a stepper with dense output for a system
template <class Make>
std::vector<double> by_explicit(const Problem& problem, double tolerance, const Make& make) {
  using Vector = std::array<double, 2>;
  std::vector<double> values;
  walk(problem, [&](const Stretch& stretch, State& state) {
    const Flow flow(problem.oscillator, stretch.pressure, stretch.regime);
    const auto system = [&](const Vector& y, Vector& rates, double t) {
      const Flow::State r = flow.rate(t, {y[0], y[1]});
      rates = {r[0], r[1]};
    };
    auto stepper = make(Vector{}, system);
    advance(stepper, system, stretch, state, values, Vector{}, first_step(stretch, state, tolerance));
  });
  return values;
}

}  // namespace

std::vector<double> by_odeint_dopri5(const Problem& problem, double tolerance) {
  return by_explicit(problem, tolerance, [&]<class Vector>(Vector, const auto&) {
    return odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<Vector>());
  });
}
std::vector<double> by_odeint_fehlberg78(const Problem& problem, double tolerance) {
  return by_explicit(problem, tolerance, [&]<class Vector, class System>(Vector, const System& system) {
    return OdeintFehlberg78<Vector, System>(system, tolerance);
  });
}

std::vector<double> by_odeint_rosenbrock4(const Problem& problem, double tolerance) {
  using Vector = StiffSystem::Vector;
  OdeintRosenbrock4 stepper(tolerance);
  std::vector<double> values;
  walk(problem, [&](const Stretch& stretch, State& state) {
    const Flow flow(problem.oscillator, stretch.pressure, stretch.regime);
    const StiffSystem system{[&](const Vector& y, double t) -> Vector {
                               const Flow::State r = flow.rate(t, {y[0], y[1]});
                               return {r[0], r[1]};
                             },
                             [&](const Vector& y, double t) -> std::pair<std::array<double, 4>, Vector> {
                               const auto at = flow.linearize(t, {y[0], y[1]});
                               return {{at.jacobian(0, 0), at.jacobian(0, 1), at.jacobian(1, 0), at.jacobian(1, 1)},
                                       {at.time_derivative[0], at.time_derivative[1]}};
                             }};
    advance(stepper, system, stretch, state, values, Vector{}, first_step(stretch, state, tolerance));
  });
  return values;
}

}  // namespace turgor::bench
