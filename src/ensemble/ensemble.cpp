#include "turgor/ensemble/ensemble.hpp"

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

void integrate_ensemble(std::span<const Member> members, const SummaryOptions& options,
                        std::span<MemberSummary> summaries, InstructionSet set) {
  for (const Member& m : members) check_start(m.oscillator, 0.0, m.stretch, m.rate, m.end_time, m.options);
  std::array<std::vector<const Member*>, std::variant_size_v<Material<double>>> by_material;
  std::array<std::vector<MemberSummary*>, std::variant_size_v<Material<double>>> results;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::size_t material = members[i].oscillator.parameters().material.index();
    summaries[i] = {};
    by_material[material].push_back(&members[i]);
    results[material].push_back(&summaries[i]);
  }
  for (std::size_t i = 0; i < by_material.size(); ++i) kernel_for(set)(by_material[i], options, results[i]);
}

}  // namespace turgor
