#include "lib/helm/behaviors/fixed_turn.h"

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer FixedTurnBehavior::Idle(const BehaviorInputs&) {
  *this = FixedTurnBehavior(options_);
  return {};
}

BehaviorAnswer FixedTurnBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  if (is_done_) return answer;
  const VesselMotion& own = inputs.own.motion;
  const double side = options_.turn_dir == "port" ? -1 : 1;
  if (!begun_s_) {
    begun_s_ = inputs.time_s;
    last_ = own;
  }
  const double turning_s = inputs.time_s - *begun_s_ - std::fmax(0, options_.turn_delay);
  if (turning_s < 0) {
    last_ = own;
    answer.state = "waits";
    return answer;
  }
  if (turned_deg_ == 0 && gone_m_ == 0) {
    speed_mps_ = options_.speed < 0 ? last_.speed_mps : options_.speed;
  }
  turned_deg_ += side * Wrap180(own.heading_deg - last_.heading_deg);
  gone_m_ += (own.position_m - last_.position_m).norm();
  last_ = own;
  is_done_ =
      turned_deg_ >= options_.fix_turn || (options_.timeout >= 0 && turning_s >= options_.timeout);
  if (is_done_) {
    answer.completes = true;
  } else {
    answer = PreferBoth(inputs, PeakOverCourse(own.heading_deg + side * options_.mod_hdg, 0, 180),
                        TransitSpeed(inputs, InDomain(inputs, speed_mps_), 85), 50);
  }
  if (!options_.radius_rep_var.empty() && turned_deg_ > 0) {
    Post(answer, options_.radius_rep_var, gone_m_ / DegToRad(turned_deg_));
  }
  answer.state = "turned by " + Whole(turned_deg_);
  return answer;
}

}  // namespace shoal
