#include "lib/helm/behaviors/zigzag.h"

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer ZigzagBehavior::Idle(const BehaviorInputs&) {
  *this = ZigzagBehavior(options_);
  return {};
}

void ZigzagBehavior::StartLeg(BehaviorAnswer& answer) {
  answer.flags.emplace_back(side_ < 0 ? "zigflag" : "zagflag");
}

void ZigzagBehavior::Begin(const BehaviorInputs& inputs, BehaviorAnswer& answer) {
  const VesselMotion& own = inputs.own.motion;
  is_begun_ = true;
  stem_deg_ = options_.stem_on_active ? own.heading_deg : options_.stem_hdg;
  speed_mps_ = options_.speed_on_active ? own.speed_mps : options_.speed;
  begun_at_m_ = own.position_m;
  side_ = options_.zig_first == "port" ? -1 : 1;
  StartLeg(answer);
}

double ZigzagBehavior::SetCourse() const { return stem_deg_ + side_ * options_.zig_angle; }

BehaviorAnswer ZigzagBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  if (is_done_) return answer;
  if (!is_begun_) Begin(inputs, answer);
  const VesselMotion& own = inputs.own.motion;
  // Positive: still to turn.
  const double to_turn_deg = side_ * Wrap180(SetCourse() - own.heading_deg);
  if (to_turn_deg <= options_.hdg_thresh) {
    ++num_legs_;
    side_ = -side_;
    is_done_ = options_.max_zig_legs > 0 && num_legs_ >= options_.max_zig_legs;
    if (!is_done_) StartLeg(answer);
  }
  const double along_m = (own.position_m - begun_at_m_).dot(UnitVector(DegToRad(stem_deg_)));
  if (options_.max_stem_odo >= 0 && along_m >= options_.max_stem_odo) is_done_ = true;
  if (is_done_) {
    answer.completes = true;
    return answer;
  }
  const double course_deg =
      options_.fierce_zigging ? own.heading_deg + side_ * options_.zig_angle : SetCourse();
  BehaviorAnswer preference =
      PreferBoth(inputs, PeakOverCourse(course_deg, 0, 180),
                 TransitSpeed(inputs, InDomain(inputs, speed_mps_), 85), 50);
  preference.flags = answer.flags;
  preference.state = "leg " + std::to_string(num_legs_) + (side_ < 0 ? ", port" : ", starboard");
  return preference;
}

}  // namespace shoal
