#include "lib/helm/behaviors/full_stop.h"

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer FullStopBehavior::Run(const BehaviorInputs& inputs) {
  return PreferSpeed({.summit = 0, .base = inputs.domain->speed_mps.Last()}, inputs);
}

}  // namespace shoal
