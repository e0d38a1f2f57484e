#include "lib/helm/behaviors/colregs.h"

#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/steadiness.h"
#include "lib/helm/colregs/preferences.h"

namespace shoal {

BehaviorAnswer ColregsBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  const ContactView* contact = KnownContact(options_.contact, inputs, answer);
  if (contact == nullptr) return answer;
  if (IsAboveOrBelow(options_.contact, inputs, *contact)) {
    role_ = {};
    const RelativeGeometry apart = GeometryOf(inputs.own.motion, contact->now);
    DescribeContact(options_.contact, *contact, apart, TextOf(role_), RuleOf(role_), answer);
    return answer;
  }
  const VesselMotion& own = inputs.own.motion;
  const double wider_m = options_.widen_per_s * contact->age_s;
  const double min_cpa_m = options_.min_util_cpa_dist + wider_m;
  const double max_cpa_m = options_.max_util_cpa_dist + wider_m;
  role_ = NextColregsState(role_, own, contact->now,
                           {.outer_m = options_.pwt_outer_dist,
                            .min_cpa_m = min_cpa_m,
                            .max_cpa_m = max_cpa_m,
                            .give_way_bow_m = options_.giveway_bow_dist,
                            .turn_radius_m = options_.turn_radius,
                            .min_dwell_s = options_.min_dwell,
                            .head_on_only = options_.headon_only,
                            .steady = options_.steady},
                           inputs.time_s);
  const RelativeGeometry geometry = GeometryOf(own, contact->now);
  const double relevance = RelevanceAt(geometry.range_m, options_.pwt_inner_dist,
                                       options_.pwt_outer_dist, options_.pwt_grade);
  if (relevance > 0 && role_.mode != ColregsMode::kNone) {
    answer.objective = ColregsObjective(role_, own, contact->now,
                                        {.min_cpa_m = min_cpa_m,
                                         .max_cpa_m = max_cpa_m,
                                         .horizon_s = options_.time_on_leg,
                                         .port_turns_ok = options_.pts_port_turns_ok,
                                         .steady = options_.steady},
                                        *inputs.domain);
    answer.relevance = relevance;
    if (role_.danger_s) {
      answer.relevance = 1;
      answer.urgency = kUrgencyInDanger;
    } else if (options_.steady && !role_.stands_on()) {
      PreferLastDecision(inputs, contact->now, min_cpa_m, max_cpa_m, answer);
    }
  }
  DescribeContact(options_.contact, *contact, geometry, TextOf(role_), RuleOf(role_), answer);
  return answer;
}

BehaviorAnswer ColregsBehavior::Idle(const BehaviorInputs&) {
  role_ = {};
  return {};
}

}  // namespace shoal
