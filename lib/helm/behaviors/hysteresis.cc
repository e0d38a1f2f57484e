#include "lib/helm/behaviors/hysteresis.h"

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

void HysteresisBehavior::Remember(const BehaviorInputs& inputs) {
  memory_.push_back({.time_s = inputs.time_s, .heading_deg = inputs.own.motion.heading_deg});
  while (inputs.time_s - memory_.front().time_s > options_.memory_time) memory_.pop_front();
}

double HysteresisBehavior::Deviation_deg() const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Memory& memory : memory_) sum += UnitVector(DegToRad(memory.heading_deg));
  const double mean_deg = RadToDeg(HeadingOf(sum));
  double squares = 0;
  for (const Memory& memory : memory_) {
    const double off_deg = Wrap180(memory.heading_deg - mean_deg);
    squares += off_deg * off_deg;
  }
  return std::sqrt(squares / static_cast<double>(memory_.size()));
}

BehaviorAnswer HysteresisBehavior::Run(const BehaviorInputs& inputs) {
  Remember(inputs);
  constexpr double kUnsteady_deg = 30;
  constexpr double kPercent = 100;
  const double steadiness = std::max(0.0, 1 - Deviation_deg() / kUnsteady_deg);
  const double window_deg =
      std::lerp(options_.min_heading_window, options_.max_heading_window, steadiness);
  BehaviorAnswer answer =
      PreferCourse({.summit = inputs.own.motion.heading_deg, .width = window_deg / 2}, inputs);
  answer.relevance = options_.max_window_utility / kPercent;
  answer.state = "window " + Whole(window_deg) + " deg";
  return answer;
}

BehaviorAnswer HysteresisBehavior::Idle(const BehaviorInputs& inputs) {
  Remember(inputs);
  return {};
}

}  // namespace shoal
