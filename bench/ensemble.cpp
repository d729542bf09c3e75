#include "turgor/ensemble/ensemble.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "../tests/support/balloons.hpp"
#include "ensemble.hpp"
#include "peers.hpp"
#include "stopwatch.hpp"

namespace turgor::bench {

namespace {

constexpr std::size_t members_in_all = 20000;
constexpr std::size_t compared = 1000;
constexpr std::size_t chunk = 256;
constexpr double our_rtol = 1e-6;
constexpr double t_end = 12;  // [s]

std::vector<Member> random_members() {
  std::mt19937_64 generator(20190811);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  std::vector<Member> members;
  for (std::size_t i = 0; i < members_in_all; ++i) {
    const auto p = test::paper_balloon<double>(std::exp(uniform(std::log(0.01), std::log(0.03))), 0.0);
    const auto program = test::up_hold_down(uniform(30e3, 40e3), 2.0, 4.0, 6.0);
    const auto scales = natural_scales(p, program, t_end);
    SimulationOptions<double> options;
    options.rtol = options.atol = our_rtol;
    members.push_back({Oscillator<double>(Model::full, p, program, scales), 1.0, 0.0, t_end / scales.time, options});
  }
  return members;
}

void integrate_in_chunks(std::span<const Member> members, std::span<MemberSummary> summaries, InstructionSet set) {
  for (std::size_t begin = 0; begin < members.size(); begin += chunk) {
    const std::size_t count = std::min(chunk, members.size() - begin);
    integrate_ensemble(members.subspan(begin, count), {}, summaries.subspan(begin, count), set);
  }
}

struct Errors {
  double rms = 0;
  double largest = 0;
};
Errors errors(const std::vector<double>& values, const std::vector<double>& reference) {
  Errors e;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double error = std::abs(values[i] - reference[i]);
    e.rms += error * error / static_cast<double>(values.size());
    e.largest = std::max(e.largest, error);
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

std::vector<double> reference_ends(std::span<const Member> members) {
  std::vector<double> ends;
  for (const Member& m : members) {
    SimulationOptions<double> tight = m.options;
    tight.rtol = tight.atol = 1e-12;
    ends.push_back(simulate(m.oscillator, 0.0, m.stretch, m.rate, m.end_time, tight).at(m.end_time).stretch);
  }
  return ends;
}

/// CVODE on the compared members.
class Cvode {
 public:
  Cvode(std::span<const Member> members, const std::vector<double>& reference) : reference_(reference) {
    for (const Member& m : members) {
      problems_.push_back({"", m.oscillator, m.stretch, m.rate, {m.end_time}, {}, most_stretches});
    }
  }

  struct Sample {
    double tolerance;
    Errors errors;
    double seconds;     ///< for as many members as there are
    std::size_t stuck;  ///< members that it does not bring to their end
  };
  /// Members on which it gets stuck count neither in errors nor in time.
  [[nodiscard]] Sample measure(double tolerance, std::size_t first = compared) const {
    std::vector<double> ends;
    std::vector<double> reference;
    double seconds = 0;
    for (std::size_t i = 0; i < first; ++i) {
      try {
        seconds += processor_seconds([&] { ends.push_back(by_cvode_bdf(problems_[i], tolerance).at(0)); });
        reference.push_back(reference_[i]);
      } catch (const std::runtime_error&) {
        continue;
      }
    }
    const double all = static_cast<double>(first) / static_cast<double>(ends.size());
    return {tolerance, errors(ends, reference), seconds * all, first - ends.size()};
  }

  /// Neighbours on a ladder of tolerances, whose errors enclose one.
  [[nodiscard]] std::pair<Sample, Sample> enclose(double rms) const {
    constexpr double rung = 0.31622776601683794;
    constexpr std::size_t few = 100;
    double tolerance = 1e-5;
    while (measure(tolerance * rung, few).errors.rms > rms) tolerance *= rung;
    Sample coarse = measure(tolerance);
    while (tolerance > 1e-13) {
      tolerance *= rung;
      const Sample fine = measure(tolerance);
      if (fine.errors.rms <= rms) return {coarse, fine};
      coarse = fine;
    }
    throw std::runtime_error("CVODE does not reach this error");
  }

 private:
  static constexpr int most_stretches = 1000;  ///< no member has a fifth of these changes of regime

  std::vector<Problem> problems_;
  const std::vector<double>& reference_;
};

/// Time of all members on some threads, each with chunks of its own.
double threaded_seconds(std::span<const Member> members, std::span<MemberSummary> summaries, std::size_t threads) {
  return wall_seconds([&] {
    std::vector<std::jthread> pool;
    const std::size_t share = members.size() / threads;
    for (std::size_t t = 0; t < threads; ++t) {
      pool.emplace_back([=] {
        integrate_in_chunks(members.subspan(t * share, share), summaries.subspan(t * share, share),
                            best_instruction_set());
      });
    }
  });
}

struct Scaling {
  double speedup;    ///< of two threads, by the clock on the wall
  double occupancy;  ///< processor time of two threads over that of one
};
Scaling two_threads(std::span<const Member> members, std::span<MemberSummary> summaries) {
  constexpr int repetitions = 60;  // short ones: some of them have both cores for themselves
  const std::size_t few = 8 * chunk;
  struct Least {
    double wall = std::numeric_limits<double>::infinity();
    double processor = wall;
  };
  std::array<Least, 2> least;
  for (int i = 0; i < repetitions; ++i) {
    for (const std::size_t threads : {1U, 2U}) {
      Least& l = least[threads - 1];
      double wall = 0;
      const double processor =
          processor_seconds([&] { wall = threaded_seconds(members.first(few), summaries, threads); });
      l.wall = std::min(l.wall, wall);
      l.processor = std::min(l.processor, processor);
    }
  }
  return {least[0].wall / least[1].wall, least[1].processor / least[0].processor};
}

}  // namespace

nlohmann::ordered_json ensemble_comparison() {
  const std::vector<Member> members = random_members();
  std::vector<MemberSummary> summaries(members.size());
  const auto first = std::span(members).first(compared);
  const std::vector<double> reference = reference_ends(first);
  const auto seconds = [&](InstructionSet set) {
    return processor_seconds([&] { integrate_in_chunks(members, summaries, set); });
  };

  const InstructionSet best = best_instruction_set();
  seconds(best);
  std::vector<double> ends;
  for (std::size_t i = 0; i < compared; ++i) ends.push_back(summaries[i].last.stretch);
  const Errors ours = errors(ends, reference);

  const Cvode cvode(first, reference);
  auto [coarse, fine] = cvode.enclose(ours.rms);
  double simd = std::numeric_limits<double>::infinity();
  double avx2 = simd;
  double scalar = simd;
  constexpr int repetitions = 3;
  for (int i = 0; i < repetitions; ++i) {
    simd = std::min(simd, seconds(best));
    if (best != InstructionSet::scalar) avx2 = std::min(avx2, seconds(InstructionSet::avx2));
    scalar = std::min(scalar, seconds(InstructionSet::scalar));
    coarse.seconds = std::min(coarse.seconds, cvode.measure(coarse.tolerance).seconds);
    fine.seconds = std::min(fine.seconds, cvode.measure(fine.tolerance).seconds);
  }
  const double share =
      std::clamp(std::log(coarse.errors.rms / ours.rms) / std::log(coarse.errors.rms / fine.errors.rms), 0.0, 1.0);
  const double members_ratio = static_cast<double>(members.size()) / compared;
  const double cvode_seconds = members_ratio * coarse.seconds * std::pow(fine.seconds / coarse.seconds, share);
  const Scaling threads = two_threads(members, summaries);
  return {{"members", members.size()},
          {"rtol", our_rtol},
          {"instruction_set", name_of(best)},
          {"chunk", chunk},
          {"seconds", simd},
          {"compared", compared},
          {"rms_error", ours.rms},
          {"largest_error", ours.largest},
          {"cvode_seconds", cvode_seconds},
          {"cvode_tolerances", {coarse.tolerance, fine.tolerance}},
          {"cvode_rms_errors", {coarse.errors.rms, fine.errors.rms}},
          {"cvode_stuck", {coarse.stuck, fine.stuck}},
          {"cvode_largest_errors", {coarse.errors.largest, fine.errors.largest}},
          {"over_cvode", cvode_seconds / simd},
          {"simd_over_scalar", scalar / simd},
          {"simd_avx2_over_scalar", scalar / avx2},
          {"threads_2_over_1", threads.speedup},
          {"threads_2_processor_time", threads.occupancy}};
}

}  // namespace turgor::bench
