#include "valve_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "stopwatch.hpp"
#include "turgor/ensemble/ensemble.hpp"
#include "valve_peer.hpp"

namespace turgor::bench {

namespace {

ValveKernel* kernel_for(InstructionSet set) {
#if defined(TURGOR_SIMD_KERNELS)
  if (set == InstructionSet::avx512) return &valve_kernel_avx512;
  if (set == InstructionSet::avx2) return &valve_kernel_avx2;
#endif
  (void)set;
  return &valve_kernel_scalar;
}

/// Problems done and the time they took.
struct Rate {
  std::size_t problems = 0;
  double seconds = 0;

  template <class Work>
  void add(std::size_t count, const Work& work) {
    problems += count;
    seconds += processor_seconds(work);
  }
  [[nodiscard]] double per_second() const { return static_cast<double>(problems) / seconds; }
};

/// Evenly spread flows, and the slower programs on a share of them.
constexpr std::size_t flows = 512;
constexpr std::size_t share = 4;   ///< of one in so many
constexpr std::size_t rounds = 2;  ///< in turn, so that all meet the same machine

/// Numbers of a record in order: two attractors of one valve passed at different phases have the same.
std::vector<double> sorted(std::vector<double> record) {
  std::ranges::sort(record);
  return record;
}
/// Greatest difference of two records of a valve, either up to a shift in time.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  const auto left = sorted(a);
  const auto right = sorted(b);
  double greatest = 0;
  for (std::size_t i = 0; i < left.size(); ++i) greatest = std::max(greatest, std::abs(left[i] - right[i]));
  return greatest;
}
/// Whether the second half repeats the first: of period 1, 2, 4, 8, 16 or 32.
bool is_periodic(const std::vector<double>& record) {
  const auto half = static_cast<std::ptrdiff_t>(record.size() / 2);
  for (std::ptrdiff_t i = 0; i < half; ++i) {
    if (!(std::abs(record[static_cast<std::size_t>(i)] - record[static_cast<std::size_t>(i + half)]) < 1e-6)) {
      return false;
    }
  }
  return true;
}

}  // namespace

ValveComparison valve_comparison() {
  const ValveTask task;
  const auto kept = static_cast<std::size_t>(task.kept);
  ValveComparison result;
  std::map<std::string, Rate> rates;
  const InstructionSet best = best_instruction_set();
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<double> all;
    std::vector<double> some;
    for (std::size_t i = round; i < flows; i += rounds) {
      const double q = 0.2 + 9.8 * static_cast<double>(i) / (flows - 1);
      all.push_back(q);
      if (i / rounds % share == 0) some.push_back(q);
    }
    const auto run = [&](InstructionSet set, const std::vector<double>& q) {
      std::vector<double> records(q.size() * kept, std::nan(""));
      rates[std::string(name_of(set))].add(q.size(), [&] { kernel_for(set)(q, task, records); });
      return records;
    };
    const auto peer = [&](const char* name, const auto& method, std::map<double, std::vector<double>>& into) {
      for (const double q : some) {
        auto& record = into[q];
        record.assign(kept, std::nan(""));
        rates[name].add(1, [&] { method(q, task, record); });
      }
    };
    const std::vector<double> records = run(best, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto begin = records.begin() + static_cast<std::ptrdiff_t>(i * kept);
      result.ours[all[i]].assign(begin, begin + task.kept);
    }
    if (best == InstructionSet::avx512) run(InstructionSet::avx2, all);
    if (best != InstructionSet::scalar) run(InstructionSet::scalar, some);
    std::map<double, std::vector<double>> slower;
    peer("dopri5", valve_by_dopri5, slower);
    peer("fehlberg78", valve_by_fehlberg78, result.odeint);
  }
  int periodic = 0;
  double greatest = 0;
  for (const auto& [q, record] : result.odeint) {
    if (!is_periodic(record) || !is_periodic(result.ours.at(q))) continue;
    ++periodic;
    greatest = std::max(greatest, difference(record, result.ours.at(q)));
  }
  const double odeint = std::max(rates["dopri5"].per_second(), rates["fehlberg78"].per_second());
  const double ours = rates[std::string(name_of(best))].per_second();
  result.document = {{"problems", flows},
                     {"odeint_problems", result.odeint.size()},
                     {"tolerance", task.tolerance},
                     {"instruction_set", name_of(best)},
                     {"ours_per_second", ours},
                     {"odeint_per_second", odeint},
                     {"ours_over_odeint", ours / odeint}};
  for (const auto& [name, rate] : rates) result.document[name + "_per_second"] = rate.per_second();
  result.document["periodic_in_both"] = periodic;
  result.document["largest_difference"] = greatest;
  return result;
}

}  // namespace turgor::bench
