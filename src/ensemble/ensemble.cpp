#include "turgor/ensemble/ensemble.hpp"

#include <map>

#include "kernel.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {

std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::scalar: return "scalar";
    case InstructionSet::avx2: return "avx2";
    case InstructionSet::avx512: return "avx512";
  }
  return "";
}

#if defined(TURGOR_SIMD_KERNELS)

InstructionSet best_instruction_set() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return InstructionSet::avx512;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::avx2;
  return InstructionSet::scalar;
}

namespace {
EnsembleKernel* kernel_for(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx2: return &ensemble_kernel_avx2;
    case InstructionSet::avx512: return &ensemble_kernel_avx512;
    case InstructionSet::scalar: break;
  }
  return &ensemble_kernel_scalar;
}
}  // namespace

#else

InstructionSet best_instruction_set() { return InstructionSet::scalar; }

namespace {
EnsembleKernel* kernel_for(InstructionSet) { return &ensemble_kernel_scalar; }
}  // namespace

#endif

namespace {

/// What the members in one call of a kernel share: the alternative of the material, and the closure's table.
using Kind = std::pair<std::size_t, const ForceTable*>;

struct Batch {
  std::vector<const Member*> members;
  std::vector<MemberSummary*> summaries;
};

}  // namespace

void integrate_ensemble(std::span<const Member> members, const SummaryOptions& options,
                        std::span<MemberSummary> summaries, InstructionSet set) {
  for (const Member& m : members) check_start(m.oscillator, 0.0, m.stretch, m.rate, m.end_time, m.options);
  std::map<Kind, Batch> batches;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Oscillator<double>& oscillator = members[i].oscillator;
    Batch& batch = batches[{oscillator.parameters().material.index(), oscillator.force_table()}];
    summaries[i] = {};
    batch.members.push_back(&members[i]);
    batch.summaries.push_back(&summaries[i]);
  }
  for (const auto& [kind, batch] : batches) kernel_for(set)(batch.members, options, batch.summaries);
}

}  // namespace turgor
