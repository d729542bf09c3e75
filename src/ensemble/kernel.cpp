// Compiled once per instruction set, with TURGOR_KERNEL naming the function.

#include "kernel_value.hpp"
// the above must come first
#include <deque>

#include "kernel.hpp"
#include "summarizer.hpp"

namespace turgor {

namespace {

using Value = KernelValue;

/// The material of all lanes: the alternative of the members', for Ogden with as many terms as the longest has.
Material<Value> common_material(std::span<const Member* const> members) {
  const auto& first = members.front()->oscillator.parameters().material;
  return std::visit(
      [&]<template <class> class Solid>(const Solid<double>&) -> Material<Value> {
        Solid<Value> all{};
        if constexpr (requires { all.alpha; }) {
          std::size_t terms = 0;
          for (const Member* member : members) {
            terms = std::max(terms, std::get<Ogden<double>>(member->oscillator.parameters().material).mu.size());
          }
          all.mu.resize(terms, Value(0));
          all.alpha.resize(terms, Value(1));
        } else if constexpr (requires { all.tables; }) {  // a lane that stands idle needs some table
          all.tables.fill(std::get<Solid<double>>(first).tables.front());
        }
        return all;
      },
      first);
}

/// All members of one call: lanes for motion that is not stiff and lanes for stiff motion. A balloon whose motion turns
/// stiff, or ceases to be, waits until a lane of the other kind is free, so that lanes never idle while there is work.
class Ensemble {
 public:
  using Observer = Summarizer<Value>;
  using Balloons = OscillatorLanes<Value, Observer>;
  static constexpr int width = Balloons::width;

  Ensemble(std::span<const Member* const> members, const SummaryOptions& options,
           std::span<MemberSummary* const> summaries)
      : members_(members),
        summaries_(summaries),
        nimble_(members, StepMethod::explicit_pair, options),
        stiff_(members, StepMethod::rosenbrock, options) {}

  void run() {
    while (true) {
      fill_nimble();
      fill(stiff_);
      if (stiff_.load() >= width || !nimble_.busy()) {
        if (stiff_.load() == 0) return;
        advance(stiff_, nimble_);
      } else {
        advance(nimble_, stiff_);
      }
    }
  }

 private:
  struct Pool {
    Pool(std::span<const Member* const> members, StepMethod method, const SummaryOptions& options)
        : observer(options),
          lanes(common_material(members), members.front()->oscillator.force_table(), method, observer) {}

    [[nodiscard]] bool busy() const { return lanes.integrator().running(); }
    [[nodiscard]] int active() const {
      int count = 0;
      for (int l = 0; l < width; ++l) count += lanes.integrator().running(l) ? 1 : 0;
      return count;
    }
    /// Balloons in lanes and waiting for one.
    [[nodiscard]] int load() const { return active() + static_cast<int>(waiting.size()); }

    Observer observer;
    Balloons lanes;
    std::deque<std::pair<typename Balloons::Parked, Observer::Parked>> waiting;
  };

  void advance(Pool& pool, Pool& other) {
    pool.lanes.integrator().advance();
    const unsigned leaving = pool.lanes.take_leaving();
    for (int l = 0; l < width; ++l) {
      if ((leaving >> l & 1U) != 0) other.waiting.emplace_back(pool.lanes.park(l), pool.observer.park(l));
    }
  }

  void fill(Pool& pool) {
    for (int l = 0; l < width && !pool.waiting.empty(); ++l) {
      if (pool.lanes.integrator().running(l)) continue;
      pool.lanes.resume(l, pool.waiting.front().first);
      pool.observer.resume(l, pool.waiting.front().second);
      pool.waiting.pop_front();
    }
  }
  void fill_nimble() {
    fill(nimble_);
    for (int l = 0; l < width; ++l) {
      while (next_ < members_.size() && !nimble_.lanes.integrator().running(l)) {
        const Member& member = *members_[next_];
        nimble_.observer.begin(l, member, *summaries_[next_]);
        ++next_;
        nimble_.lanes.load(l, member.oscillator, 0.0, member.stretch, member.rate, member.end_time, member.options);
      }
    }
  }

  std::span<const Member* const> members_;
  std::span<MemberSummary* const> summaries_;
  std::size_t next_ = 0;
  Pool nimble_;
  Pool stiff_;
};

}  // namespace

void TURGOR_KERNEL(std::span<const Member* const> members, const SummaryOptions& options,
                   std::span<MemberSummary* const> summaries) {
  if (!members.empty()) Ensemble(members, options, summaries).run();
}

}  // namespace turgor
