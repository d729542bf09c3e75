// Compiled once per instruction set, with TURGOR_KERNEL naming the function.

#include "ensemble/kernel_value.hpp"
// the above must come first
#include "valve.hpp"

namespace turgor::bench {

void TURGOR_KERNEL(std::span<const double> flows, const ValveTask& task, std::span<double> records) {
  if (!flows.empty()) ValveLanes<KernelValue>(flows, task, records).run();
}

}  // namespace turgor::bench
