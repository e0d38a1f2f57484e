#include "lib/mission/track/replay_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

double SecondsBetween(const ReplayFix& from, const ReplayFix& to) {
  return Seconds(to.time_us - from.time_us);
}

Eigen::Vector2d WayBetween(const ReplayFix& from, const ReplayFix& to) {
  return (to.position_m - from.position_m).head<2>();
}

}  // namespace

ReplayTrack::ReplayTrack(std::vector<ReplayFix> fixes, const ReplayColumns& columns)
    : fixes_(std::move(fixes)), columns_(columns) {
  SHOAL_CHECK(!fixes_.empty(), "a track has at least one fix");
  const auto late = std::adjacent_find(
      fixes_.begin(), fixes_.end(),
      [](const ReplayFix& a, const ReplayFix& b) { return a.time_us >= b.time_us; });
  SHOAL_CHECK(late == fixes_.end(), "the times of a track increase");
  FillInHeadings();
}

void ReplayTrack::FillInHeadings() {
  const Eigen::Vector2d still = Eigen::Vector2d::Zero();
  // The direction of the last way that had a length; at first that of the first one.
  Eigen::Vector2d last = still;
  for (size_t i = 0; i + 1 < fixes_.size() && last == still; ++i) {
    last = WayBetween(fixes_[i], fixes_[i + 1]);
  }
  for (size_t i = 0; i < fixes_.size(); ++i) {
    const Eigen::Vector2d next =
        i + 1 < fixes_.size() ? WayBetween(fixes_[i], fixes_[i + 1]) : still;
    const Eigen::Vector2d before = last.normalized();
    if (next != still) last = next;
    if (columns_.heading && std::isfinite(fixes_[i].heading_rad)) continue;
    const Eigen::Vector2d mean = before + last.normalized();
    // Of a vessel that turns straight back the mean has no direction.
    fixes_[i].heading_rad = HeadingOf(mean.norm() > 1e-9 ? mean : last);
  }
}

ReplayState ReplayTrack::At(int64_t time_us) const {
  const auto after =
      std::upper_bound(fixes_.begin(), fixes_.end(), time_us,
                       [](int64_t time, const ReplayFix& fix) { return time < fix.time_us; });
  if (after == fixes_.begin() || after == fixes_.end()) {
    const ReplayFix& end = after == fixes_.end() ? fixes_.back() : fixes_.front();
    const double heading_rad = WrapTwoPi(end.heading_rad);
    return {.position_m = end.position_m, .heading_rad = heading_rad, .course_rad = heading_rad};
  }
  const ReplayFix& from = *(after - 1);
  const ReplayFix& to = *after;
  const double length_s = SecondsBetween(from, to);
  const double share = Seconds(time_us - from.time_us) / length_s;
  const Eigen::Vector3d way_m = to.position_m - from.position_m;
  const double turn_rad = WrapPi(to.heading_rad - from.heading_rad);
  ReplayState state;
  state.position_m = from.position_m + share * way_m;
  state.heading_rad = WrapTwoPi(from.heading_rad + share * turn_rad);
  state.turn_radps = turn_rad / length_s;
  state.descent_mps = way_m.z() / length_s;
  const double way_mps = way_m.head<2>().norm() / length_s;
  const bool has_speed =
      columns_.speed && std::isfinite(from.speed_mps) && std::isfinite(to.speed_mps);
  state.speed_mps = has_speed ? std::lerp(from.speed_mps, to.speed_mps, share) : way_mps;
  state.course_rad = way_mps > 0 ? HeadingOf(way_m.head<2>()) : state.heading_rad;
  return state;
}

}  // namespace shoal
