#include "lib/helm/behaviors/min_altitude.h"

#include <algorithm>

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer MinAltitudeBehavior::Run(const BehaviorInputs& inputs) {
  const Axis& axis = inputs.domain->depth_m;
  if (axis.count == 0) return WarnOfNoDepth();
  BehaviorAnswer answer;
  if (inputs.own.altitude_m < 0) {
    (options_.missing_altitude_critical ? answer.error : answer.warning) =
        "the altitude is not known";
    return answer;
  }
  const double deepest_m =
      std::max(0.0, inputs.own.depth_m + inputs.own.altitude_m - options_.min_altitude);
  answer = Prefer(inputs, {.depth = AtMost(axis, deepest_m, options_.tolerance)});
  answer.state = "deepest " + Whole(deepest_m) + " m";
  return answer;
}

}  // namespace shoal
