#include "lib/helm/behaviors/constant_heading.h"

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer ConstantHeadingBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer = PreferCourse(
      {options_.heading, options_.peakwidth, options_.basewidth, options_.summitdelta}, inputs);
  const double mismatch_deg = std::abs(Wrap180(options_.heading - inputs.own.motion.heading_deg));
  Post(answer, options_.heading_mismatch_var, mismatch_deg);
  answer.completes = mismatch_deg <= options_.complete_thresh;
  return answer;
}

}  // namespace shoal
