#pragma once
// Time integration of small hybrid systems: smooth flows y' = f(t, y), one per regime, between events at which a
// component of the state crosses a level and the regime or the state itself changes.
//
// One integrator serves a single trajectory (its value type is double or long double) and ensembles (a SIMD batch of
// doubles: every lane is a trajectory of its own, on its own clock, with its own step size, events and parameters; no
// lane's numbers depend on another's).

#include <algorithm>
#include <bit>
#include <concepts>

#include "turgor/integrate/dense_polynomial.hpp"
#include "turgor/integrate/dop853.hpp"
#include "turgor/integrate/rosenbrock.hpp"

namespace turgor {

/// An event happens where sign (y[component] - level) goes from positive to negative; lanes may differ in all but the
/// component. What is linear in the state is so along dense output too: zeros of a polynomial can be found without a
/// miss. A level far away switches the event off.
template <class V>
struct Crossing {
  Eigen::Index component;
  V level;
  V sign;
};

/// The two methods the integrator changes between.
enum class StepMethod {
  explicit_pair,  ///< DOP853, order 8: stretches that are not stiff
  rosenbrock,     ///< Rodas5P, order 5, L-stable: stiff stretches
};

/// Lets lanes of a hybrid system be integrated. A system has
///   - Value, the value type; `size`, the number of components of the state, or Eigen::Dynamic; `stiff`, whether its
///     flows may be stiff
///   - with_flow(action): calls action(flow) with the flow of all lanes in their present regimes; a flow has
///     rate(t, y), and if it may be stiff also linearize(t, y) and stiffness(t, y), the spectral radius of its Jacobian
///   - crossings() and crossing(i): how many events are watched, and which
///   - noise(integrator, lane, i, h): below this, the i-th event's function is nothing but rounding after a step h
///   - on_event(integrator, lane, i): the lane stands at event i, that component exactly at its level
///   - on_target(integrator, lane): the lane stands at its target time
///   - on_stall(integrator, lane): the step size fell below what the clock resolves
///   - on_method_due(integrator, lane): of several lanes, this one wants the other method
///   - on_steps(integrator, condition, start, h, dense output): lanes that satisfy the condition took a step; they
///     already stand at its end. May retire lanes.
/// on_event and on_target change the lane's regime or state as they see fit and call restart(), aim() or retire().
template <class System>
concept HybridSystem = requires {
  typename System::Value;
  { System::size } -> std::convertible_to<int>;
  { System::stiff } -> std::convertible_to<bool>;
};

template <HybridSystem System>
class HybridIntegrator {
 public:
  using V = typename System::Value;
  using T = ScalarOf<V>;
  static constexpr int N = System::size;
  static constexpr int width = Lanes<V>::width;
  using State = Eigen::Matrix<V, N, 1>;
  using Condition = decltype(V(0) > V(0));

  /// Step sizes at the beginning of a stretch are remembered for the next stretch of the same kind: half-cycles
  /// resemble each other, and error estimates there are fooled by the symmetry about a state of rest.
  static constexpr std::size_t remembered = 4;
  struct Notes {
    int kind = -1;          ///< of the stretch under way
    std::size_t steps = 0;  ///< taken in it
    bool keeps_size = false;
    std::array<std::array<T, remembered>, 2> sizes{};
  };

  /// @param components  of the state; to be given where the system's size is Eigen::Dynamic
  HybridIntegrator(System& system, StepMethod method, Eigen::Index components = N)
      : system_(system),
        first_method_(method),
        method_(method),
        state_(zero(components)),
        rate_(zero(components)),
        end_rate_(zero(components)) {}

  /// Starts a lane at time t and aims it at a target time; its state is set through component().
  void load(int l, const T& t, const T& target, const Tolerances<T>& tolerances) {
    lane(time_, l) = t;
    lane(target_, l) = target;
    lane(tolerances_.rtol, l) = tolerances.rtol;
    lane(tolerances_.atol, l) = tolerances.atol;
    lane(running_, l) = T(1);
    // nothing is left of what was in the lane before
    lane(caution_, l) = lane(usual_caution_, l) = explicit_caution(tolerances.rtol);
    if constexpr (width == 1) method_ = first_method_;
    notes_[static_cast<std::size_t>(l)] = {};
    restart(l, -1);
  }
  [[nodiscard]] T& component(int l, Eigen::Index i) { return lane(state_[i], l); }
  [[nodiscard]] const T& component(int l, Eigen::Index i) const { return lane(state_[i], l); }
  [[nodiscard]] const V& component(Eigen::Index i) const { return state_[i]; }
  [[nodiscard]] const V& time() const { return time_; }
  [[nodiscard]] T& time(int l) { return lane(time_, l); }
  [[nodiscard]] const T& time(int l) const { return lane(time_, l); }

  /// The lane's flow or state has changed. Restarts of a kind 0 or 1 begin with the step size that suited the last
  /// one of that kind; -1 chooses afresh.
  void restart(int l, int kind) {
    fresh_ |= 1U << l;
    notes_[static_cast<std::size_t>(l)].kind = kind;
  }
  /// A new target time.
  void aim(int l, const T& target) { lane(target_, l) = target; }
  /// The lane is done.
  void retire(int l) { lane(running_, l) = T(0); }

  [[nodiscard]] StepMethod method() const { return method_; }

  /// All about one lane, to go on with it elsewhere.
  struct Parked {
    T time, target, size, growth_limit, caution;
    Tolerances<T> tolerances;
    std::array<T, static_cast<std::size_t>(N > 0 ? N : 0)> state;
    Notes notes;
    bool fresh;
  };
  [[nodiscard]] Parked park(int l) const
    requires(N > 0)
  {
    Parked parked{lane(time_, l),
                  lane(target_, l),
                  lane(size_, l),
                  lane(growth_limit_, l),
                  lane(caution_, l),
                  {lane(tolerances_.rtol, l), lane(tolerances_.atol, l)},
                  {},
                  notes_[static_cast<std::size_t>(l)],
                  (fresh_ >> l & 1U) != 0};
    for (std::size_t i = 0; i < parked.state.size(); ++i) {
      parked.state[i] = lane(state_[static_cast<Eigen::Index>(i)], l);
    }
    return parked;
  }
  void resume(int l, const Parked& parked)
    requires(N > 0)
  {
    load(l, parked.time, parked.target, parked.tolerances);
    lane(size_, l) = parked.size;
    lane(growth_limit_, l) = parked.growth_limit;
    lane(caution_, l) = parked.caution;
    for (std::size_t i = 0; i < parked.state.size(); ++i) {
      component(l, static_cast<Eigen::Index>(i)) = parked.state[i];
    }
    notes(l) = parked.notes;
    if (!parked.fresh) fresh_ &= ~(1U << l);
  }

  [[nodiscard]] bool running() const { return any(running_ > V(0)); }
  [[nodiscard]] bool running(int l) const { return lane(running_, l) > T(0); }
  [[nodiscard]] IntegratorStatistics& statistics() { return statistics_; }

  /// Takes steps until every lane is retired.
  void run() {
    while (running()) advance();
  }

  /// One attempt of a step in every lane.
  void advance() {
    using std::min;
    if (fresh_ != 0) start_lanes();
    const Condition active = running_ > V(0);
    const V left = target_ - time_;
    const Condition reaches = active && size_ >= left * V(1 - 8 * epsilon);
    // Two even steps rather than one and a splinter.
    const V h = select(reaches, left, select(V(2) * size_ > left, V(T(0.5)) * left, size_));
    const Condition stalled = active && !reaches && !(time_ + h > time_);
    attempt(h);

    const Condition good = active && !stalled && error_ <= V(1);
    const Condition bad = active && !good;
    const Condition special = good && (reaches || may_cross());
    const Condition plain = good && !special;
    const V start = time_;
    const V factor = step_factor();
    const V grown = h * min(factor, growth_limit_);
    const V shrunk = h * select(error_ <= V(std::numeric_limits<T>::max()), min(factor, V(T(0.9))), V(T(0.1)));
    size_ = select(plain, grown, select(bad, shrunk, size_));
    growth_limit_ = select(bad, V(1), select(good, V(5), growth_limit_));
    caution_ = select(good, usual_caution_, caution_);
    statistics_.steps += std::popcount(bits(good));
    statistics_.rejected += std::popcount(bits(bad));
    if (any(plain)) {
      commit(plain, h);
      for_lanes(plain, [&](int l) { remember(l, lane(h, l)); });
      system_.on_steps(*this, plain, start, h, dense_);
      if constexpr (System::stiff) change_method(plain, h);
    }
    for_lanes(special, [&](int l) { finish_special(l, lane(h, l), lane(grown, l), (bits(reaches) >> l & 1U) != 0); });
    for_lanes(stalled, [&](int l) { system_.on_stall(*this, l); });
  }

 private:
  /// DOP853's estimate is close to its error, Rodas5P's far above it: this makes both keep a tolerance equally well.
  /// Tolerances not far above rounding leave less room for it.
  [[nodiscard]] static T explicit_caution(const T& rtol) { return std::clamp(rtol / (10'000 * epsilon), T(1), T(10)); }
  /// In a first step from rest the solution is even in time, and the estimates miss half of its terms.
  static constexpr T first_step_caution = T(30);
  static constexpr T epsilon = std::numeric_limits<T>::epsilon();

  [[nodiscard]] static State zero(Eigen::Index components) { return State::Constant(components, V(0)); }

  template <class Action>
  static void for_lanes(const Condition& which, const Action& action) {
    if (!any(which)) return;
    for (int l = 0; l < width; ++l) {
      if ((bits(which) >> l & 1U) != 0) action(l);
    }
  }

  /// Rates and first step sizes of lanes that were restarted: Hairer, Norsett & Wanner I, section II.4.
  void start_lanes() {
    using std::abs;
    using std::max;
    using std::min;
    if constexpr (width == 1) {
      const bool from_rest = notes(0).kind >= 0 && !notes(0).keeps_size;
      if (from_rest) method_ = StepMethod::explicit_pair;  // nothing is stiff yet
    }
    V guess(0);
    V by_rate(0);
    bool known = true;
    for (int l = 0; l < width; ++l) {
      known = known && ((fresh_ >> l & 1U) == 0 || notes(l).keeps_size || known_first_step(l) > T(0));
    }
    system_.with_flow([&](const auto& flow) {
      rate_ = flow.rate(time_, state_);
      ++statistics_.rate_evaluations;
      if (known) return;
      const V zero(0);
      V d0(1);  // a state of zero is one within its tolerance of it
      V d1(0);
      for (Eigen::Index i = 0; i < state_.size(); ++i) {
        const V unit = V(1) / tolerances_.scale(state_, state_, i);
        d0 = max(d0, abs(state_[i]) * unit);
        d1 = max(d1, abs(rate_[i]) * unit);
      }
      const V left = target_ - time_;
      by_rate = select(d1 > zero, d0 / d1, left);
      const V euler = min(V(T(0.01)) * by_rate, V(T(0.1)) * left);
      ++statistics_.rate_evaluations;
      const State moved = flow.rate(time_ + euler, state_ + euler * rate_);
      V steepest = d1;
      for (Eigen::Index i = 0; i < state_.size(); ++i) {
        steepest = max(steepest, abs(moved[i] - rate_[i]) / (euler * tolerances_.scale(state_, state_, i)));
      }
      guess = steepest;
    });
    for (int l = 0; l < width; ++l) {
      if ((fresh_ >> l & 1U) == 0 || std::exchange(notes(l).keeps_size, false)) continue;
      lane(growth_limit_, l) = T(10);
      notes(l).steps = 0;
      if (notes(l).kind >= 0) lane(caution_, l) = lane(usual_caution_, l) * first_step_caution;
      if (known_first_step(l) > T(0)) {
        lane(size_, l) = known_first_step(l);
        continue;
      }
      const T left = lane(target_, l) - lane(time_, l);
      const int order = method_ == StepMethod::explicit_pair ? Dop853<T>::order : Rodas5P<T>::order;
      const T steepest = lane(guess, l);
      const T by_order = steepest > T(0) ? std::pow(T(0.01) / steepest, T(1) / static_cast<T>(order + 1)) : left;
      lane(size_, l) = std::min({by_order, lane(by_rate, l), left / 10});
    }
    fresh_ = 0;
  }
  /// What suited the last first step of the same kind; 0 when there was none.
  [[nodiscard]] T known_first_step(int l) const {
    const Notes& note = notes_[static_cast<std::size_t>(l)];
    return note.kind < 0 ? T(0) : note.sizes[static_cast<std::size_t>(note.kind)].front();
  }

  void attempt(const V& h) {
    system_.with_flow([&](const auto& flow) {
      if (System::stiff && method_ == StepMethod::rosenbrock) {
        if constexpr (System::stiff) attempt_rosenbrock(flow, h);
      } else {
        attempt_explicit(flow, h);
      }
    });
  }

  template <class Flow>
  void attempt_explicit(const Flow& flow, const V& h) {
    auto step = dop853_step(flow, time_, state_, rate_, h);
    error_ = error_norm(step, state_, h, tolerances_) * caution_;
    end_ = step.end;
    statistics_.rate_evaluations += static_cast<long>(Dop853<T>::stages) - 1;
    if (!any(error_ <= V(1))) return;
    dense_ = dense_output(flow, time_, state_, h, step);
    end_rate_ = step.k[Dop853<T>::stages];
    statistics_.rate_evaluations += 4;
  }

  template <class Flow>
  void attempt_rosenbrock(const Flow& flow, const V& h) {
    const auto step = rosenbrock_step(flow, time_, state_, flow.linearize(time_, state_), h);
    error_ = error_norm(step, state_, tolerances_);
    end_ = step.end;
    dense_ = step.polynomial;
    statistics_.rate_evaluations += static_cast<long>(Rodas5P<T>::stages) - 1;
    ++statistics_.linearizations;
    ++statistics_.factorizations;
  }

  /// What to multiply a step size by after this error; sqrt alone, so that it rounds alike everywhere.
  [[nodiscard]] V step_factor() const {
    using std::max;
    using std::sqrt;
    const V eighth = sqrt(sqrt(sqrt(error_)));
    const V root = method_ == StepMethod::explicit_pair ? eighth : eighth * sqrt(eighth);  // error^(3/16), nearly 1/5
    return max(V(T(0.2)), V(T(0.9)) / root);
  }

  /// Dense output of one crossing's function: positive before the event.
  [[nodiscard]] DensePolynomial<V> function(const Crossing<V>& crossing) const {
    DensePolynomial<V> c;
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = crossing.sign * dense_[k][crossing.component];
    c[0] -= crossing.sign * crossing.level;
    return c;
  }
  [[nodiscard]] DensePolynomial<T> function(int l, const Crossing<V>& crossing) const {
    DensePolynomial<T> c;
    const T sign = lane(crossing.sign, l);
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = sign * lane(dense_[k][crossing.component], l);
    c[0] -= sign * lane(crossing.level, l);
    return c;
  }

  /// Lanes in which an event cannot be ruled out by the convex hull of its function.
  [[nodiscard]] Condition may_cross() const {
    using std::min;
    V least(std::numeric_limits<T>::max());
    for (std::size_t i = 0; i < system_.crossings(); ++i) {
      const DensePolynomial<V> c = function(system_.crossing(i));
      const V bound = lower_bound(c);
      if (!any(bound < V(0))) continue;
      V hull = c[0];
      for (const V& coefficient : bernstein(c)) hull = min(hull, coefficient);
      least = min(least, hull);
    }
    return least < V(0);
  }

  void commit(const Condition& which, const V& h) {
    time_ = select(which, time_ + h, time_);
    for (Eigen::Index i = 0; i < state_.size(); ++i) {
      state_[i] = select(which, end_[i], state_[i]);
      rate_[i] = select(which, end_rate_[i], rate_[i]);
    }
  }

  /// What to begin the same step of the next such stretch with; and this stretch's next step, from the last one's.
  void remember(int l, const T& h) {
    Notes& note = notes(l);
    if (note.kind < 0 || note.steps >= remembered) return;
    auto& sizes = note.sizes[static_cast<std::size_t>(note.kind)];
    T& size = lane(size_, l);
    sizes[note.steps] = std::min(size, 2 * h);
    ++note.steps;
    if (note.steps < remembered && sizes[note.steps] > T(0)) size = std::min(size, sizes[note.steps]);
  }

  /// Explicit steps that stability limits, or implicit ones that accuracy limits, say that the other method is due.
  void change_method(const Condition& which, const V& h) {
    V radius;
    system_.with_flow([&](const auto& flow) { radius = flow.stiffness(time_, state_); });
    // The explicit pair is stable up to about 6 on the negative axis, but long before that it follows a solution on a
    // slow manifold in stumbles; the other method's first steps onto the manifold are short.
    const Condition unfit = method_ == StepMethod::explicit_pair ? h * radius > V(2) : h * radius < V(T(0.5));
    const Condition due = which && unfit && running_ > V(0);  // the step may have been a lane's last
    for_lanes(due, [&](int l) { leave_method(l); });
  }
  /// A single lane changes its method; one of many is handed to others that use the other method.
  void leave_method(int l) {
    restart_as_is(l);
    if constexpr (width == 1) {
      method_ = method_ == StepMethod::explicit_pair ? StepMethod::rosenbrock : StepMethod::explicit_pair;
    } else {
      system_.on_method_due(*this, l);
    }
  }
  /// The method changes, the flow does not: the step size stays, only the rate is needed.
  void restart_as_is(int l) {
    fresh_ |= 1U << l;
    notes(l).keeps_size = true;
  }

  /// A step of one lane that ends at its target or may have run over an event.
  void finish_special(int l, const T& h, const T& grown, bool reaches) {
    T first(2);
    std::size_t which = 0;
    for (std::size_t i = 0; i < system_.crossings(); ++i) {
      const DensePolynomial<T> c = function(l, system_.crossing(i));
      if (lower_bound(c) >= T(0)) continue;
      const auto part = first_fall<T>({T(0), T(1), bernstein(c)}, system_.noise(*this, l, i, h), search_depth);
      if (!part) continue;
      const T root = falling_zero(c, *part);
      if (root < first) {
        first = root;
        which = i;
      }
    }
    if (first < shortest_rise && at_level(l, which)) {
      // From rest the motion sets out in its regime's direction. Dense output that denies it is far below the
      // tolerance, but its step is too long to tell one event from the next.
      ++statistics_.rejected;
      lane(size_, l) = h / 8;
      lane(growth_limit_, l) = T(1);
      return;
    }
    if (first <= T(1)) {
      ++statistics_.event_refinements;
      take(l, h, first);
      restart(l, -1);
      const auto crossing = system_.crossing(which);
      lane(state_[crossing.component], l) = lane(crossing.level, l);
      if (running(l)) system_.on_event(*this, l, which);
      if constexpr (System::stiff && width == 1) {
        // The system saw no event there, only a motion too small for the tolerance: leave that to the method that
        // damps.
        if (running(l) && notes(l).kind < 0) method_ = StepMethod::rosenbrock;
      }
      return;
    }
    lane(size_, l) = std::max(lane(size_, l), grown);
    remember(l, h);
    take(l, h, T(1));
    settle_touching(l, h);
    if (reaches && running(l)) {
      lane(time_, l) = lane(target_, l);
      system_.on_target(*this, l);
    }
  }

  /// One lane takes the part of its step up to theta, as dense output has it.
  void take(int l, const T& h, const T& theta) {
    const V start = time_;
    for (Eigen::Index i = 0; i < state_.size(); ++i) {
      T power(1);
      T sum(0);
      for (State& coefficient : dense_) {
        T& c = lane(coefficient[i], l);
        c *= power;
        sum += c;
        power *= theta;
      }
      lane(state_[i], l) = theta == T(1) ? lane(end_[i], l) : sum;
      lane(rate_[i], l) = lane(end_rate_[i], l);
    }
    lane(time_, l) += theta * h;
    V chosen(0);
    lane(chosen, l) = T(1);
    system_.on_steps(*this, chosen > V(0), start, V(theta * h), dense_);
  }

  /// A function that began at zero and has not left it by more than rounding still rests there.
  void settle_touching(int l, const T& h) {
    for (std::size_t i = 0; i < system_.crossings(); ++i) {
      const auto crossing = system_.crossing(i);
      const T level = lane(crossing.level, l);
      const T sign = lane(crossing.sign, l);
      T& value = lane(state_[crossing.component], l);
      if (!at_level(l, i) || sign * (value - level) > system_.noise(*this, l, i, h)) continue;
      value = level;
      if (lane(running_, l) > T(0)) system_.on_event(*this, l, i);
    }
  }

  /// Whether the step under way began exactly at an event's level.
  [[nodiscard]] bool at_level(int l, std::size_t i) const {
    const auto crossing = system_.crossing(i);
    return lane(dense_[0][crossing.component], l) == lane(crossing.level, l);
  }

  [[nodiscard]] Notes& notes(int l) { return notes_[static_cast<std::size_t>(l)]; }

  static constexpr int search_depth = 8;
  static constexpr T shortest_rise = T(1) / 16;  ///< of a step, from one event to the next

  System& system_;
  StepMethod first_method_;
  StepMethod method_;
  V time_ = V(0);
  V target_ = V(0);
  V running_ = V(0);
  V size_ = V(0);           ///< proposed step
  V caution_ = V(1);        ///< what the explicit pair's error estimate is multiplied by
  V usual_caution_ = V(1);  ///< after first steps
  V growth_limit_ = V(1);   ///< by how much the next proposal may exceed the step
  State state_;
  State rate_;
  Tolerances<V> tolerances_{V(1), V(1)};
  std::array<Notes, static_cast<std::size_t>(width)> notes_{};
  unsigned fresh_ = 0;
  // the last attempt
  V error_ = V(0);
  State end_;
  State end_rate_;
  DenseState<State> dense_;
  IntegratorStatistics statistics_;
};

}  // namespace turgor
