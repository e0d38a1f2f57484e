#include "lib/helm/behaviors/shadow.h"

#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer ShadowBehavior::Run(const BehaviorInputs& inputs) {
  constexpr double kCourseDelta = 50;
  constexpr double kSpeedDelta = 10;
  BehaviorAnswer answer;
  const ContactView* contact = KnownContact(options_.contact, inputs, answer);
  if (contact == nullptr) return answer;
  const VesselMotion& theirs = contact->now;
  const RelativeGeometry geometry = GeometryOf(inputs.own.motion, theirs);
  if (options_.pwt_outer_dist <= 0 || geometry.range_m < options_.pwt_outer_dist) {
    answer =
        PreferBoth(inputs,
                   PeakOverCourse(theirs.heading_deg, options_.heading_peakwidth,
                                  options_.heading_basewidth, kCourseDelta),
                   PeakOverAxis(inputs.domain->speed_mps, theirs.speed_mps,
                                options_.speed_peakwidth, options_.speed_basewidth, kSpeedDelta),
                   50);
  }
  DescribeContact(options_.contact, *contact, geometry, "shadow", "", answer);
  return answer;
}

}  // namespace shoal
