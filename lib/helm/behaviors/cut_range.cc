#include "lib/helm/behaviors/cut_range.h"

#include <algorithm>
#include <memory>

#include "lib/helm/behaviors/approach_function.h"
#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

namespace {

constexpr double kMaxPatience = 85;

/// Returns 0 up to inner, 1 from outer on.
double RelevanceBeyond(double range_m, double inner_m, double outer_m) {
  if (range_m >= outer_m) return 1;
  if (range_m <= inner_m) return 0;
  return (range_m - inner_m) / (outer_m - inner_m);
}

}  // namespace

BehaviorAnswer CutRangeBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  const ContactView* contact = KnownContact(options_.contact, inputs, answer);
  if (contact == nullptr) return answer;
  const VesselMotion& own = inputs.own.motion;
  const RelativeGeometry geometry = GeometryOf(own, contact->now);
  const bool pursued = pursues_;
  pursues_ = options_.giveup_dist <= 0 || geometry.range_m < options_.giveup_dist;
  const double relevance =
      RelevanceBeyond(geometry.range_m, options_.pwt_inner_dist, options_.pwt_outer_dist);
  if (pursues_ && relevance > 0 && geometry.range_m > 0) {
    const double patience = std::clamp(options_.patience, 0.0, kMaxPatience);
    answer = Prefer(
        inputs, {.coupled = std::make_shared<ApproachFunction>(
                     ApproachFunction::Target{.offset_m = contact->now.position_m - own.position_m,
                                              .velocity_mps = VelocityOf(contact->now),
                                              .horizon_s = options_.time_on_leg},
                     ApproachFunction::Shares{.closing = 100 - patience, .near = patience},
                     *inputs.domain)});
    answer.relevance = relevance;
  }
  Post(answer, "PURSUIT", pursues_ ? 1 : 0);
  if (pursues_ && !pursued) answer.flags.push_back("pursueflag");
  if (!pursues_ && pursued) answer.flags.push_back("giveupflag");
  DescribeContact(options_.contact, *contact, geometry, "cut_range", "", answer);
  return answer;
}

}  // namespace shoal
