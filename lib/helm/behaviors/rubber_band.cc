#include "lib/helm/behaviors/rubber_band.h"

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer RubberBandBehavior::Run(const BehaviorInputs& inputs) {
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  if (!begin_m_) begin_m_ = position_m;
  const Eigen::Vector2d point_m = options_.point.value_or(*begin_m_);
  const double distance_m = (point_m - position_m).norm();
  BehaviorAnswer answer;
  if (distance_m > options_.inner_radius) {
    const bool is_beyond = distance_m >= options_.outer_radius;
    const double share =
        (distance_m - options_.inner_radius) / (options_.outer_radius - options_.inner_radius);
    const double speed_mps = !is_beyond                 ? share * options_.outer_speed
                             : options_.extra_speed > 0 ? options_.extra_speed
                                                        : options_.outer_speed;
    answer = PreferBoth(
        inputs, PeakOverCourse(BearingDeg(position_m, point_m), 90, 90, 10),
        PeakOverAxis(inputs.domain->speed_mps, InDomain(inputs, speed_mps), 0.5, 2, 50), 50);
    if (is_beyond) {
      answer.urgency =
          1 + options_.stiffness * (distance_m - options_.outer_radius) / options_.outer_radius;
    }
  }
  answer.state = Whole(distance_m) + " m from its point";
  answer.view = {.points_m = {point_m}, .closed = false, .steers_for_m = point_m};
  Post(answer, "DIST_TO_STATION", Whole(distance_m));
  return answer;
}

BehaviorAnswer RubberBandBehavior::Idle(const BehaviorInputs&) {
  begin_m_.reset();
  return {};
}

}  // namespace shoal
