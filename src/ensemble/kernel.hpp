#pragma once
// The SIMD kernels behind integrate_ensemble(): the same source, compiled once for each instruction set.

#include "turgor/ensemble/ensemble.hpp"

namespace turgor {

/// Integrates members of one material (the same alternative, for Ogden up to a common number of terms) and one table of
/// the closure, or none.
using EnsembleKernel = void(std::span<const Member* const> members, const SummaryOptions& options,
                            std::span<MemberSummary* const> summaries);

EnsembleKernel ensemble_kernel_scalar;
EnsembleKernel ensemble_kernel_avx2;
EnsembleKernel ensemble_kernel_avx512;

}  // namespace turgor
