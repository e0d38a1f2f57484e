#include "lib/helm/behaviors/max_speed.h"

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer MaxSpeedBehavior::Run(const BehaviorInputs& inputs) {
  const Axis& axis = inputs.domain->speed_mps;
  if (axis.count == 0) return {};
  BehaviorAnswer answer =
      Prefer(inputs, {.speed = AtMost(axis, options_.max_speed, options_.tolerance)});
  Post(answer, options_.speed_slack_var, options_.max_speed - inputs.own.motion.speed_mps);
  return answer;
}

}  // namespace shoal
