#pragma once

#include <cmath>
#include <string_view>

#include "turgor/material/material.hpp"

namespace turgor {

/// Plausible constants for every entry of the catalogue; a new material must be added here to pass.
inline MaterialValues sample_constants(std::string_view name) {
  if (name == "mooney-rivlin") return {{"s1", {1.5e6}}, {"s2", {1.5e5}}};
  if (name == "neo-hookean") return {{"mu", {4e5}}};
  if (name == "yeoh") return {{"c1", {2e5}}, {"c2", {-1.2e3}}, {"c3", {40}}};
  if (name == "gent") return {{"mu", {4e5}}, {"jm", {97.2}}};
  if (name == "gent-gent") return {{"mu", {3e5}}, {"jm", {77.9}}, {"c2", {1.5e5}}};
  // Ogden's (1972) fit of Treloar's rubber
  if (name == "ogden") return {{"mu", {6.3e5, 1.2e3, -1e4}}, {"alpha", {1.3, 5.0, -2.0}}};
  if (name == "fung") return {{"mu", {5e4}}, {"b", {0.8}}};
  if (name == "arruda-boyce") return {{"mu", {3e5}}, {"lambda_m", {5.0}}};
  if (name == "table") {
    MaterialValues points{{"table.stretch", {}}, {"table.stress", {}}};
    for (int i = -12; i <= 120; ++i) {
      const double l = 1 + i * 0.05;
      points["table.stretch"].push_back(l);
      points["table.stress"].push_back(i == 0 ? 0.0
                                              : 2e5 * (l - std::pow(l, -5)) + 2e4 * (l * l * l - std::pow(l, -3)));
    }
    return points;
  }
  return {};
}

/// Those whose energy is known at two different stretches.
inline std::vector<MaterialEntry> materials_of_two_stretches() {
  std::vector<MaterialEntry> all = catalogue();
  std::erase_if(all, [](const MaterialEntry& entry) { return entry.name == "table"; });
  return all;
}

}  // namespace turgor
