#include "sweeps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "stopwatch.hpp"

namespace turgor::bench {

namespace fs = std::filesystem;

namespace {

constexpr double members = 200.0 * 150.0;

/// The shipped case with 200 by 150 members instead of 60 by 50.
void write_finer(const fs::path& from, const fs::path& to) {
  std::stringstream text;
  text << std::ifstream(from).rdbuf();
  std::string content = text.str();
  for (const auto& [old, finer] : {std::pair{"n = 60", "n = 200"}, std::pair{"n = 50", "n = 150"}}) {
    const std::size_t at = content.find(old);
    if (at == std::string::npos) throw std::runtime_error(from.string() + " has no '" + old + "'");
    content.replace(at, std::string(old).size(), finer);
  }
  std::ofstream(to) << content;
}

bool succeeds(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

}  // namespace

nlohmann::ordered_json sweep_timings(const std::string& program, const fs::path& cases, const fs::path& scratch) {
  if (!succeeds(program + " sweep --help")) return nullptr;
  fs::create_directories(scratch);
  const fs::path study = scratch / "sweep.toml";
  write_finer(cases / "sweep-orifice-pressure.toml", study);
  const std::string sweep = program + " sweep " + study.string() + " -o " + (scratch / "sweep.nc").string() +
                            " --force --no-pictures --quiet --threads ";
  const std::string ranks = "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun -n ";
  struct Way {
    const char* name;
    std::string command;
    double seconds = std::numeric_limits<double>::infinity();
  };
  std::array<Way, 4> ways{{{"threads_1_per_second", sweep + "1"},
                           {"threads_2_per_second", sweep + "2"},
                           {"ranks_1_per_second", ranks + "1 " + sweep + "1"},
                           {"ranks_2_per_second", ranks + "2 " + sweep + "1"}}};
  const bool has_ranks = succeeds("command -v mpirun");
  constexpr int repetitions = 3;
  for (int i = 0; i < repetitions; ++i) {
    for (Way& way : ways) {
      if (way.command.starts_with(ranks) && !has_ranks) continue;
      way.seconds = std::min(way.seconds, wall_seconds([&] {
                               if (!succeeds(way.command)) throw std::runtime_error("failed: " + way.command);
                             }));
    }
  }
  nlohmann::ordered_json document{{"members", members}};
  for (const Way& way : ways) {
    document[way.name] =
        std::isfinite(way.seconds) ? nlohmann::ordered_json(members / way.seconds) : nlohmann::ordered_json(nullptr);
  }
  return document;
}

}  // namespace turgor::bench
