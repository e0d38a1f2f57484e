#include "lib/base/geometry/leg.h"

#include "lib/base/geometry/angles.h"

namespace shoal {

double Length(const Leg& leg) { return (leg.to_m - leg.from_m).norm(); }

double Course(const Leg& leg) { return HeadingOf(leg.to_m - leg.from_m); }

TrackPosition Project(const Leg& leg, const Eigen::Vector2d& position_m) {
  const double length_m = Length(leg);
  const Eigen::Vector2d ahead =
      length_m > 0 ? Eigen::Vector2d((leg.to_m - leg.from_m) / length_m) : Eigen::Vector2d(0, 1);
  const Eigen::Vector2d starboard(ahead.y(), -ahead.x());
  const Eigen::Vector2d offset_m = position_m - leg.from_m;
  return {.along_m = offset_m.dot(ahead), .cross_track_m = offset_m.dot(starboard)};
}

bool IsBeyond(const Leg& leg, const Eigen::Vector2d& position_m, double by_m) {
  return Project(leg, position_m).along_m > Length(leg) + by_m;
}

}  // namespace shoal
