#include <math.h>  // NOLINT: Boost 1.74 calls isnan without naming its namespace

#include <boost/math/interpolators/pchip.hpp>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/pressure/program.hpp"

namespace turgor {

namespace {

void check_table(const std::vector<double>& times, const std::vector<double>& pressures) {
  const std::string key = "pressure.table";
  if (times.size() != pressures.size()) {
    throw InvalidInput(key,
                       std::to_string(times.size()) + " times and " + std::to_string(pressures.size()) + " pressures",
                       "the two lists differ in length");
  }
  if (times.size() < 2)
    throw InvalidInput(key, std::to_string(times.size()) + " rows", "too short", "give at least two rows");
  if (times.front() < 0) throw InvalidInput(key, shortest(times.front()) + " s", "starts before t = 0");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || !std::isfinite(pressures[i])) {
      throw InvalidInput(key, "row " + std::to_string(i + 1), "holds a value that is not a finite number");
    }
    if (i > 0 && !(times[i] > times[i - 1])) {
      throw InvalidInput(
          key, shortest(times[i]) + " s after " + shortest(times[i - 1]) + " s (row " + std::to_string(i + 1) + ")",
          "times must increase strictly", "sort the rows; write a jump as two rows a little apart");
    }
  }
}

/// Slopes [Pa/s] of the monotone cubic at the points.
std::vector<double> monotone_slopes(const std::vector<double>& times, const std::vector<double>& pressures) {
  std::vector<double> slopes(times.size());
  if (times.size() < 4) {  // the library needs four points; fewer have a unique sensible answer
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::size_t a = i == 0 ? 0 : i - 1;
      const double before = (pressures[a + 1] - pressures[a]) / (times[a + 1] - times[a]);
      const std::size_t b = i + 1 < times.size() ? i : i - 1;
      const double after = (pressures[b + 1] - pressures[b]) / (times[b + 1] - times[b]);
      slopes[i] = before * after > 0 ? 2 / (1 / before + 1 / after) : 0;
    }
    return slopes;
  }
  auto x = times;
  auto y = pressures;
  const boost::math::interpolators::pchip<std::vector<double>> spline(std::move(x), std::move(y));
  for (std::size_t i = 0; i < times.size(); ++i) slopes[i] = spline.prime(times[i]);
  return slopes;
}

}  // namespace

PressureProgram<double> table_pressure(const std::vector<double>& times, const std::vector<double>& pressures,
                                       TableInterpolation interpolation) {
  check_table(times, pressures);
  std::vector<PressureProgram<double>::Piece> pieces;
  const auto append = [&](double start, double duration, const std::array<double, 6>& polynomial) {
    pieces.push_back({start, PolynomialPressure<double>{start, duration, polynomial}});
  };
  if (times.front() > 0) append(0, times.front(), {pressures.front(), 0, 0, 0, 0, 0});
  const std::vector<double> slopes =
      interpolation == TableInterpolation::cubic ? monotone_slopes(times, pressures) : std::vector<double>{};
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double h = times[i + 1] - times[i];
    const double rise = pressures[i + 1] - pressures[i];
    if (interpolation == TableInterpolation::linear) {
      append(times[i], h, {pressures[i], rise, 0, 0, 0, 0});
    } else {
      const double left = h * slopes[i];
      const double right = h * slopes[i + 1];
      append(times[i], h, {pressures[i], left, 3 * rise - 2 * left - right, left + right - 2 * rise, 0, 0});
    }
  }
  append(times.back(), 1, {pressures.back(), 0, 0, 0, 0, 0});
  return PressureProgram<double>(std::move(pieces));
}

PressureRange<double> range_of(const PressureProgram<double>& program, double t_end) {
  PressureRange<double> range{program(0.0), program(0.0)};
  const auto include = [&](double p) {
    range.least = std::min(range.least, p);
    range.greatest = std::max(range.greatest, p);
  };
  const auto& pieces = program.pieces();
  for (std::size_t i = 0; i < pieces.size() && pieces[i].start < t_end; ++i) {
    const SmoothPressure<double>& pressure = pieces[i].pressure;
    if (const auto* harmonic = std::get_if<HarmonicPressure<double>>(&pressure.form())) {
      include(harmonic->mean - std::abs(harmonic->amplitude));
      include(harmonic->mean + std::abs(harmonic->amplitude));
    } else {  // ramps, straight lines and monotone cubics are monotone, so their ends bound them
      include(pressure(pieces[i].start));
      include(pressure(i + 1 < pieces.size() ? std::min(pieces[i + 1].start, t_end) : t_end));
    }
  }
  return range;
}

}  // namespace turgor
