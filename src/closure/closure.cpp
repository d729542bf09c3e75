#include "turgor/closure/closure.hpp"

#include "turgor/base/errors.hpp"
#include "turgor/closure/calibration.hpp"

namespace turgor {

const ForceTable* force_table(Closure closure, bool channel, const ForceTable* outflow) {
  if (closure == Closure::potential) return &ForceTable::uniform();
  if (closure == Closure::calibrated) return &calibrated_force_table(channel);
  if (closure != Closure::profile) return nullptr;
  if (outflow == nullptr) {
    throw InvalidInput("model.closure", "profile", "no outflow profile is given",
                       "use \"potential\" for uniform outflow");
  }
  return outflow;
}

}  // namespace turgor
