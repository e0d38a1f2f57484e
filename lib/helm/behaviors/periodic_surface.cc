#include "lib/helm/behaviors/periodic_surface.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

void PeriodicSurfaceBehavior::Enter(State state, double time_s) {
  state_ = state;
  since_s_ = time_s;
}

void PeriodicSurfaceBehavior::Update(const BehaviorInputs& inputs) {
  const double time_s = inputs.time_s;
  if (!since_s_ || IsFresh(inputs, options_.mark_variable)) Enter(State::kWaiting, time_s);
  if (state_ == State::kWaiting && time_s - *since_s_ >= options_.period) {
    Enter(State::kAscending, time_s);
    start_depth_m_ = inputs.own.depth_m;
    start_speed_mps_ =
        options_.ascent_speed >= 0 ? options_.ascent_speed : inputs.own.motion.speed_mps;
  }
  const double surface_m = std::max(options_.zero_speed_depth, kSurface_m);
  if (state_ == State::kAscending && inputs.own.depth_m <= surface_m) {
    Enter(State::kAtSurface, time_s);
  }
  if (state_ == State::kAtSurface && time_s - *since_s_ >= options_.max_time_at_surface) {
    Enter(State::kWaiting, time_s);
  }
}

double PeriodicSurfaceBehavior::AscentSpeed(double depth_m) const {
  const double above_m = start_depth_m_ - options_.zero_speed_depth;
  if (above_m <= 0) return 0;
  const double part = std::clamp((depth_m - options_.zero_speed_depth) / above_m, 0.0, 1.0);
  if (options_.ascent_grade == "fullspeed") return part > 0 ? start_speed_mps_ : 0;
  const double power = options_.ascent_grade == "quadratic" ? 2
                       : options_.ascent_grade == "quasi"   ? 1.5
                                                            : 1;
  return start_speed_mps_ * Pow(part, power);
}

BehaviorAnswer PeriodicSurfaceBehavior::Run(const BehaviorInputs& inputs) {
  const Domain& domain = *inputs.domain;
  if (domain.depth_m.count == 0) return WarnOfNoDepth();
  Update(inputs);
  BehaviorAnswer answer;
  if (state_ != State::kWaiting) {
    const double speed_mps = state_ == State::kAscending ? AscentSpeed(inputs.own.depth_m) : 0;
    answer =
        Prefer(inputs, {.speed = PeakOverAxis(domain.speed_mps, InDomain(inputs, speed_mps), 0, 2),
                        .depth = AtMost(domain.depth_m, 0, domain.depth_m.Last())});
  }
  const double in_state_s = inputs.time_s - *since_s_;
  Post(answer, options_.pending_status_var,
       state_ == State::kWaiting ? std::ceil(options_.period - in_state_s) : 0);
  Post(answer, options_.atsurface_status_var,
       state_ == State::kAtSurface ? std::floor(in_state_s) : 0);
  Post(answer, "PERIODIC_ASCEND", state_ == State::kAscending ? "true" : "false");
  answer.state = state_ == State::kWaiting     ? "waiting"
                 : state_ == State::kAscending ? "ascending"
                                               : "at_surface";
  return answer;
}

BehaviorAnswer PeriodicSurfaceBehavior::Idle(const BehaviorInputs& inputs) {
  if (!since_s_ || IsFresh(inputs, options_.mark_variable)) Enter(State::kWaiting, inputs.time_s);
  return {};
}

}  // namespace shoal
