// The valve by Boost.Odeint, as its users write such things.

#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/util/bind.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
// the two above must come first
#include <algorithm>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cstdint>

#include "odeint_fehlberg78.hpp"
#include "valve_peer.hpp"

namespace turgor::bench {

namespace {

namespace odeint = boost::numeric::odeint;
using Vector = std::array<double, 3>;

struct Valve {
  double q;
  void operator()(const Vector& y, Vector& rates, double /*t*/) const {
    rates[0] = y[1];
    rates[1] = y[2] - valve::kappa * y[1] - (y[0] + valve::delta);
    rates[2] = valve::beta * (q - y[0] * std::sqrt(std::max(y[2], 0.0)));
  }
};

template <class Pair>
Vector at(Pair& pair, double t) {
  Vector y;
  pair.calc_state(t, y);
  return y;
}

/// Where a component falls through zero between two times of the step at hand.
template <class Pair>
double zero(Pair& pair, std::size_t component, double from, double to) {
  std::uintmax_t iterations = 100;
  return boost::math::tools::toms748_solve([&](double t) { return at(pair, t)[component]; }, from, to,
                                           boost::math::tools::eps_tolerance<double>(48), iterations)
      .second;
}

/// @param pair  a stepper with dense output
template <class Pair>
void record(Pair pair, const Valve& valve, const ValveTask& task, std::span<double> records) {
  int counted = 0;
  const auto count = [&](double value) {
    const int kept = counted++ - task.passed;
    if (kept >= 0 && kept < task.kept) records[static_cast<std::size_t>(kept)] = value;
  };
  const auto unfinished = [&] { return counted < task.passed + task.kept; };
  pair.initialize(Vector{0.2, 0, 0}, 0, 1e-6);
  while (unfinished()) {
    const auto [from, to] = pair.do_step(valve);
    if (to > task.patience) return;
    double end = to;
    Vector y = at(pair, end);
    const bool hits = y[0] < 0;
    if (hits) {
      double above = to;  // a step from the seat begins at zero: find where the valve is off it
      do above = from + (above - from) / 8;
      while (at(pair, above)[0] <= 0 && above > from);
      end = above > from ? zero(pair, 0, above, to) : from;
      y = at(pair, end);
    }
    if (at(pair, from)[1] > 0 && y[1] < 0) {
      const Vector top = at(pair, zero(pair, 1, from, end));
      count(top[0]);
      while (unfinished() && valve::rests(top[0], top[2])) count(top[0]);
    }
    if (!hits) continue;
    count(y[1]);
    const valve::Bounce bounce = valve::bounce(y[1], y[2], valve.q);
    pair.initialize(Vector{0, bounce.rate, bounce.pressure}, end + bounce.duration, pair.current_time_step());
  }
}

}  // namespace

void valve_by_dopri5(double q, const ValveTask& task, std::span<double> records) {
  record(odeint::make_dense_output(task.tolerance, task.tolerance, odeint::runge_kutta_dopri5<Vector>()), Valve{q},
         task, records);
}
void valve_by_fehlberg78(double q, const ValveTask& task, std::span<double> records) {
  record(OdeintFehlberg78<Vector, Valve>(Valve{q}, task.tolerance), Valve{q}, task, records);
}

}  // namespace turgor::bench
