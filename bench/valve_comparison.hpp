#pragma once
// The pressure relief valve (valve.hpp) in SIMD lanes and by Boost.Odeint.

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace turgor::bench {

struct ValveComparison {
  /// {problems, odeint_problems, tolerance, instruction_set, ours_per_second, odeint_per_second (the faster pair),
  /// ours_over_odeint, and problems per second for each instruction set and each pair; periodic_in_both: valves whose
  /// records repeat themselves with both programs; largest_difference of these records}
  nlohmann::ordered_json document;
  std::map<double, std::vector<double>> ours;  ///< records by flow
  std::map<double, std::vector<double>> odeint;
};

/// One core, processor time.
[[nodiscard]] ValveComparison valve_comparison();

}  // namespace turgor::bench
