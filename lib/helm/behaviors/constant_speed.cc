#include "lib/helm/behaviors/constant_speed.h"

#include <cmath>

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer ConstantSpeedBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer = PreferSpeed(
      {options_.speed, options_.peakwidth, options_.basewidth, options_.summitdelta}, inputs);
  Post(answer, options_.speed_mismatch_var, std::abs(options_.speed - inputs.own.motion.speed_mps));
  return answer;
}

}  // namespace shoal
