#pragma once
// A published yardstick for integrators of hybrid systems: the pressure relief valve that chatters on its seat.
//
//   y1' = y2,  y2' = -kappa y2 - (y1 + delta) + y3,  y3' = beta (q - y1 sqrt(y3)),  y2 -> -r y2 at y1 = 0
//
// F. Hegedus, "Program package MPGOS: challenges and solutions during the integration of a large number of independent
// ODE systems using GPUs", Commun. Nonlinear Sci. Numer. Simul. 97 (2021) 105732; kappa = 1.25, beta = 20, delta = 10,
// r = 0.8; from (0.2, 0, 0).
//
// What is counted: every local maximum of y1 (y2 falls through zero) and every impact. The first ones are passed, of
// the next ones a number is kept: y1 at a maximum, y2 < 0 at an impact. A valve that has bounced itself to a standstill
// while y3 < delta stays shut until y3 = delta.

#include <limits>
#include <span>

#include "turgor/integrate/hybrid.hpp"

namespace turgor::bench {

struct ValveTask {
  double tolerance = 1e-10;  ///< relative and absolute
  int passed = 2048;         ///< maxima and impacts
  int kept = 64;
  double patience = 1e5;  ///< what a valve lacks after this time is not a number
};

namespace valve {
inline constexpr double kappa = 1.25;
inline constexpr double beta = 20;
inline constexpr double delta = 10;
inline constexpr double restitution = 0.8;
inline constexpr double shut = 1e-8;  ///< a bounce slower than this is none

/// At a maximum: whether it is one only by rounding and by errors within the tolerance.
[[nodiscard]] inline bool rests(double position, double pressure) {
  constexpr double acceleration = 1e-7;
  return std::abs(pressure - position - delta) < acceleration;
}

/// y after an impact, and the time until the valve opens again: zero unless it stays shut.
struct Bounce {
  double rate;
  double pressure;
  double duration;
};
[[nodiscard]] inline Bounce bounce(double rate, double pressure, double q) {
  const double back = -restitution * rate;
  if (back >= shut || pressure >= delta) return {back, pressure, 0};
  return {0, delta, (delta - pressure) / (beta * q)};
}
}  // namespace valve

/// Records of the valves with flows q, task.kept for each one after the other.
using ValveKernel = void(std::span<const double> flows, const ValveTask& task, std::span<double> records);
ValveKernel valve_kernel_scalar;
ValveKernel valve_kernel_avx2;
ValveKernel valve_kernel_avx512;

template <class V>
struct ValveFlow {
  using Value = V;
  static constexpr int size = 3;
  using State = Eigen::Matrix<V, 3, 1>;
  V q;

  [[nodiscard]] State rate(const V& /*t*/, const State& y) const {
    using std::max;
    using std::sqrt;
    // Trial stages around the start, where y3 = 0, may lie below it.
    return {y[1], y[2] - V(valve::kappa) * y[1] - (y[0] + V(valve::delta)),
            V(valve::beta) * (q - y[0] * sqrt(max(y[2], V(0))))};
  }
};

/// Valves as a hybrid system, one in every lane, lanes refilled as they finish. Maxima change nothing: they are read
/// off dense output in passing.
template <class V>
class ValveLanes {
 public:
  using Value = V;
  static constexpr int size = 3;
  static constexpr bool stiff = false;
  static constexpr int width = Lanes<V>::width;
  using Integrator = HybridIntegrator<ValveLanes>;
  using State = Eigen::Matrix<V, 3, 1>;

  ValveLanes(std::span<const double> flows, const ValveTask& task, std::span<double> records)
      : flows_(flows), task_(task), records_(records), integrator_(*this, StepMethod::explicit_pair) {}

  void run() {
    done_ = (1U << width) - 1;
    do {
      for (int l = 0; l < width; ++l) {
        if ((done_ >> l & 1U) != 0) load_next(l);
      }
      done_ = 0;
      while (done_ == 0 && integrator_.running()) integrator_.advance();
    } while (done_ != 0);
  }

  template <class Action>
  void with_flow(const Action& action) const {
    action(flow_);
  }
  [[nodiscard]] std::size_t crossings() const { return 1; }
  [[nodiscard]] Crossing<V> crossing(std::size_t) const { return {0, V(0), V(1)}; }
  [[nodiscard]] double noise(const Integrator&, int, std::size_t, double) const { return 0; }

  void on_event(Integrator&, int l, std::size_t) {
    double& rate = integrator_.component(l, 1);
    double& pressure = integrator_.component(l, 2);
    count(l, rate);
    const valve::Bounce bounce = valve::bounce(rate, pressure, lane(flow_.q, l));
    rate = bounce.rate;
    pressure = bounce.pressure;
    integrator_.time(l) += bounce.duration;
  }
  void on_target(Integrator&, int l) { finish(l); }
  void on_stall(Integrator&, int l) { finish(l); }
  void on_method_due(Integrator&, int) {}
  template <class Condition>
  void on_steps(Integrator&, const Condition& which, const V&, const V&, const DenseState<State>& dense) {
    const auto peaks = which && dense[0][1] > V(0) && !(integrator_.component(1) > V(0));
    if (!any(peaks)) return;
    for (int l = 0; l < width; ++l) {
      if ((bits(peaks) >> l & 1U) != 0) count_maximum(l, dense);
    }
  }

 private:
  struct Progress {
    std::size_t valve = 0;
    int counted = 0;
  };

  void load_next(int l) {
    if (next_ == flows_.size()) return;
    progress_[static_cast<std::size_t>(l)] = {next_, 0};
    lane(flow_.q, l) = flows_[next_];
    integrator_.load(l, 0.0, task_.patience, {task_.tolerance, task_.tolerance});
    integrator_.component(l, 0) = 0.2;
    integrator_.component(l, 1) = 0;
    integrator_.component(l, 2) = 0;
    ++next_;
  }

  void count_maximum(int l, const DenseState<State>& dense) {
    std::array<DensePolynomial<double>, 3> y;
    for (std::size_t i = 0; i < y.size(); ++i) {
      for (std::size_t k = 0; k < dense.size(); ++k) y[i][k] = lane(dense[k][static_cast<Eigen::Index>(i)], l);
    }
    const double theta = falling_zero<double>(y[1], {0, 1, bernstein(y[1])});
    const double position = evaluate(y[0], theta);
    count(l, position);
    while (integrator_.running(l) && valve::rests(position, evaluate(y[2], theta))) count(l, position);
  }

  void count(int l, double value) {
    Progress& progress = progress_[static_cast<std::size_t>(l)];
    const int kept = progress.counted++ - task_.passed;
    if (kept < 0) return;
    const auto each = static_cast<std::size_t>(task_.kept);
    if (kept < task_.kept) records_[progress.valve * each + static_cast<std::size_t>(kept)] = value;
    if (kept + 1 >= task_.kept) finish(l);
  }
  void finish(int l) {
    integrator_.retire(l);
    done_ |= 1U << l;
  }

  std::span<const double> flows_;
  ValveTask task_;
  std::span<double> records_;
  Integrator integrator_;
  ValveFlow<V> flow_{V(1)};
  std::array<Progress, static_cast<std::size_t>(width)> progress_{};
  std::size_t next_ = 0;
  unsigned done_ = 0;  ///< lanes, by bits, that are to be loaded again
};

}  // namespace turgor::bench
