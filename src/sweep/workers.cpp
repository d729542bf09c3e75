#include "workers.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <utility>

namespace turgor {

void compute_chunks(const Case& c, const SweepPlan& plan, int threads, const ChunkExchange& exchange) {
  using Finished = std::pair<std::uint64_t, std::string>;
  namespace tbb = oneapi::tbb;
  if (threads == 0) threads = tbb::info::default_concurrency();
  const auto count = static_cast<std::size_t>(threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  tbb::enumerable_thread_specific<ChunkRunner> runners(ChunkRunner(c, plan));  // each thread gets a copy

  const auto source = tbb::make_filter<void, std::uint64_t>(tbb::filter_mode::serial_in_order,
                                                            [&](tbb::flow_control& control) -> std::uint64_t {
                                                              const auto chunk = exchange.next();
                                                              if (!chunk) control.stop();
                                                              return chunk.value_or(0);
                                                            });
  const auto compute = tbb::make_filter<std::uint64_t, Finished>(
      tbb::filter_mode::parallel,
      [&](std::uint64_t chunk) -> Finished { return {chunk, runners.local().run(chunk).encode()}; });
  const auto sink = tbb::make_filter<Finished, void>(
      tbb::filter_mode::serial_out_of_order,
      [&](const Finished& finished) { exchange.finished(finished.first, finished.second); });
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_pipeline(2 * count, source & compute & sink); });
}

}  // namespace turgor
