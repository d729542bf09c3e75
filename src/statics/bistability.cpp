#include "turgor/statics/bistability.hpp"

#include <boost/math/tools/minima.hpp>
#include <numbers>

#include "shape.hpp"
#include "turgor/statics/energy.hpp"

namespace turgor {

std::vector<StableBranch> stable_branches(const Parameters<double>& p) {
  const Shape shape(p);
  const std::vector<Extremum>& all = extrema(shape);
  const auto value = [&](double R) { return static_pressure(p, R).value; };
  std::vector<StableBranch> branches;
  for (std::size_t i = 0; i <= all.size(); ++i) {  // pieces before and after each extremum
    const bool rises = i < all.size() ? all[i].maximum : all.empty() || !all.back().maximum;
    if (!rises) continue;
    const double from = i > 0 ? all[i - 1].stretch : shape.least_stretch();
    const double to = i < all.size() ? all[i].stretch : shape.greatest_stretch();
    branches.push_back({from, to, value(from), value(to)});
  }
  return branches;
}

namespace {

/// The stable stretch of a branch at a pressure within its reach.
double stretch_on(const Parameters<double>& p, const StableBranch& branch, double pressure) {
  const auto value = [&](double R) { return static_pressure(p, R).value; };
  const auto found =
      stretch_at(value, pressure, branch.least_stretch, branch.greatest_stretch, pressure_scale(p, pressure));
  if (found) return *found;
  return pressure <= branch.least_pressure ? branch.least_stretch : branch.greatest_stretch;
}

/// The deeper well changes once at most: the difference of energies falls with the pressure, at the rate of the
/// difference of volumes.
std::optional<double> maxwell_pressure(const Parameters<double>& p, const StableBranch& small,
                                       const StableBranch& large, double least, double greatest) {
  const auto difference = [&](double pressure) {
    return potential_energy(p, stretch_on(p, large, pressure), pressure) -
           potential_energy(p, stretch_on(p, small, pressure), pressure);
  };
  if (!(difference(least) > 0 && difference(greatest) < 0)) return std::nullopt;
  return root(difference, least, greatest);
}

}  // namespace

std::vector<BistableWindow> bistable_windows(const Parameters<double>& p) {
  const std::vector<StableBranch> branches = stable_branches(p);
  std::vector<BistableWindow> windows;
  for (std::size_t i = 0; i + 1 < branches.size(); ++i) {
    const double least = std::max(branches[i].least_pressure, branches[i + 1].least_pressure);
    const double greatest = std::min(branches[i].greatest_pressure, branches[i + 1].greatest_pressure);
    if (!(least < greatest)) continue;
    windows.push_back({least, greatest, maxwell_pressure(p, branches[i], branches[i + 1], least, greatest)});
  }
  return windows;
}

namespace {

/// dp0/dV [Pa/m^3].
double volume_slope(const Parameters<double>& p, double R) {
  const double area = has_table(p.closure) ? channel_factors(kappa_at(p, R)).area : 1;
  return static_pressure(p, R).slope / (4 * std::numbers::pi * power<3>(p.radius) * R * R * area);
}

/// What a loading prescribes, as a curve over R whose rising parts are stable, and the energy that a jump sets free.
class LoadCurve {
 public:
  LoadCurve(const Parameters<double>& p, const Loading& loading) : p_(p), compliance_(loading.compliance) {}

  [[nodiscard]] bool of_pressure() const { return std::isinf(compliance_); }

  /// The pressure, or the volume of balloon and supply together.
  [[nodiscard]] double value(double R) const {
    const double pressure = static_pressure(p_, R).value;
    return of_pressure() ? pressure : working_volume(p_, R) + compliance_ * pressure;
  }
  /// Same sign as the slope of value().
  [[nodiscard]] double slope(double R) const {
    return of_pressure() ? static_pressure(p_, R).slope : 1 + compliance_ * volume_slope(p_, R);
  }
  [[nodiscard]] double scale(double value) const {
    return of_pressure() ? pressure_scale(p_, value) : std::abs(value) + working_volume(p_, 1);
  }
  /// Energy of wall and supply [J] under the load of another stretch.
  [[nodiscard]] double energy(double R, double pressure) const {
    if (of_pressure()) return potential_energy(p_, R, pressure);
    return strain_energy_of(p_, R) + compliance_ / 2 * power<2>(static_pressure(p_, R).value);
  }

 private:
  const Parameters<double>& p_;
  double compliance_;
};

/// The first stable stretch beyond extrema[from] that bears its load.
std::optional<double> landing(const LoadCurve& curve, const std::vector<Extremum>& extrema, std::size_t from,
                              const Shape& shape) {
  const double load = curve.value(extrema[from].stretch);
  const auto value = [&](double R) { return curve.value(R); };
  const auto on = [&](double lo, double hi) { return stretch_at(value, load, lo, hi, curve.scale(load)); };
  if (extrema[from].maximum) {
    for (std::size_t i = from + 1; i < extrema.size(); i += 2) {
      if (const auto R =
              on(extrema[i].stretch, i + 1 < extrema.size() ? extrema[i + 1].stretch : shape.greatest_stretch())) {
        return R;
      }
    }
  } else {
    for (std::size_t i = from; i-- > 0;) {
      if (!extrema[i].maximum) continue;
      if (const auto R = on(i > 0 ? extrema[i - 1].stretch : shape.least_stretch(), extrema[i].stretch)) return R;
    }
  }
  return std::nullopt;
}

}  // namespace

bool is_stable(const Parameters<double>& p, double R, const Loading& loading) {
  return LoadCurve(p, loading).slope(R) > 0;
}

std::vector<Jump> jumps(const Parameters<double>& p, const Loading& loading) {
  const Shape shape(p);
  const LoadCurve curve(p, loading);
  const auto slope = [&](double R) { return curve.slope(R); };
  const std::vector<Extremum> folds = find_extrema(slope, shape.least_stretch(), shape.greatest_stretch());
  std::vector<Jump> found;
  for (std::size_t i = 0; i < folds.size(); ++i) {
    const double R = folds[i].stretch;
    if (!(R > 1)) continue;
    const double pressure = static_pressure(p, R).value;
    Jump jump{R, pressure, folds[i].maximum, landing(curve, folds, i, shape)};
    if (jump.to) {
      jump.to_pressure = static_pressure(p, *jump.to).value;
      jump.released = curve.energy(R, pressure) - curve.energy(*jump.to, pressure);
    }
    found.push_back(jump);
  }
  return found;
}

namespace {

struct Minimum {
  double stretch;
  double value;
};

/// The least value of a function over R > 1: its value to all digits, its place to half of them.
template <class Function>
Minimum least_value(const Function& f, const Shape& shape) {
  const double to = shape.greatest_stretch();
  const double from = std::max(1.0, shape.least_stretch());
  Minimum best{from, f(from)};
  for (double R = from; R < to; R *= search_ratio) {
    if (const double value = f(R); value < best.value) best = {R, value};
  }
  constexpr int half_of_the_digits = 26;
  const auto [R, value] = boost::math::tools::brent_find_minima(
      f, std::max(from, best.stretch / search_ratio), std::min(to, best.stretch * search_ratio), half_of_the_digits);
  return value < best.value ? Minimum{R, value} : best;
}

}  // namespace

double critical_compliance(const Parameters<double>& p) {
  const Minimum steepest = least_value([&](double R) { return volume_slope(p, R); }, Shape(p));
  return steepest.value < 0 ? -1 / steepest.value : std::numeric_limits<double>::infinity();
}

std::vector<Cusp> find_cusps(const BalloonFamily& family, double from, double to) {
  const auto least_slope = [&](double parameter) {
    const Parameters<double> p = family(parameter);
    return least_value([&](double R) { return static_pressure(p, R).slope; }, Shape(p));
  };
  constexpr int pieces = 64;
  std::vector<Cusp> cusps;
  double left = from;
  double value_left = least_slope(left).value;
  for (int k = 1; k <= pieces; ++k) {
    const double right = k == pieces ? to : from + (to - from) * k / pieces;
    const double value_right = least_slope(right).value;
    if ((value_left > 0) != (value_right > 0)) {
      const double at = root([&](double parameter) { return least_slope(parameter).value; }, left, right);
      const double R = least_slope(at).stretch;
      cusps.push_back({at, R, static_pressure(family(at), R).value});
    }
    left = right;
    value_left = value_right;
  }
  return cusps;
}

}  // namespace turgor
