#include "lib/helm/behaviors/max_depth.h"

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer MaxDepthBehavior::Run(const BehaviorInputs& inputs) {
  const Axis& axis = inputs.domain->depth_m;
  if (axis.count == 0) return WarnOfNoDepth();
  BehaviorAnswer answer =
      Prefer(inputs, {.depth = AtMost(axis, options_.max_depth, options_.tolerance)});
  Post(answer, options_.depth_slack_var, options_.max_depth - inputs.own.depth_m);
  return answer;
}

}  // namespace shoal
