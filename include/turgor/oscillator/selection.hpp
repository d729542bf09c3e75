#pragma once
// Which terms of eq. (2.22) a simpler model drops, and how large they are.

#include <string>
#include <vector>

#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

/// The largest size, over a range of stretches, of a term that a model drops relative to the one it keeps.
struct DroppedTerm {
  std::string name;  ///< "solid inertia / balloon liquid inertia, deflating"
  double ratio;      ///< +infinity when nothing comparable is kept
};

/// Every term of (2.22) that `model` drops, compared with the kept term of the same kind and regime over
/// [least, greatest] stretch. Where no term of that kind is kept (centripetal, inflating without a channel) it is
/// compared with the inertia, rates of order one as in section 2.4.1. Empty for the full model; terms that are zero are
/// left out. With an exact closure the range must lie within closure_limits().
[[nodiscard]] std::vector<DroppedTerm> dropped_terms(Model model, const Parameters<double>& p, double least,
                                                     double greatest);

/// Simplest of the three models all of whose dropped terms are below `tolerance` over the range of stretches; the full
/// one if neither of the others is. (2.23) is considered only without a channel: it has no place for one.
[[nodiscard]] Model simplest_model(const Parameters<double>& p, double least, double greatest, double tolerance);

}  // namespace turgor
