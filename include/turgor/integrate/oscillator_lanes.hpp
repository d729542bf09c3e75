#pragma once
// Balloons as a hybrid system for the integrator, one in every lane: their regimes, pressure pieces, events and ends.

#include <string>

#include "turgor/integrate/exact_flow.hpp"
#include "turgor/integrate/hybrid.hpp"
#include "turgor/integrate/oscillator_flow.hpp"
#include "turgor/integrate/simulate.hpp"

namespace turgor {

/// Numbers of one lane inside those of all.
template <class V, class All, class One>
void set_lane_numbers(All& all, int l, const One& one) {
  static_assert(sizeof(All) / sizeof(V) == sizeof(One) / sizeof(ScalarOf<V>));
  // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): both are nothing but so many numbers
  auto* numbers = reinterpret_cast<V*>(&all);
  const auto* given = reinterpret_cast<const ScalarOf<V>*>(&one);
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  for (std::size_t i = 0; i < sizeof(All) / sizeof(V); ++i) lane(numbers[i], l) = given[i];
}

/// One balloon on its way.
template <class T>
struct BalloonInLane {
  const Oscillator<T>* oscillator = nullptr;
  const SimulationOptions<T>* options = nullptr;
  T end{0};
  const SmoothPressure<T>* pressure = nullptr;
  Regime regime = Regime::rest;
  long events = 0;
  bool held = false;  ///< it has stood still for a while
  Outcome outcome = Outcome::reached_end;
  std::string message;
};

/// @tparam Observer  is told what happens: steps(lanes, which, start, h, dense), hold(lanes, l, duration) before time
///                   moves on, event(lanes, l, before, after), finished(lanes, l)
template <class V, class Observer>
class OscillatorLanes {
 public:
  using Value = V;
  using T = ScalarOf<V>;
  static constexpr int size = 2;
  static constexpr bool stiff = true;
  static constexpr int width = Lanes<V>::width;
  using Integrator = HybridIntegrator<OscillatorLanes>;
  using State = Eigen::Matrix<V, 2, 1>;  // (R, dR/dT)

  /// @param material  of all lanes; their constants may differ
  /// @param table     of all lanes' closures: Oscillator::force_table()
  OscillatorLanes(const Material<V>& material, const ForceTable* table, StepMethod method, Observer& observer)
      : integrator_(*this, method), observer_(observer), material_(material), table_(table) {}

  /// Puts a balloon into a lane. It starts at once, or stays at rest to its end, in which case it is finished already.
  void load(int l, const Oscillator<T>& oscillator, const T& start, const T& stretch, const T& rate, const T& end,
            const SimulationOptions<T>& options) {
    BalloonInLane<T>& b = own(l);
    b = {};
    b.oscillator = &oscillator;
    b.options = &options;
    b.end = end;
    integrator_.load(l, start, end, {options.rtol, options.atol});
    integrator_.component(l, 0) = stretch;
    integrator_.component(l, 1) = rate;
    lane(steps_, l) = T(0);
    set_lane(l);
    go_on(l);
  }
  void run() { integrator_.run(); }

  [[nodiscard]] Integrator& integrator() { return integrator_; }
  [[nodiscard]] const Integrator& integrator() const { return integrator_; }
  [[nodiscard]] const BalloonInLane<T>& balloon(int l) const { return balloons_[static_cast<std::size_t>(l)]; }
  [[nodiscard]] Point<T> point(int l) const {
    return {integrator_.time(l), integrator_.component(l, 0), integrator_.component(l, 1), balloon(l).regime};
  }

  /// P(T) in every lane.
  [[nodiscard]] V pressure(const V& time) const { return numbers_.forcing.value(time, harmonic_); }
  /// a(R) in every lane.
  [[nodiscard]] V area(const V& R) const {
    const V square = R * R;
    return table_ == nullptr ? square : channel_factors(V(numbers_.inertia.kappa / R)).area * square;
  }
  /// -(M'/2 + Q) v^3: what the outflow carries off; with the fits it vanishes during inflation.
  [[nodiscard]] V dissipation_rate(const V& R, const V& v) const {
    if (table_ != nullptr) {
      const FlowCoefficients<V> c = numbers_.inertia.exact(*table_, R);
      return -(V(T(0.5)) * c.mass_slope + c.centripetal) * v * v * v;
    }
    const V r3 = R * R * R;
    return -(V(T(0.5)) * numbers_.inertia.mass_slope(r3) + numbers_.inertia.centripetal(r3)) * v * v * v;
  }
  struct Energies {
    V kinetic;
    V elastic;
  };
  [[nodiscard]] Energies energies() const {
    const V& R = integrator_.component(0);
    const V& v = integrator_.component(1);
    const V mass = table_ == nullptr ? numbers_.inertia.mass(R * R * R, R) : numbers_.inertia.exact(*table_, R).mass;
    Energies now{V(T(0.5)) * mass * v * v, V(0)};
    std::visit([&](const auto& solid) { now.elastic = numbers_.elastic_factor * solid.energy(R).value; }, material_);
    return now;
  }

  /// All about one lane, to go on with it among lanes that use another method.
  struct Parked {
    typename Integrator::Parked at;
    BalloonInLane<T> balloon;
    T steps;
  };
  [[nodiscard]] Parked park(int l) const { return {integrator_.park(l), balloon(l), lane(steps_, l)}; }
  void resume(int l, const Parked& parked) {
    own(l) = parked.balloon;
    integrator_.resume(l, parked.at);
    set_lane(l);
    set_flow(l);
    lane(steps_, l) = parked.steps;
  }
  /// Lanes, by bits, whose balloons want the other method; they stand still from here on.
  [[nodiscard]] unsigned take_leaving() { return std::exchange(leaving_, 0U); }

  // What the integrator asks for: see HybridSystem.

  template <class Action>
  void with_flow(const Action& action) const {
    if (table_ != nullptr) {
      action(ExactFlow<V>(numbers_, material_, *table_, harmonic_));
      return;
    }
    std::visit(
        [&](const auto& solid) {
          action(OscillatorFlow<V, std::remove_cvref_t<decltype(solid)>>(numbers_, solid, harmonic_));
        },
        material_);
  }
  /// dR/dT changes sign; the wall bursts.
  [[nodiscard]] std::size_t crossings() const { return may_burst_ ? 2 : 1; }
  [[nodiscard]] Crossing<V> crossing(std::size_t i) const {
    if (i == 0) return {1, V(0), sign_};
    return {0, burst_, V(-1)};
  }
  /// Rounding of the rate over a step, relative to the terms whose difference is the acceleration at rest.
  [[nodiscard]] T noise(const Integrator& /*lanes*/, int l, std::size_t i, const T& h) const {
    if (i != 0) return T(0);
    const BalloonInLane<T>& b = balloon(l);
    const Coefficients<T> c = b.oscillator->coefficients(b.regime, integrator_.component(l, 0));
    const T p = (*b.pressure)(integrator_.time(l));
    return 64 * std::numeric_limits<T>::epsilon() * h * (std::abs(c.elastic) + std::abs(c.area * p)) / c.mass;
  }

  void on_event(Integrator& /*lanes*/, int l, std::size_t i) {
    const BalloonInLane<T>& b = own(l);
    if (i == 1) {
      fail(l, Outcome::burst, "the wall reached material.max_stretch and bursts");
      return;
    }
    const Regime before = b.regime;
    decide_at_rest(l);
    if (running(l) && b.regime != before) enter(l);
  }
  void on_target(Integrator& /*lanes*/, int l) { go_on(l); }
  void on_stall(Integrator& /*lanes*/, int l) {
    const Standstill why = standstill(*balloon(l).oscillator, integrator_.component(l, 0));
    fail(l, why.outcome, why.text);
  }
  void on_method_due(Integrator& /*lanes*/, int l) {
    leaving_ |= 1U << l;
    integrator_.retire(l);
  }
  template <class Condition>
  void on_steps(Integrator& /*lanes*/, const Condition& which, const V& start, const V& h,
                const DenseState<State>& dense) {
    steps_ = select(which, steps_ + V(1), steps_);
    const V& R = stretch();
    observer_.steps(*this, which, start, h, dense);
    const auto done = which && (R > runaway_ || steps_ >= most_steps_);
    if (any(done)) check_limits(bits(done));
    if constexpr (width == 1) {
      const auto& options = *balloon(0).options;
      if (running(0) && options.keep_going && !options.keep_going(integrator_.time(0))) {
        stop(0, Outcome::interrupted, "interrupted");
      }
    }
  }

 private:
  static constexpr T never = T(1e100);

  /// Copies one lane's constants into the common material, alternative by alternative.
  struct OneMaterial {
    int l;
    const Material<T>& given;

    template <template <class> class Solid>
    void operator()(Solid<V>& all) const {
      set_lane_numbers<V>(all, l, std::get<Solid<T>>(given));
    }
    void operator()(Ogden<V>& all) const {
      const auto& one = std::get<Ogden<T>>(given);
      for (std::size_t p = 0; p < all.mu.size(); ++p) {  // shorter ones are filled up with terms that vanish
        lane(all.mu[p], l) = p < one.mu.size() ? one.mu[p] : T(0);
        lane(all.alpha[p], l) = p < one.alpha.size() ? one.alpha[p] : T(1);
      }
    }
    void operator()(Tabulated<V>& all) const {
      all.tables[static_cast<std::size_t>(l)] = std::get<Tabulated<T>>(given).tables[0];
    }
  };

  /// What stays the same for a balloon all the way.
  void set_lane(int l) {
    const SimulationOptions<T>& options = *balloon(l).options;
    lane(burst_, l) = options.max_stretch > T(0) ? options.max_stretch : never;
    may_burst_ = may_burst_ || options.max_stretch > T(0);
    lane(runaway_, l) = options.runaway_stretch;
    lane(most_steps_, l) = static_cast<T>(options.max_steps);
    const OneMaterial set{l, balloon(l).oscillator->parameters().material};
    std::visit(set, material_);
  }

  [[nodiscard]] BalloonInLane<T>& own(int l) { return balloons_[static_cast<std::size_t>(l)]; }
  [[nodiscard]] const V& stretch() const { return integrator_.component(0); }
  [[nodiscard]] bool running(int l) const { return integrator_.running(l); }

  /// On from the current time, under the pressure that holds after it.
  void go_on(int l) {
    BalloonInLane<T>& b = own(l);
    while (true) {
      const T time = integrator_.time(l);
      if (!(time < b.end)) {
        finish(l);
        return;
      }
      b.pressure = &b.oscillator->pressure().after(time);
      if (integrator_.component(l, 1) == T(0)) {
        decide_at_rest(l);
        if (!running(l)) return;
      } else if (b.regime == Regime::rest) {
        b.regime = integrator_.component(l, 1) > T(0) ? Regime::inflating : Regime::deflating;
      }
      if (b.regime != Regime::rest) break;
      const T target = std::min(b.end, b.oscillator->pressure().next_knot(time));
      observer_.hold(*this, l, target - time);
      b.held = true;
      integrator_.time(l) = target;
    }
    enter(l);
  }

  /// Sets the flow of the present regime and pressure, and the time up to which it holds.
  void enter(int l) {
    set_flow(l);
    const BalloonInLane<T>& b = balloon(l);
    integrator_.aim(l, std::min(b.end, b.oscillator->pressure().next_knot(integrator_.time(l))));
    const bool at_rest = integrator_.component(l, 1) == T(0);
    const int from_rest = b.regime == Regime::inflating ? 0 : 1;
    integrator_.restart(l, at_rest ? from_rest : -1);
    // From rest nothing is stiff yet.
    if (width > 1 && at_rest && integrator_.method() == StepMethod::rosenbrock) on_method_due(integrator_, l);
  }
  void set_flow(int l) {
    const BalloonInLane<T>& b = balloon(l);
    const FlowNumbers<T> numbers = flow_numbers(*b.oscillator, *b.pressure, b.regime);
    set_lane_numbers<V>(numbers_, l, numbers);
    harmonic_ = harmonic_ || numbers.forcing.amplitude != T(0);
    lane(sign_, l) = b.regime == Regime::inflating ? T(1) : T(-1);
  }

  /// At dR/dT = 0: the regime is decided anew; a change is an event, except at the start.
  void decide_at_rest(int l) {
    BalloonInLane<T>& b = own(l);
    const Regime before = b.regime;
    b.regime = regime_from_rest(*b.oscillator, *b.pressure, integrator_.time(l), integrator_.component(l, 0));
    if (b.regime == before || !(b.held || lane(steps_, l) > T(0))) return;
    const bool rests =
        is_settled(*b.oscillator, *b.pressure, integrator_.time(l), integrator_.component(l, 0), b.options->rest_tol);
    if (rests) b.regime = Regime::rest;
    ++b.events;
    observer_.event(*this, l, before, b.regime);
    if (rests) {
      stop(l, Outcome::at_rest, "");
    } else if (b.options->max_events > 0 && b.events >= b.options->max_events) {
      stop(l, Outcome::max_events, "");
    }
  }

  void check_limits(unsigned which) {
    for (int l = 0; l < width; ++l) {
      if ((which >> l & 1U) == 0) continue;
      const BalloonInLane<T>& b = balloon(l);
      if (integrator_.component(l, 0) > b.options->runaway_stretch) {
        fail(l, Outcome::runaway, "the balloon runs away: nothing holds it at this pressure");
      } else if (integrator_.time(l) < b.end) {
        fail(l, Outcome::max_steps, "more than " + std::to_string(b.options->max_steps) + " steps");
      }
    }
  }

  void finish(int l) {
    integrator_.retire(l);
    observer_.finished(*this, l);
  }
  void stop(int l, Outcome outcome, std::string message) {
    own(l).outcome = outcome;
    own(l).message = std::move(message);
    finish(l);
  }
  void fail(int l, Outcome outcome, const std::string& what) {
    stop(l, outcome, what + whereabouts(*balloon(l).oscillator, point(l)));
  }

  Integrator integrator_;
  Observer& observer_;
  Material<V> material_;
  const ForceTable* table_;
  FlowNumbers<V> numbers_{};
  bool harmonic_ = false;  ///< some lane's pressure has a sine
  bool may_burst_ = false;
  unsigned leaving_ = 0;
  V sign_ = V(1);  ///< of the regime
  V burst_ = V(never);
  V runaway_ = V(0);
  V steps_ = V(0);
  V most_steps_ = V(0);
  std::array<BalloonInLane<T>, static_cast<std::size_t>(width)> balloons_{};
};

}  // namespace turgor
