#include "turgor/integrate/quadrature.hpp"

#include "hybrid_run.hpp"
#include "panel.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

template <class T>
class QuadratureRun final : public HybridRun<T> {
 public:
  using HybridRun<T>::HybridRun;

 private:
  static constexpr T epsilon = std::numeric_limits<T>::epsilon();
  using Run = HybridRun<T>;
  using Run::append;
  using Run::check_limits;
  using Run::fail;
  using Run::options_;
  using Run::rate_;
  using Run::regime_;
  using Run::result_;
  using Run::stretch_;
  using Run::time_;

  void start_anew() override {
    h_ = T(0);
    way_to_turn_.reset();
  }

  /// Takes one accepted panel. Its extent in tau, about its duration, is chosen as a step size is.
  void advance(const T& target) override {
    const Stroke<T> stroke(this->oscillator_, regime_, this->current_pressure(), result_.statistics.rate_evaluations);
    const auto drive = stroke.at(place());
    const T energy = drive.mass * rate_ * rate_;
    const T pull = drive.acceleration(energy);
    if (!(h_ > T(0))) h_ = T(0.5) / drive.frequency(stretch_, rate_);
    // A panel that reaches far beyond the target would only be cut.
    h_ = std::min(h_, T(1.05) * (target - time_));
    const bool braking = rate_ != T(0) && this->direction() * pull < T(0);
    const T stopping_time = braking ? std::abs(rate_ / pull) : std::numeric_limits<T>::infinity();
    if (h_ > stopping_time / 2) {
      if (const auto last = to_the_turn(stroke, energy, std::abs(rate_) * stopping_time / 2)) {
        accept(*last, target);
        return;
      }
      h_ = stopping_time / 2;  // far enough from where the path would turn back
    }
    bool rejected = false;
    while (true) {
      const BallisticPath<T> path{rate_, pull};
      if (!(time_ + h_ > time_)) {
        const Standstill why = standstill(this->oscillator_, stretch_);
        fail(why.outcome, why.text);
        return;
      }
      const auto panel = Panel<T>::make(stroke, path, {place(), energy, T(0), h_, false});
      const T error = panel ? panel->error(tolerance()) : std::numeric_limits<T>::quiet_NaN();
      if (error <= T(1)) {
        h_ *= std::min(rejected ? T(1) : T(4), T(0.9) * std::pow(std::max(error, T(1e-8)), T(-0.125)));
        accept(*panel, target);
        return;
      }
      ++result_.statistics.rejected;
      rejected = true;
      h_ *= std::isfinite(error) ? std::max(T(0.2), T(0.9) * std::pow(error, T(-0.125))) : T(0.5);
    }
  }

  /// The panel from here to the turning point, when that is so near that it takes only one.
  /// @param stopping_way  where the present deceleration alone would turn the motion
  std::optional<Panel<T>> to_the_turn(const Stroke<T>& stroke, const T& energy, const T& stopping_way) {
    if (!way_to_turn_) {
      way_to_turn_ = stroke.way_to_turn(place(), energy, this->direction() * 4 * stopping_way);
      ++result_.statistics.event_refinements;
      if (!way_to_turn_) return std::nullopt;
    }
    const T way = *way_to_turn_;
    const auto drive = stroke.at(place().moved(way));
    const T pull = drive.force / drive.mass;
    if (!(std::abs(way) < T(1.6) * stopping_way) || !(way * pull < T(0))) return std::nullopt;
    const BallisticPath<T> path{T(0), pull};
    const T tau = -std::sqrt(-2 * way / pull);
    auto panel = Panel<T>::make(stroke, path, {place(), energy, tau, T(0), true});
    if (!panel || !(panel->error(tolerance()) <= T(1))) return std::nullopt;
    return panel;
  }

  [[nodiscard]] Place<T> place() const { return {stretch_, rest_}; }

  [[nodiscard]] typename Panel<T>::Tolerance tolerance() const { return {options_.rtol / 10, options_.atol / 10}; }

  /// Keeps a panel, cut at the target and at the stretch at which the wall bursts.
  void accept(Panel<T> panel, const T& target) {
    const bool bursts =
        options_.max_stretch > T(0) && regime_ == Regime::inflating && panel.end().stretch >= options_.max_stretch;
    std::optional<Panel<T>> part = panel;
    if (bursts) part = panel.cut_at(options_.max_stretch);
    const T left = target - time_;
    const bool reaches = part && part->duration() >= left * (1 - 8 * epsilon);
    const bool passes = reaches && part->duration() > left * (1 + 8 * epsilon);
    if (passes) part = part->cut(left);
    if (!part) {
      fail(Outcome::step_failed, "the motion is smaller than what the numbers resolve");
      return;
    }
    if (way_to_turn_) *way_to_turn_ -= part->way();
    const T duration = reaches ? left : part->duration();
    const T end_rate = part->ends_at_turn() ? T(0) : part->end_rate();
    append(part->dense(time_, duration), reaches ? target : time_ + duration,
           bursts && !passes ? options_.max_stretch : part->end().stretch, end_rate);
    rest_ = part->end().rest;
    if (part->ends_at_turn()) start_anew();
    if (bursts && !passes) {
      fail(Outcome::burst, "the wall reached material.max_stretch and bursts");
    } else {
      check_limits();
    }
  }

  T h_{0};                        ///< extent in tau proposed for the next panel; 0: to be chosen
  T rest_{0};                     ///< of the stretch, which its last digit cannot hold
  std::optional<T> way_to_turn_;  ///< to the turning point ahead, once known
};

}  // namespace

template <class T>
Trajectory<T> simulate_by_quadrature(const Oscillator<T>& oscillator, const T& start_time, const T& stretch,
                                     const T& rate, const T& end_time, const SimulationOptions<T>& options) {
  check_start(oscillator, start_time, stretch, rate, end_time, options);
  require_piecewise_constant(oscillator.pressure(), start_time, end_time, oscillator.scales().time);
  return QuadratureRun<T>(oscillator, start_time, stretch, rate, end_time, options).run();
}

template <class T>
void require_piecewise_constant(const PressureProgram<T>& program, const T& start, const T& end, const T& clock) {
  const auto& pieces = program.pieces();
  const auto seconds = [&](const T& t) { return rounded(static_cast<double>(t * clock), 8) + " s"; };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool last = i + 1 == pieces.size();
    const T from = i == 0 ? start : std::max(start, pieces[i].start);
    const T to = last ? end : std::min(end, pieces[i + 1].start);
    if (from >= to || pieces[i].pressure.is_constant()) continue;
    throw InvalidInput("solve.method", "quadrature",
                       "the pressure is not constant from " + seconds(from) + " to " + seconds(to) + " (piece " +
                           std::to_string(i + 1) + " of the program)",
                       "use solve.method = \"adaptive\", or hold and step in place of ramps");
  }
}

template Trajectory<double> simulate_by_quadrature(const Oscillator<double>&, const double&, const double&,
                                                   const double&, const double&, const SimulationOptions<double>&);
template Trajectory<long double> simulate_by_quadrature(const Oscillator<long double>&, const long double&,
                                                        const long double&, const long double&, const long double&,
                                                        const SimulationOptions<long double>&);
template void require_piecewise_constant(const PressureProgram<double>&, const double&, const double&, const double&);
template void require_piecewise_constant(const PressureProgram<long double>&, const long double&, const long double&,
                                         const long double&);

}  // namespace turgor
