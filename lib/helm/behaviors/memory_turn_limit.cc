#include "lib/helm/behaviors/memory_turn_limit.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

void MemoryTurnLimitBehavior::Remember(const BehaviorInputs& inputs) {
  memory_.push_back({.time_s = inputs.time_s, .heading_deg = inputs.own.motion.heading_deg});
  while (inputs.time_s - memory_.front().time_s > options_.memory_time) memory_.pop_front();
}

BehaviorAnswer MemoryTurnLimitBehavior::Run(const BehaviorInputs& inputs) {
  Remember(inputs);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Memory& memory : memory_) sum += UnitVector(DegToRad(memory.heading_deg));
  // Slow vessels turn less on the same helm; the range of turn is given for this speed and more.
  constexpr double kFullSpeed_mps = 1.5;
  const double part = std::clamp(inputs.own.motion.speed_mps / kFullSpeed_mps, 0.2, 1.0);
  const double mean_deg = RadToDeg(HeadingOf(sum));
  BehaviorAnswer answer =
      PreferCourse({.summit = mean_deg, .width = options_.turn_range * part, .delta = 0.2}, inputs);
  answer.state = "mean heading " + Whole(mean_deg);
  return answer;
}

BehaviorAnswer MemoryTurnLimitBehavior::Idle(const BehaviorInputs& inputs) {
  Remember(inputs);
  return {};
}

}  // namespace shoal
