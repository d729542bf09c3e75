// Prints the tables of docs/theory.md, section 3.3: every approximation of section 3 beside the exact solution, for the
// paper's balloon with the 3 cm channel at the mean of its limit pressures, on the clock of (3.7).

#include <cstdio>
#include <string>

#include "turgor/asymptotics/decay.hpp"
#include "turgor/asymptotics/equilibria.hpp"
#include "turgor/asymptotics/matched_deflation.hpp"
#include "turgor/asymptotics/oscillation.hpp"
#include "turgor/integrate/quadrature.hpp"

namespace {

using namespace turgor;

template <class T>
Parameters<T> balloon() {
  return {T(3) / 10,         T(3) / 1000, T(1000),  T(1000),
          T(1) / 1000,       T(3) / 100,  T(1) / 2, MooneyRivlin<T>{T(1500000), T(150000)},
          Closure::corrected};
}

double mean_limit_pressure() {
  const auto points = limit_points(balloon<double>());
  return (points[0].pressure + points[1].pressure) / 2;
}

template <class T>
Oscillator<T> oscillator(double time) {
  const auto p = balloon<T>();
  return {Model::long_channel,
          p,
          constant_pressure<T>(static_cast<T>(mean_limit_pressure())),
          {p.radius, T(6000), static_cast<T>(time)}};
}

FreeMotion large_motion() {
  const double P = mean_limit_pressure() / 6000;
  const double time = FreeMotion(oscillator<double>(1), P, 4.8).time_scales().deflation;
  return {oscillator<double>(time), P, 4.8};
}

Trajectory<long double> exact(const FreeMotion& motion, long double start, double end, long events) {
  SimulationOptions<long double> options;
  options.max_events = events;
  return simulate_by_quadrature<long double>(oscillator<long double>(motion.scales().time), 0, start, 0, end, options);
}

double exact_stretch(const FreeMotion& motion, double start, double T) {
  return static_cast<double>(exact(motion, start, T, 0).last.stretch);
}

void print_deflation(const FreeMotion& motion) {
  const double start = 5;
  const MatchedDeflation law(motion, start);
  const auto end = static_cast<double>(exact(motion, start, 1e9, 1).events[0].time);
  std::printf(
      "Deflation from rest at $R_i$ = 5, errors in $R$:\n\n"
      "| $T$ | $R$ | (3.9) | (3.12) | (3.16) | uniform | its estimate | refined |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const double T : {0.05, 0.5, 3.0, 10.0, 30.0, 50.0, end}) {
    const double R = exact_stretch(motion, start, T);
    std::printf("| %.5g | %.9f | %.1e | %.1e | %.1e | %.1e | %.1e | %.1e |\n", T, R, law.outer(T).value - R,
                law.inner(T).value - R, law.composite(T).value - R, law.uniform().at(T).value - R,
                law.uniform().at(T).error, law.uniform().refined_at(T) - R);
  }
}

void print_inflation(const FreeMotion& motion) {
  const Oscillation law(motion, Regime::inflating);
  std::printf(
      "\nInflation from rest at $R_i$, errors in $R$:\n\n"
      "| $R_i$ | $T$ | $R$ | (3.18) | (3.19) | third order | its estimate |\n|---|---|---|---|---|---|---|\n");
  for (const double start : {4.6, 4.75}) {
    const double e = start - motion.equilibrium();
    for (const double T : {1.0, 2.0, 3.0}) {
      const double R = exact_stretch(motion, start, T);
      std::printf("| %.4g | %.1f | %.9f | %.1e | %.1e | %.1e | %.1e |\n", start, T, R, law.first_order(e, T).value - R,
                  law.second_order(e, T).value - R, law.third_order(e, T).value - R, law.third_order(e, T).error);
    }
  }
}

void print_row(const std::string& name, const std::string& by, double value, const Estimate& found) {
  std::printf("| %s | %.9g | %s | %.9g | %.1e | %.1e |\n", name.c_str(), value, by.c_str(), found.value,
              found.value - value, found.error);
}

void print_numbers(const FreeMotion& motion) {
  std::printf(
      "\nSingle numbers:\n\n"
      "| | exact | by | value | error | its estimate |\n|---|---|---|---|---|---|\n");
  const double P = mean_limit_pressure();
  const auto states = equilibria(balloon<double>(), P);
  print_row("small $R_{eq}$", "(3.3)", states[0].stretch, small_equilibrium(balloon<double>(), P).stretch);
  print_row("large $R_{eq}$", "(3.5)", states[2].stretch, large_equilibrium(balloon<double>(), P));
  for (const double start : {4.82, 5.2}) {
    const MatchedDeflation law(motion, start);
    const auto end = static_cast<double>(exact(motion, start, 1e9, 1).events[0].time);
    const std::string name = "$T_{d\\to i}$ from " + std::to_string(start).substr(0, 4);
    print_row(name, "(3.17)", end, law.transition_time());
    print_row(name, "uniform", end, law.uniform().transition_time());
  }
  const Oscillation inflation(motion, Regime::inflating);
  const double e = 4.75 - motion.equilibrium();
  const auto turn = static_cast<double>(exact(motion, 4.75L, 1e9, 1).events[0].time);
  print_row("$T_{i\\to d}$ from 4.75", "$\\pi/\\alpha$", turn, inflation.half_period(e));
  print_row("$T_{i\\to d}$ from 4.75", "corrected", turn, inflation.corrected_half_period(e));
  const Decay decay(motion);
  const auto R_eq = static_cast<long double>(motion.equilibrium());
  const auto cycles = exact(motion, 5, 1e9, 200).events;
  const auto below = static_cast<double>(R_eq - cycles[0].stretch);
  print_row("undershoot from 5", "$1/(2\\beta)$", below, decay.greatest_undershoot());
  print_row("undershoot from 5", "Lambert", below, decay.undershoot(5 - motion.equilibrium()));
  print_row("undershoot from 5", "corrected", below, decay.corrected_undershoot(5 - motion.equilibrium()));
  for (const long n : {1L, 10L, 100L}) {
    print_row("$e_{" + std::to_string(n) + "}$ from 5", "Lambert",
              static_cast<double>(cycles[static_cast<std::size_t>(2 * n - 1)].stretch - R_eq),
              decay.amplitude(5 - motion.equilibrium(), n));
  }
}

}  // namespace

int main() {
  const FreeMotion motion = large_motion();
  print_deflation(motion);
  print_inflation(motion);
  print_numbers(motion);
}
