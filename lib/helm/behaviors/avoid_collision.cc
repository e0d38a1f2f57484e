#include "lib/helm/behaviors/avoid_collision.h"

#include <memory>

#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/preference.h"
#include "lib/helm/behaviors/steadiness.h"
#include "lib/helm/colregs/preferences.h"
#include "lib/helm/decision/cpa_function.h"

namespace shoal {

BehaviorAnswer AvoidCollisionBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  const ContactView* contact = KnownContact(options_.contact, inputs, answer);
  if (contact == nullptr) return answer;
  const RelativeGeometry geometry = GeometryOf(inputs.own.motion, contact->now);
  const double relevance = RelevanceAt(geometry.range_m, options_.pwt_inner_dist,
                                       options_.pwt_outer_dist, options_.pwt_grade);
  const bool is_below =
      options_.collision_depth >= 0 && inputs.own.depth_m > options_.collision_depth;
  if (relevance > 0 && !is_below && !IsAboveOrBelow(options_.contact, inputs, *contact)) {
    const double wider_m = options_.widen_per_s * contact->age_s;
    const double min_cpa_m = options_.min_util_cpa_dist + wider_m;
    const double max_cpa_m = options_.max_util_cpa_dist + wider_m;
    const bool is_danger = options_.steady && IsDanger(geometry, min_cpa_m, max_cpa_m);
    const CpaUtility utility = is_danger ? CpaUtilityInDanger(min_cpa_m)
                                         : CpaUtilityAt(geometry.range_m, min_cpa_m, max_cpa_m);
    const CpaGrid cpa(contact->now.position_m - inputs.own.motion.position_m,
                      VelocityOf(contact->now), options_.time_on_leg, *inputs.domain);
    answer = Prefer(inputs, {.coupled = std::make_shared<CpaFunction>(cpa, utility)});
    answer.relevance = is_danger ? 1 : relevance;
    if (is_danger) {
      answer.urgency = kUrgencyInDanger;
    } else if (options_.steady && answer.objective) {
      PreferLastDecision(inputs, contact->now, min_cpa_m, max_cpa_m, answer);
    }
  }
  DescribeContact(options_.contact, *contact, geometry, "avoid", "", answer);
  return answer;
}

}  // namespace shoal
