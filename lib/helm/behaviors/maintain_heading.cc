#include "lib/helm/behaviors/maintain_heading.h"

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer MaintainHeadingBehavior::Run(const BehaviorInputs& inputs) {
  if (!heading_deg_) heading_deg_ = inputs.own.motion.heading_deg;
  BehaviorAnswer answer = PreferCourse(
      {*heading_deg_, options_.peakwidth, options_.basewidth, options_.summitdelta}, inputs);
  answer.state = "heading " + Whole(*heading_deg_);
  return answer;
}

BehaviorAnswer MaintainHeadingBehavior::Idle(const BehaviorInputs&) {
  heading_deg_.reset();
  return {};
}

}  // namespace shoal
