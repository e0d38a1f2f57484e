#include "lib/helm/behaviors/constant_depth.h"

#include <cmath>

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer ConstantDepthBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer = PreferDepth(
      {options_.depth, options_.peakwidth, options_.basewidth, options_.summitdelta}, inputs);
  Post(answer, options_.depth_mismatch_var, std::abs(options_.depth - inputs.own.depth_m));
  return answer;
}

}  // namespace shoal
