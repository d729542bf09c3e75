// How small free oscillations die out.

#include <cmath>

#include "makers.hpp"
#include "motion.hpp"
#include "turgor/asymptotics/decay.hpp"

namespace turgor {

namespace {

constexpr long cycles = 1000;

/// Amplitudes of the upper turning points of one balloon, counted from the start: exact and by half-cycles of Lambert's
/// function.
struct Amplitudes {
  double beta;
  std::vector<double> exact;
  std::vector<double> map;
};

Amplitudes amplitudes_of(const LargeMotion& large) {
  constexpr double start = 10;  // in units of 1/beta
  const Decay decay(large.motion);
  const double beta = decay.beta();
  const double equilibrium = large.motion.equilibrium();
  const double first = start / beta;
  constexpr double long_enough = 1e9;
  Amplitudes all{beta, {first}, {first}};
  for (const auto& event : large.exact(equilibrium + first, long_enough, 2 * cycles).events) {
    if (event.after == Regime::deflating) all.exact.push_back(event.stretch - equilibrium);
  }
  for (long n = 1; n <= cycles; ++n) all.map.push_back(decay.undershoot(all.map.back()).value);
  return all;
}

/// As beta times amplitude, where only its first values and then some in every decade are kept.
Curve scaled(const std::vector<double>& amplitudes, double beta) {
  Curve curve;
  double next = 1;
  for (std::size_t n = 1; n < amplitudes.size(); ++n) {
    if (static_cast<double>(n) < next) continue;
    curve.push_back({static_cast<double>(n), beta * amplitudes[n], false});
    constexpr double ratio = 1.25;
    next = static_cast<double>(n) * ratio;
  }
  return curve;
}

}  // namespace

void make_decay_figure(Studio& studio) {
  Table table(
      "r_ch [m],L_ch [m],beta [1],cycle,amplitude [1],by half-cycles of Lambert's function [1],3/(4 beta n) [1]");
  Plot plot;
  Curve map;
  const std::vector<const char*> colours{vermilion, blue};
  for (std::size_t i = 0; i < studio.cases().size(); ++i) {
    const LargeMotion large = large_motion(studio, studio.cases()[i]);
    const Amplitudes found = amplitudes_of(large);
    for (std::size_t n = 0; n < found.exact.size(); ++n) {
      const double asymptote = n == 0 ? std::nan("") : 3 / (4 * found.beta * static_cast<double>(n));
      table.add({large.of.parameters.orifice_radius, large.of.parameters.channel_length, found.beta,
                 static_cast<double>(n), found.exact[n], found.map[n], asymptote});
    }
    map = scaled(found.map, found.beta);  // the same for all balloons
    plot.add("exact" + std::to_string(i), scaled(found.exact, found.beta),
             "points pt " + std::string(i == 0 ? "6 ps 1.6" : "2 ps 1.0") + " lw 1.8 lc rgb '" + colours.at(i % 2) +
                 "' title " +
                 quoted((large.of.parameters.channel_length > 0 ? "channel (2.25), β = " : "orifice (2.23), β = ") +
                        std::to_string(std::lround(found.beta))));
  }
  studio.table("figure-decay", table);
  plot.add("map", map, line_style("black", "Lambert half-cycles"));
  Curve asymptote;
  for (const double n : {1.0, static_cast<double>(cycles)}) asymptote.push_back({n, 0.75 / n, false});
  plot.add("asymptote", asymptote, line_style(orange, "3/(4n)", unstable_dashes));
  const std::string commands =
      "set title 'Decay of free oscillations about the larger equilibrium'\nset logscale xy\nset xrange "
      "[0.9:1100]\nset yrange [5e-4:1]\n"
      "set xlabel 'cycle n'\nset ylabel 'upper turning point β (R - R_{eq}) [1]' offset 1\n"
      "set format y '10^{%L}'\nset key top right\n" +
      plot.command();
  studio.picture("figure-decay", plot.data(), commands, {800, 600});
}

}  // namespace turgor
