#pragma once
// What is kept of the trajectories in a set of lanes while they are under way.

#include "turgor/ensemble/ensemble.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/integrate/oscillator_lanes.hpp"

namespace turgor {

/// Running sums and extrema of one lane; numbers of type V hold those of all lanes.
template <class V>
struct Tally {
  V least_stretch, greatest_stretch, peak_time;
  V inlet_work, dissipated, initial_energy, largest_energy;
  V greatest_flow;
  V slenderness;  ///< r_ch/r0
};

/// Observer of lanes (see OscillatorLanes) that sums up members.
template <class V>
class Summarizer {
 public:
  using T = ScalarOf<V>;
  using Lanes = OscillatorLanes<V, Summarizer>;
  static constexpr int width = turgor::Lanes<V>::width;

  explicit Summarizer(const SummaryOptions& options) : options_(options) {}

  /// A member begins in lane l.
  void begin(int l, const Member& member, MemberSummary& summary) {
    summaries_[static_cast<std::size_t>(l)] = &summary;
    summary.initial_stretch = member.stretch;
    const Parameters<T>& p = member.oscillator.parameters();
    Tally<T> tally{};
    tally.least_stretch = tally.greatest_stretch = member.stretch;
    tally.slenderness = p.orifice_radius / p.radius;
    if (options_.energies) {
      const Regime regime = member.rate > T(0) ? Regime::inflating : Regime::deflating;
      const T mass = member.oscillator.coefficients(regime, member.stretch).mass;
      const T kinetic = mass * member.rate * member.rate / 2;
      const T elastic = member.oscillator.elastic_energy(member.stretch);
      tally.initial_energy = kinetic + elastic;
      tally.largest_energy = std::max(kinetic, std::abs(elastic));
    }
    set_lane_numbers<V>(tally_, l, tally);
  }

  /// Moves what is known about a lane to another set of lanes.
  struct Parked {
    MemberSummary* summary;
    Tally<T> tally;
  };
  [[nodiscard]] Parked park(int l) const {
    Parked parked{summaries_[static_cast<std::size_t>(l)], {}};
    // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): both are nothing but so many numbers
    const auto* all = reinterpret_cast<const V*>(&tally_);
    auto* one = reinterpret_cast<T*>(&parked.tally);
    // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
    for (std::size_t i = 0; i < sizeof(tally_) / sizeof(V); ++i) one[i] = lane(all[i], l);
    return parked;
  }
  void resume(int l, const Parked& parked) {
    summaries_[static_cast<std::size_t>(l)] = parked.summary;
    set_lane_numbers<V>(tally_, l, parked.tally);
  }

  template <class Condition, class State>
  void steps(const Lanes& lanes, const Condition& which, const V& start, const V& h, const DenseState<State>& dense) {
    using std::min;
    Tally<V>& t = tally_;
    const V& R = lanes.integrator().component(0);
    const V& time = lanes.integrator().time();
    const auto higher = which && R > t.greatest_stretch;
    t.greatest_stretch = select(higher, R, t.greatest_stretch);
    t.peak_time = select(higher, time, t.peak_time);
    t.least_stretch = select(which, min(R, t.least_stretch), t.least_stretch);
    if (options_.flow) add_flow(which, dense);
    if (options_.energies) add_energies(lanes, which, start, h, dense);
    if (options_.steps) keep_steps(lanes, bits(which), start, h, dense);
  }
  void hold(const Lanes& /*lanes*/, int /*lane*/, const T& /*duration*/) {}
  void event(const Lanes& lanes, int l, Regime before, Regime after) {
    MemberSummary& summary = *summaries_[static_cast<std::size_t>(l)];
    const Point<T> at = lanes.point(l);
    if (lanes.balloon(l).events == 1) summary.first_event_time = at.time;
    if (summary.first_events.size() < options_.events) {
      summary.first_events.push_back({at.time, at.stretch, before, after});
    }
  }
  void finished(const Lanes& lanes, int l) {
    MemberSummary& summary = *summaries_[static_cast<std::size_t>(l)];
    const BalloonInLane<T>& balloon = lanes.balloon(l);
    const Tally<T> tally = park(l).tally;
    summary.outcome = balloon.outcome;
    summary.message = balloon.message;
    summary.last = lanes.point(l);
    summary.least_stretch = tally.least_stretch;
    summary.greatest_stretch = tally.greatest_stretch;
    summary.peak_time = tally.peak_time;
    summary.events = balloon.events;
    summary.greatest_flow = tally.greatest_flow;
    if (!options_.energies) return;
    summary.inlet_work = tally.inlet_work;
    summary.dissipated = tally.dissipated;
    const T final_energy = energy(*balloon.oscillator, summary.last);
    const T defect = final_energy - tally.inlet_work + tally.dissipated - tally.initial_energy;
    summary.energy_error = tally.largest_energy > T(0) ? std::abs(defect) / tally.largest_energy : T(0);
  }

 private:
  [[nodiscard]] static T energy(const Oscillator<T>& oscillator, const Point<T>& at) {
    const T elastic = oscillator.elastic_energy(at.stretch);
    if (at.rate == T(0) || at.regime == Regime::rest) return elastic;
    return elastic + oscillator.coefficients(at.regime, at.stretch).mass * at.rate * at.rate / 2;
  }

  template <class State>
  [[nodiscard]] static V at(const DenseState<State>& dense, Eigen::Index i, const V& theta) {
    V sum = dense[dense_degree][i];
    for (std::size_t k = dense_degree; k > 0; --k) sum = sum * theta + dense[k - 1][i];
    return sum;
  }

  /// |dR/dT| (2 - eps)/(eps (1 - eps)) at the points where RunResult's Reynolds number is sampled, and at the end.
  template <class Condition, class State>
  void add_flow(const Condition& which, const DenseState<State>& dense) {
    using std::abs;
    using std::max;
    V greatest = tally_.greatest_flow;
    for (const T theta : {T(0), T(0.25), T(0.5), T(0.75), T(1)}) {
      const V R = at(dense, 0, V(theta));
      const V speed = channel_speed(cap_depth(tally_.slenderness / R));
      greatest = max(greatest, abs(at(dense, 1, V(theta))) * speed);
    }
    tally_.greatest_flow = select(which, greatest, tally_.greatest_flow);
  }

  /// The integrals of EnergyLedger, by the same quadrature over dense output.
  template <class Condition, class State>
  void add_energies(const Lanes& lanes, const Condition& which, const V& start, const V& h,
                    const DenseState<State>& dense) {
    using std::abs;
    using std::max;
    // Gauss-Legendre with 7 points on [0, 1]; Abramowitz & Stegun, table 25.4.
    constexpr std::array<double, 7> nodes{0.0254460438286207377, 0.1292344072003027800, 0.2970774243113014166, 0.5,
                                          0.7029225756886985834, 0.8707655927996972200, 0.9745539561713792623};
    constexpr std::array<double, 7> weights{0.0647424830844348466, 0.1398526957446383340, 0.1909150252525594725,
                                            0.2089795918367346939, 0.1909150252525594725, 0.1398526957446383340,
                                            0.0647424830844348466};
    V work(0);
    V lost(0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const V theta(nodes[i]);
      const V R = at(dense, 0, theta);
      const V v = at(dense, 1, theta);
      work += V(weights[i]) * lanes.area(R) * v * lanes.pressure(start + theta * h);
      lost += V(weights[i]) * lanes.dissipation_rate(R, v);
    }
    Tally<V>& t = tally_;
    t.inlet_work = select(which, t.inlet_work + work * h, t.inlet_work);
    t.dissipated = select(which, t.dissipated + lost * h, t.dissipated);
    const auto [kinetic, elastic] = lanes.energies();
    const V largest = max(max(kinetic, abs(elastic)), max(abs(t.inlet_work), t.dissipated));
    t.largest_energy = select(which, max(t.largest_energy, largest), t.largest_energy);
  }

  template <class State>
  void keep_steps(const Lanes& lanes, unsigned which, const V& start, const V& h, const DenseState<State>& dense) {
    for (int l = 0; l < width; ++l) {
      if ((which >> l & 1U) == 0) continue;
      auto& step = summaries_[static_cast<std::size_t>(l)]->steps.emplace_back();
      step.start = lane(start, l);
      step.duration = lane(h, l);
      step.regime = lanes.balloon(l).regime;
      for (std::size_t k = 0; k < dense.size(); ++k) step.stretch[k] = lane(dense[k][0], l);
    }
  }

  SummaryOptions options_;
  Tally<V> tally_{};
  std::array<MemberSummary*, static_cast<std::size_t>(width)> summaries_{};
};

}  // namespace turgor
