#include "work_precision.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>

#include "../tests/support/balloons.hpp"
#include "../tests/support/reference.hpp"
#include "peers.hpp"

namespace turgor::bench {

std::vector<double> by_turgor(const Problem& problem, double tolerance) {
  SimulationOptions<double> options;
  options.rtol = options.atol = tolerance;
  const auto trajectory =
      simulate(problem.oscillator, 0.0, problem.stretch, problem.rate, problem.times.back(), options);
  std::vector<double> values;
  for (const double time : problem.times) values.push_back(trajectory.at(time).stretch);
  return values;
}

namespace {

Model model_of(const std::string& equation) {
  if (equation == "(2.22)") return Model::full;
  return equation == "(2.23)" ? Model::orifice : Model::long_channel;
}

/// The trajectories of R_free and R_forced.
std::vector<Problem> problems() {
  std::map<std::string, std::vector<test::ReferenceValue>> grouped;
  for (const char* name : {"R_free", "R_forced"}) {
    for (const auto& entry : test::reference().at(name)) {
      auto inputs = entry.inputs;
      inputs.erase("t");
      grouped[inputs.dump()].push_back(entry);
    }
  }
  std::vector<Problem> all;
  for (auto& [key, entries] : grouped) {
    std::ranges::sort(entries, {}, [](const auto& entry) { return entry.input("t"); });
    const auto& first = entries.front();
    const auto p = test::paper_balloon<double>(first.input("r_ch"), first.input("L_ch"));
    const bool forced = first.has("p_max");
    const auto program =
        forced ? test::up_hold_down(first.input("p_max"), first.input("t1"), first.input("t2"), first.input("t3"))
               : constant_pressure(first.input("P"));
    std::string name = std::string(forced ? "forced " : "free ") + first.text("eq") +
                       " r_ch=" + first.inputs.at("r_ch").dump() + " L_ch=" + first.inputs.at("L_ch").dump() +
                       " R0=" + first.inputs.at("R0").dump();
    if (!forced) name += " P=" + std::to_string(std::lround(first.input("P")));
    Problem problem{name,
                    Oscillator<double>(model_of(first.text("eq")), p, program, test::si_scales(p)),
                    first.input("R0"),
                    first.input("v0"),
                    {},
                    {}};
    for (const auto& entry : entries) {
      if (entry.input("t") <= 0) continue;
      problem.times.push_back(entry.input("t"));
      problem.reference.push_back(entry.value);
    }
    if (!problem.times.empty()) all.push_back(std::move(problem));
  }
  return all;
}

struct Sample {
  double error;
  double seconds;
};

/// Error of a method, and its median time: as many runs as fit into 30 ms, at least three.
std::optional<Sample> measure(const Method& method, const Problem& problem, double tolerance) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  std::vector<double> values;
  const auto begin = Clock::now();
  while (times.size() < 3 || Clock::now() - begin < std::chrono::milliseconds(30)) {
    const auto start = Clock::now();
    try {
      values = method(problem, tolerance);
    } catch (const std::exception&) {
      return std::nullopt;
    }
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    if (times.back() > 1) break;
  }
  const bool complete = values.size() == problem.reference.size();
  if (!complete || !std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) return std::nullopt;
  double error = 0;
  for (std::size_t i = 0; i < values.size(); ++i) error = std::max(error, std::abs(values[i] - problem.reference[i]));
  std::ranges::sort(times);
  return Sample{error, times[times.size() / 2]};
}

/// Work-precision curve of a method: over a ladder of tolerances, each error reached with the least time.
std::vector<Sample> curve(const Method& method, const Problem& problem) {
  std::vector<Sample> samples;
  for (double exponent = -2.5; exponent >= -13; exponent -= 0.75) {
    if (const auto sample = measure(method, problem, std::pow(10.0, exponent))) samples.push_back(*sample);
    constexpr double too_slow = 0.3;  // [s]; tighter tolerances would be slower still
    if (!samples.empty() && samples.back().seconds > too_slow) break;
  }
  return samples;
}

/// Time at which a method reaches an error, between the two samples of its curve that enclose it.
std::optional<double> seconds_at(std::vector<Sample> samples, double error) {
  std::ranges::sort(samples, {}, &Sample::seconds);
  const Sample* above = nullptr;  // the best so far that is not good enough
  for (const Sample& sample : samples) {
    if (sample.error <= error) {
      if (above == nullptr) return sample.seconds;
      const double share = std::log(above->error / error) / std::log(above->error / std::max(sample.error, 1e-17));
      return above->seconds * std::pow(sample.seconds / above->seconds, share);
    }
    if (above == nullptr || sample.error < above->error) above = &sample;
  }
  return std::nullopt;
}

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

nlohmann::ordered_json work_precision() {
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const Problem& problem : problems()) {
    std::cerr << "  " << problem.name << "\n";
    const auto bdf = curve(by_cvode_bdf, problem);
    const auto adams = curve(by_cvode_adams, problem);
    auto odeint = curve(by_odeint_dopri5, problem);
    for (const Method& method : {Method(by_odeint_fehlberg78), Method(by_odeint_rosenbrock4)}) {
      for (const Sample& sample : curve(method, problem)) odeint.push_back(sample);
    }
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const auto ours = measure(by_turgor, problem, tolerance);
      if (!ours) continue;
      entries.push_back({{"case", problem.name},
                         {"tolerance", tolerance},
                         {"error", ours->error},
                         {"seconds", ours->seconds},
                         {"cvode_bdf_seconds", or_null(seconds_at(bdf, ours->error))},
                         {"cvode_adams_seconds", or_null(seconds_at(adams, ours->error))},
                         {"odeint_seconds", or_null(seconds_at(odeint, ours->error))}});
    }
  }
  return entries;
}

}  // namespace turgor::bench
