#include "turgor/asymptotics/piecewise_solution.hpp"

#include <algorithm>
#include <cmath>

#include "turgor/asymptotics/decay.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

PiecewiseSolution::PiecewiseSolution(const FreeMotion& motion, double start, int half_cycles, Chain chain)
    : channel_(motion.model() == Model::long_channel), chain_(chain), equilibrium_(motion.equilibrium()) {
  (void)motion.require_deflation();
  if (start == equilibrium_) {
    throw InvalidInput("start", shortest(start), "a balloon at rest in its equilibrium stays there", "start beside it");
  }
  if (half_cycles < 1) {
    throw InvalidInput("half_cycles", std::to_string(half_cycles), "is no number of half-cycles", "give at least 1");
  }
  append(motion, start);
  while (static_cast<int>(half_cycles_.size()) < half_cycles) {
    const HalfCycle& last = half_cycles_.back();
    const double from = last.to.value;
    if ((from < equilibrium_) != (last.regime == Regime::deflating)) {
      ending_ = "(3.16) comes to rest at " + shortest(from) + ", before the equilibrium";
      break;
    }
    try {
      append(motion, from);
    } catch (const InvalidInput& problem) {
      ending_ = problem.what();
      break;
    }
  }
}

PiecewiseSolution::Law PiecewiseSolution::law_of(const FreeMotion& motion, double from) const {
  if (from < equilibrium_) return Oscillation(motion, Regime::inflating);
  if (chain_ == Chain::paper) return MatchedDeflation(motion, from);
  constexpr double small = 0.2;  // both know the duration to 1e-4 there
  if (2 * motion.beta() * (from - equilibrium_) < small) return Oscillation(motion, Regime::deflating);
  return SlowDeflation(motion, from);
}

void PiecewiseSolution::append(const FreeMotion& motion, double from) {
  if (!(from > motion.least()) || !(from < motion.greatest())) {
    throw InvalidInput("start", shortest(from), "is outside the well of the equilibrium " + shortest(equilibrium_),
                       "between " + shortest(motion.least()) + " and " + shortest(motion.greatest()));
  }
  laws_.push_back(law_of(motion, from));
  const double e = from - equilibrium_;
  const Law& law = laws_.back();
  HalfCycle half{from < equilibrium_ ? Regime::inflating : Regime::deflating, end_time(), {}, from, {}};
  if (const auto* matched = std::get_if<MatchedDeflation>(&law)) {
    half.duration = matched->transition_time();
  } else if (const auto* slow = std::get_if<SlowDeflation>(&law)) {
    half.duration = slow->transition_time();
    // What is unknown about the start takes time to pass at the slow rate.
    if (!half_cycles_.empty()) {
      half.duration.error += half_cycles_.back().to.error / std::sqrt(slow_manifold(motion, from).corrected().value);
    }
  } else {
    const auto& oscillation = std::get<Oscillation>(law);
    half.duration = chain_ == Chain::paper ? oscillation.half_period(e) : oscillation.corrected_half_period(e);
  }
  half_cycles_.push_back(half);
  half_cycles_.back().to = stretch(half_cycles_.size() - 1, half.duration.value);
  if (chain_ == Chain::uniform && e > 0) {  // more accurate than either law
    const Estimate below = Decay(motion).corrected_undershoot(e);
    half_cycles_.back().to = {equilibrium_ - below.value, below.error};
  }
}

Estimate PiecewiseSolution::stretch(std::size_t index, double T) const {
  const Law& law = laws_[index];
  if (const auto* matched = std::get_if<MatchedDeflation>(&law)) return matched->composite(T);
  if (const auto* slow = std::get_if<SlowDeflation>(&law)) return slow->at(T);
  const auto& oscillation = std::get<Oscillation>(law);
  const double e = half_cycles_[index].from - equilibrium_;
  if (chain_ == Chain::uniform) return oscillation.third_order(e, T);
  return channel_ ? oscillation.second_order(e, T) : oscillation.first_order(e, T);
}

double PiecewiseSolution::end_time() const {
  return half_cycles_.empty() ? 0.0 : half_cycles_.back().begin + half_cycles_.back().duration.value;
}

Estimate PiecewiseSolution::at(double T) const {
  if (!(T >= 0) || T > end_time()) {
    throw InvalidInput("T", shortest(T), "the solution does not reach there", "0 to " + shortest(end_time()));
  }
  const auto next = std::ranges::upper_bound(half_cycles_, T, {}, &HalfCycle::begin);
  const auto index = static_cast<std::size_t>(next - half_cycles_.begin() - 1);
  const HalfCycle& now = half_cycles_[index];
  Estimate result = stretch(index, T - now.begin);
  double late = 0;
  for (std::size_t i = 0; i < index; ++i) {
    result.error += half_cycles_[i].to.error;
    late += half_cycles_[i].duration.error;
  }
  // An error in time moves the solution along itself, within this half-cycle at most.
  const double earlier = stretch(index, std::max(0.0, T - now.begin - late)).value;
  const double later = stretch(index, std::min(now.duration.value, T - now.begin + late)).value;
  result.error += std::abs(later - earlier);
  return result;
}

}  // namespace turgor
