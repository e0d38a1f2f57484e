#include "lib/helm/behaviors/station_keep.h"

#include <cmath>

#include "lib/helm/behaviors/preference.h"

namespace shoal {

double StationKeepBehavior::Speed(double distance_m) const {
  if (distance_m <= options_.inner_radius) return 0;
  if (distance_m > options_.outer_radius) return options_.transit_speed;
  return options_.outer_speed * (distance_m - options_.inner_radius) /
         (options_.outer_radius - options_.inner_radius);
}

// Awake until it is at its station, or has come no nearer for a while inside the radius: against a
// current it would never sleep again.
void StationKeepBehavior::Hibernate(double time_s, double distance_m) {
  constexpr double kHistory_s = 10;
  if (distance_m > options_.hibernation_radius) hibernates_ = false;
  if (hibernates_) return;
  past_.push_back({.time_s = time_s, .distance_m = distance_m});
  bool is_stuck = false;
  while (time_s - past_.front().time_s >= kHistory_s) {
    is_stuck = past_.front().distance_m <= distance_m;
    past_.pop_front();
  }
  const bool is_inside = distance_m <= options_.hibernation_radius;
  hibernates_ = distance_m <= options_.inner_radius || (is_inside && is_stuck);
  if (hibernates_) past_.clear();
}

BehaviorAnswer StationKeepBehavior::Idle(const BehaviorInputs&) {
  begun_s_.reset();
  hibernates_ = false;
  past_.clear();
  return {};
}

BehaviorAnswer StationKeepBehavior::Run(const BehaviorInputs& inputs) {
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  const bool begins = !begun_s_.has_value();
  if (begins) begun_s_ = inputs.time_s;
  const bool swings = inputs.time_s - *begun_s_ < options_.swing_time;
  if (begins || swings) activated_at_m_ = position_m;
  const bool is_here = options_.center_activate || !options_.station_pt;
  const Eigen::Vector2d station_m = is_here ? activated_at_m_ : *options_.station_pt;

  const double distance_m = (station_m - position_m).norm();
  if (options_.hibernation_radius >= 0) {
    Hibernate(inputs.time_s, distance_m);
  } else {
    hibernates_ = false;
  }
  BehaviorAnswer answer;
  if (!hibernates_) {
    answer = PreferBoth(
        inputs, PeakOverCourse(BearingDeg(position_m, station_m), 0, 180),
        PeakOverAxis(inputs.domain->speed_mps, InDomain(inputs, Speed(distance_m)), 0, 0.4), 50);
  }
  if (options_.hibernation_radius >= 0) {
    Post(answer, "PSKEEP_MODE", hibernates_ ? "HIBERNATING" : "SEEKING_STATION");
  }
  Post(answer, "DIST_TO_STATION", std::round(distance_m));
  answer.state = Whole(distance_m) + " m off" + (hibernates_ ? ", hibernates" : "");
  answer.view = {.points_m = {station_m}, .closed = false, .steers_for_m = station_m};
  return answer;
}

}  // namespace shoal
