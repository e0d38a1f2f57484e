#include "lib/helm/behaviors/steadiness.h"

#include <algorithm>
#include <cstddef>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kShareOfLast = 0.3;
constexpr double kJump_deg = 45;
constexpr double kJump_mps = 1;
/// Of the way from the least to the farthest distance that counts.
constexpr double kGoodEnough = 0.6;

/// 100 without a difference, 0 at a jump and beyond.
double KeptValue(double difference, double jump) {
  const double share = difference / jump;
  return 100 * (1 - std::min(1.0, share * share));
}

}  // namespace

void PreferLastDecision(const BehaviorInputs& inputs, const VesselMotion& contact, double min_cpa_m,
                        double max_cpa_m, BehaviorAnswer& answer) {
  Objective& objective = *answer.objective;
  if (!inputs.last_course_deg || !inputs.last_speed_mps || objective.scale == 0) return;
  VesselMotion decided = inputs.own.motion;
  const bool opens = GeometryOf(decided, contact).range_rate_mps >= 0;
  decided.heading_deg = *inputs.last_course_deg;
  decided.speed_mps = *inputs.last_speed_mps;
  const RelativeGeometry next = GeometryOf(decided, contact);
  if (next.cpa_m < min_cpa_m + kGoodEnough * (max_cpa_m - min_cpa_m)) return;
  if (opens && next.range_rate_mps >= 0) return;

  const Axis& axis = inputs.domain->speed_mps;
  if (objective.course.empty()) objective.course.assign(Domain::kNumCourses, 0);
  if (objective.speed.empty()) objective.speed.assign(static_cast<size_t>(axis.count), 0);
  objective.offset *= 1 - kShareOfLast;
  objective.scale *= 1 - kShareOfLast;
  const double half = kShareOfLast / 2 / objective.scale;
  for (int i = 0; i < Domain::kNumCourses; ++i) {
    const double kept = KeptValue(Wrap180(i - decided.heading_deg), kJump_deg);
    objective.course[static_cast<size_t>(i)] += half * kept;
  }
  for (int i = 0; i < axis.count; ++i) {
    const double kept = KeptValue(axis.At(i) - decided.speed_mps, kJump_mps);
    objective.speed[static_cast<size_t>(i)] += half * kept;
  }
  answer.urgency = 1 / (1 - kShareOfLast);
}

}  // namespace shoal
