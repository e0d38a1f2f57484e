#include "lib/helm/behaviors/approach_function.h"

#include <algorithm>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kLeastTop_mps = 1e-6;  // A domain of speed 0 alone.

}  // namespace

ApproachFunction::ApproachFunction(const Target& target, const Shares& shares, const Domain& domain)
    : cpa_(target.offset_m, target.velocity_mps, target.horizon_s, domain),
      closing_(RadToDeg(HeadingOf(target.offset_m)), domain),
      shares_(shares),
      top_mps_(std::max(domain.speed_mps.Last(), kLeastTop_mps)) {
  SHOAL_CHECK(cpa_.range_m() > 0, "a point to approach is somewhere else");
}

double ApproachFunction::At(int course, int speed) const {
  return shares_.closing * (closing_.At(course, speed) / top_mps_ + 1) / 2 +
         shares_.near * (1 - cpa_.At(course, speed) / cpa_.range_m());
}

CourseSpeedFunction::Range ApproachFunction::Bound(const GridBox& box) const {
  const Range closing = closing_.Bound(box);
  const Range cpa_m = cpa_.Bound(box);
  const auto value = [&](double closing_mps, double distance_m) {
    return shares_.closing * (closing_mps / top_mps_ + 1) / 2 +
           shares_.near * (1 - distance_m / cpa_.range_m());
  };
  constexpr double kRounding = 1e-9;
  return {.min = value(closing.min, cpa_m.max) - kRounding,
          .max = value(closing.max, cpa_m.min) + kRounding};
}

}  // namespace shoal
