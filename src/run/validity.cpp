#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/closure/calibration.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/statics/statics.hpp"

namespace turgor {

namespace {

// Where an assumption counts as strained. The first two are the range over which the paper fitted its closure (section
// 2.1.3); the others are the usual order-of-magnitude readings of "much smaller" and "high".
constexpr double smallest_kappa = 1.0 / 200;
constexpr double largest_kappa = 1.0 / 10;
constexpr double much_smaller = 0.1;
constexpr double high_reynolds = 1000;
constexpr double viscous_share = 0.05;
constexpr double slack = 0.01;         // a range of fits does not end sharply
constexpr double compression = 0.001;  // undershoot of R = 1, or of a table's beginning, that is worth a word

/// What finite elements found for balloons that fill through a bare orifice (docs/fem-coupled.md, "How far to trust the
/// model while it fills").
struct FillingError {
  double speed;  ///< the model's greatest one in the orifice over sqrt(2 p/rho), p the greatest pressure
  double error;  ///< of the radius, greatest while rising and holding, over the stroke
};
constexpr std::array<FillingError, 7> filling_errors{
    {{0.71, 0.056}, {1.1, 0.13}, {1.2, 0.20}, {3.0, 0.26}, {6.8, 0.58}, {12, 0.90}, {27, 1.7}}};

/// Linear in the logarithm of the speed, constant beyond the ends.
double filling_error(double speed) {
  const auto* const after =
      std::ranges::find_if(filling_errors, [&](const FillingError& e) { return e.speed > speed; });
  if (after == filling_errors.begin()) return after->error;
  if (after == filling_errors.end()) return filling_errors.back().error;
  const FillingError& before = *(after - 1);
  return std::lerp(before.error, after->error, std::log(speed / before.speed) / std::log(after->speed / before.speed));
}

class Checks {
 public:
  Checks(const Case& c, const RunResult& result)
      : case_(c), p_(c.parameters), result_(result), range_(stretch_range(*result.trajectory)) {}

  std::vector<Warning> all() {
    wall();
    for (Warning& warning : strained_orifice(p_, range_)) warnings_.push_back(std::move(warning));
    channel();
    filling();
    viscosity();
    statics();
    dropped();
    return std::move(warnings_);
  }

 private:
  void warn(const char* name, std::string text) { warnings_.push_back({name, std::move(text)}); }

  void wall() {
    const double ratio = p_.thickness / p_.radius;
    if (ratio > much_smaller)
      warn("thin-wall", "thickness/radius = " + rounded(ratio) + ": the wall is not a thin membrane (assumed << 1)");
    if (range_.least < 1 - compression) {
      warn("compression", "the balloon is compressed to R = " + rounded(range_.least, 6) +
                              ": a membrane buckles there, the model does not");
    }
    const KnownStretches<double> known = known_stretches(p_.material);
    if (range_.least < known.least - compression || range_.greatest > known.greatest) {
      warn("table-range", "R goes from " + rounded(range_.least, 6) + " to " + rounded(range_.greatest, 6) +
                              ", but material.table from " + rounded(known.least, 6) + " to " +
                              rounded(known.greatest, 6) + ": beyond it the stress went on along straight lines");
    }
  }

  void channel() {
    if (result_.choice.model != Model::long_channel) return;
    const double slenderness = p_.channel_length / p_.orifice_radius;
    const double kappa = p_.orifice_radius / (p_.radius * range_.least);
    const double upper = std::pow(cap_depth(kappa), -1.5);
    if (slenderness < 1 / much_smaller || slenderness > much_smaller * upper) {
      warn("channel-window", "L_ch/r_ch = " + rounded(slenderness) +
                                 " strains 1 << L_ch/r_ch << eps^(-3/2) = " + rounded(upper) + " of (2.25)");
    }
  }

  void filling() {
    if (p_.channel_length > 0) return;
    const double pressure = range_of(case_.pressure, case_.solve.t_end).greatest;
    if (!(pressure > 0)) return;
    const double in = orifice_speeds(result_).in;
    const double speed = in / std::sqrt(2 * pressure / p_.fluid_density);
    if (speed < 1) return;
    warn("fast-filling", "liquid enters with up to " + rounded(in, 3) + " m/s, " + rounded(speed, 3) +
                             " times what the greatest pressure can give to liquid at rest: finite elements of such "
                             "balloons had the radius " +
                             rounded(100 * filling_error(speed), 2) + " % of the stroke off while they filled");
  }

  void viscosity() {
    const double reynolds = result_.quantity("peak_reynolds").value_or(0);
    if (reynolds > 0 && reynolds < high_reynolds) {
      warn("reynolds",
           "the Reynolds number in the orifice stays below " + rounded(reynolds) + ": the flow is not inviscid");
    }
    const double greatest =
        result_.oscillator->scales().pressure;  // natural: of the program, or of the wall without one
    const double speed = reynolds * p_.fluid_viscosity / (p_.fluid_density * 2 * p_.orifice_radius);
    const double loss = 8 * p_.fluid_viscosity * p_.channel_length * speed / (p_.orifice_radius * p_.orifice_radius);
    if (loss > viscous_share * greatest) {
      warn("channel-friction", "laminar friction in the channel would take " + rounded(loss) +
                                   " Pa at the peak flow, " + rounded(100 * loss / greatest, 3) +
                                   " % of the greatest pressure; the model has none");
    }
  }

  void statics() {
    const PressureRange<double> pressures = range_of(case_.pressure, case_.solve.t_end);
    for (const LimitPoint& point : limit_points(p_)) {
      if (!point.maximum) continue;
      if (range_.greatest > point.stretch) {
        warn("beyond-limit-point", "R reaches " + rounded(range_.greatest, 6) + ", beyond the limit point at R = " +
                                       rounded(point.stretch, 6) + ": real balloons lose their spherical shape there");
      }
      if (pressures.greatest > point.pressure) {
        warn("pressure-above-limit", "the pressure reaches " + rounded(pressures.greatest) +
                                         " Pa, above the limit point's " + rounded(point.pressure) +
                                         " Pa: the lower stable branch ends there");
      }
      break;
    }
  }

  void dropped() {
    if (result_.choice.automatic) return;
    for (const auto& [model, terms] : result_.choice.dropped) {
      for (const DroppedTerm& term : terms) {
        if (term.ratio < case_.auto_tolerance) continue;
        warn("dropped-term", "the " + std::string(name_of(model)) + " model drops a term of " +
                                 rounded(100 * term.ratio, 3) + " % (" + term.name + "); name = \"full\" keeps it");
      }
    }
  }

  const Case& case_;
  const Parameters<double>& p_;
  const RunResult& result_;
  StretchRange range_;
  std::vector<Warning> warnings_;
};

}  // namespace

std::vector<Warning> strained_orifice(const Parameters<double>& p, const StretchRange& range) {
  const bool calibrated = p.closure == Closure::calibrated;
  if (has_table(p.closure) && !calibrated) return {};
  const double largest_fitted = calibrated ? greatest_calibrated_kappa : largest_kappa;
  const double smallest_fitted = calibrated ? least_calibrated_kappa : smallest_kappa;
  const double largest = p.orifice_radius / (p.radius * range.least);
  const double smallest = p.orifice_radius / (p.radius * range.greatest);
  std::vector<Warning> warnings;
  if (largest > largest_fitted * (1 + slack)) {
    warnings.push_back({"orifice-large", "r_ch/r reaches " + rounded(largest) + ": the closure was fitted up to " +
                                             rounded(largest_fitted)});
  }
  if (smallest < smallest_fitted * (1 - slack)) {
    warnings.push_back({"orifice-small", "r_ch/r falls to " + rounded(smallest) + ": the closure was fitted down to " +
                                             rounded(smallest_fitted)});
  }
  return warnings;
}

std::vector<Warning> strained_assumptions(const Case& c, const RunResult& result) { return Checks(c, result).all(); }

}  // namespace turgor
