// Timings of the program as its users meet it: start-up, the demo case from file to tables, the integration alone,
// ensembles, sweeps; and the same by other integrators. turgor-bench PROGRAM CASES OUT.json

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ensemble.hpp"
#include "flow_timings.hpp"
#include "pictures.hpp"
#include "sweeps.hpp"
#include "turgor/run/run_case.hpp"
#include "valve_comparison.hpp"
#include "work_precision.hpp"

namespace {

/// Median wall time of some repetitions [s]; the machine is shared, and a median forgets its hiccups.
double median_seconds(int repetitions, const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(seconds);
  return seconds[seconds.size() / 2];
}

double command_seconds(const std::string& command) {
  return median_seconds(21, [&] {
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
  });
}

/// Geometric mean and worst of how many times longer a peer takes than this integrator at equal error.
void print_ratios(const nlohmann::ordered_json& entries) {
  for (const char* peer : {"cvode_bdf_seconds", "cvode_adams_seconds", "odeint_seconds"}) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      double logarithms = 0;
      double worst = std::numeric_limits<double>::infinity();
      int count = 0;
      int missing = 0;
      for (const auto& entry : entries) {
        if (entry.at("tolerance") != tolerance) continue;
        if (entry.at(peer).is_null()) {
          ++missing;
          continue;
        }
        const double ratio = entry.at(peer).get<double>() / entry.at("seconds").get<double>();
        logarithms += std::log(ratio);
        worst = std::min(worst, ratio);
        ++count;
      }
      std::cout << peer << " over ours at tolerance " << tolerance << ": geometric mean "
                << std::exp(logarithms / count) << ", least " << worst << " (" << count << " cases, " << missing
                << " where it does not reach our error)\n";
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: turgor-bench PROGRAM CASES OUT.json\n";
    return 2;
  }
  const std::string program = argv[1];
  const std::filesystem::path cases = argv[2];
  const std::string scratch = (std::filesystem::temp_directory_path() / "turgor-bench").string();

  nlohmann::ordered_json document;
  // A shell that starts nothing: what every command below costs before the program's first instruction.
  document["shell_s"] = command_seconds("true >/dev/null");
  document["start_up_s"] = command_seconds(program + " --version >/dev/null");
  document["demo_without_pictures_s"] = command_seconds(program + " run " + (cases / "orifice-30mm.toml").string() +
                                                        " -o " + scratch + " --force --no-pictures --quiet");
  for (const char* name : {"orifice-10mm", "orifice-30mm", "channel-10mm", "channel-30mm"}) {
    for (const char* rtol : {"1e-4", "1e-6", "1e-8", "1e-10"}) {
      const turgor::Case c =
          turgor::read_case(cases / (std::string(name) + ".toml"), {std::string("solve.rtol=") + rtol});
      long steps = 0;
      const double seconds = median_seconds(21, [&] {
        const auto result = turgor::run_case(c);
        steps = result.trajectory->statistics.steps;
      });
      document["run_case"].push_back(
          {{"case", name}, {"rtol", std::stod(rtol)}, {"seconds", seconds}, {"steps", steps}});
    }
  }
  const auto report = [&](const char* what, const nlohmann::ordered_json& part) {
    document[what] = part;
    std::cout << what << ": " << part.dump(2) << std::endl;
  };
  report("flow", turgor::bench::flow_timings());
  report("ensemble", turgor::bench::ensemble_comparison());
  report("sweep", turgor::bench::sweep_timings(program, cases, scratch));
  std::filesystem::remove_all(scratch);
  const turgor::bench::ValveComparison valve = turgor::bench::valve_comparison();
  report("valve", valve.document);
  document["single"] = turgor::bench::work_precision();
  print_ratios(document["single"]);
  std::ofstream(argv[3]) << document.dump(2) << "\n";
  const std::filesystem::path folder = std::filesystem::absolute(argv[3]).parent_path();
  turgor::bench::draw_work_precision(document["single"], folder);
  turgor::bench::draw_valve(valve, folder);
}
