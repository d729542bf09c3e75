#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "chunk.hpp"

namespace turgor {

/// Where chunks come from and where their results go. Calls of one function never overlap; a call of each may.
struct ChunkExchange {
  std::function<std::optional<std::uint64_t>()> next;
  std::function<void(std::uint64_t, const std::string&)> finished;
};

/// Computes chunks on several threads until there is none left.
/// @param threads  0: one for each core that this process may use
void compute_chunks(const Case& c, const SweepPlan& plan, int threads, const ChunkExchange& exchange);

}  // namespace turgor
