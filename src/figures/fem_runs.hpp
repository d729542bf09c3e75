#pragma once
// Runs of finite elements that figures show beside the model.

#include <optional>
#include <vector>

#include "studio.hpp"
#include "turgor/run/fem_history.hpp"

namespace turgor {

/// What finite elements have of each case, in the folders that `turgor fem` would give them; says in the caption what
/// there is.
/// @param read   read_fem_history() or read_fem_response()
/// @param drawn  "Solid black"
template <class Run>
[[nodiscard]] std::vector<std::optional<Run>> fem_runs(Studio& studio, const std::vector<Case>& cases,
                                                       Run (*read)(const Case&, const std::filesystem::path&),
                                                       const std::string& drawn) {
  std::vector<std::optional<Run>> runs(cases.size());
  if (studio.fem().empty()) return runs;
  std::string missing;
  std::string partial;
  const auto list = [](std::string& names, const std::string& name) {
    names += (names.empty() ? "`" : ", `") + name + "`";
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string name = cases[i].file.stem().string() + ".fem";
    std::error_code error;
    if (!std::filesystem::is_directory(studio.fem() / name, error)) {
      list(missing, name);
      continue;
    }
    runs[i] = read(cases[i], studio.fem() / name);
    if (!runs[i]->warnings.empty()) list(partial, name);
  }
  studio.say(drawn + ": finite elements.");
  if (!missing.empty()) studio.say("There are none of " + missing + ".");
  if (!partial.empty()) studio.say("Not complete: " + partial + ".");
  return runs;
}

}  // namespace turgor
