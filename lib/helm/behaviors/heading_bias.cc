#include "lib/helm/behaviors/heading_bias.h"

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer HeadingBiasBehavior::Run(const BehaviorInputs& inputs) {
  constexpr double kQuarter_deg = 90;
  const double to_side_deg = options_.bias == "right" ? kQuarter_deg : -kQuarter_deg;
  return PreferCourse(
      {.summit = inputs.own.motion.heading_deg + to_side_deg, .width = kQuarter_deg}, inputs);
}

}  // namespace shoal
