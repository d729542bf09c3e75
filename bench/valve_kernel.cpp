// Compiled once per instruction set, with TURGOR_KERNEL naming the function.

#if TURGOR_KERNEL_LANES > 1
#include "ensemble/batch.hpp"
#endif

#include "valve.hpp"

namespace turgor::bench {

namespace {
#if TURGOR_KERNEL_LANES > 1
using Value = xsimd::batch<double>;
#else
using Value = double;
#endif
static_assert(Lanes<Value>::width == TURGOR_KERNEL_LANES);
}  // namespace

void TURGOR_KERNEL(std::span<const double> flows, const ValveTask& task, std::span<double> records) {
  if (!flows.empty()) ValveLanes<Value>(flows, task, records).run();
}

}  // namespace turgor::bench
